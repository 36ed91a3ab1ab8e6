// SPDX-License-Identifier: MIT
//
// What one machine says of layouts, to be given to others: processor, caches, and time ratios with their
// intervals. It holds no absolute time, no name of a host, user or file, and nothing of bodies and scenes
// that do not come with Edgewise.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// One cell: a table's time per query over the baseline's.
struct RecordRow {
    std::string scene, parameters;  ///< the latter as canonical JSON
    std::string shape, algorithm, table;
    double ratio = 0, low = 0, high = 0;  ///< median and its interval; equal where it was modelled
    std::optional<double> bytes_per_edge;

    /// What tables compete in.
    [[nodiscard]] std::string question() const;
};

struct MachineRecord {
    std::string machine;    ///< the processor's name, or a model's
    bool is_model = false;  ///< times are those of modelled misses alone; no such machine was measured
    nlohmann::json cpu, caches;
    std::vector<RecordRow> rows;
};

/// Of what a sweep measured. Throws std::runtime_error, one line, where nothing of it was timed.
[[nodiscard]] MachineRecord measured_record(const ReportData& data);

/// Of a machine whose caches the sweep modelled: modelled memory time over that of the same algorithm on
/// `modelled_baseline`. Throws std::runtime_error, one line, where the store has no such figures.
[[nodiscard]] MachineRecord modelled_record(const ReportData& data, const std::string& machine);
inline constexpr std::string_view modelled_baseline = "aos_f64";

[[nodiscard]] nlohmann::ordered_json to_json(const MachineRecord& record);

/// Throws std::runtime_error, one line that begins with `where`, for what is no record.
[[nodiscard]] MachineRecord parse_record(const std::string& text, const std::string& where);

}  // namespace edgewise::reports
