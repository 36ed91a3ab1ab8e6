// SPDX-License-Identifier: MIT
//
// Content of a store, read through SQLite and the schema alone, as the report does. Readable while a
// sweep writes.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace edgewise::cli_test {

/// The rows of a query, each as one text of all its columns, every digit kept; none while there is no such
/// store.
[[nodiscard]] std::vector<std::string> rows_of(const std::filesystem::path& store, const std::string& sql);

/// Runs statements that return no rows.
void change(const std::filesystem::path& store, const std::string& sql);

/// Every round with its figures.
[[nodiscard]] std::vector<std::string> rounds_in(const std::filesystem::path& store);

/// "HASH PROBE.NAME" -> value, the very double; of figures that were measured.
[[nodiscard]] std::map<std::string, double> figures_in(const std::filesystem::path& store);

}  // namespace edgewise::cli_test
