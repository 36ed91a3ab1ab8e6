// SPDX-License-Identifier: MIT
//
// The machine as JSON: what `edgewise machine --json` prints and what a store keeps with each build.
//
//     {"cpu":{...},"caches":[{...}],"cores":[{"processors":"0-15","allowed","caches","bind"}],"binding":advice,
//      "page_bytes",...,"counters":[{"event","status","by","encoding","level","meaning","unit","value","errno",
//      "reason","remedy"}],"counted_over":text,"unreadable":{"governor":"why it is null",...}}
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "edgewise/measure/counters/count_pass.hpp"
#include "edgewise/measure/machine/machine.hpp"

namespace edgewise::measure {

/// JSON record of this machine, read now.
[[nodiscard]] nlohmann::json machine_json();

[[nodiscard]] nlohmann::json machine_json(const Machine& machine, const std::vector<CounterRecord>& counters);

/// The part that makes two machines the same one, as text to hash: without the counts, which differ from run
/// to run, the memory, which differs from boot to boot, and the cores that the process is bound to, except
/// for their caches.
[[nodiscard]] std::string machine_identity(const nlohmann::json& machine);

}  // namespace edgewise::measure
