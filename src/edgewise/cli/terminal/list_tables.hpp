// SPDX-License-Identifier: MIT
//
// What `edgewise list` prints for people: tables no wider than a page, from the entries that --json prints.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace edgewise::cli {

/// The entries of `edgewise list what`.
[[nodiscard]] std::string list_text(const std::string& what, const nlohmann::json& entries);

}  // namespace edgewise::cli
