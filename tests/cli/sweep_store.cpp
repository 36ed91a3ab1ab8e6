// SPDX-License-Identifier: MIT
#include "sweep_store.hpp"

#include <sqlite3.h>

#include <memory>
#include <stdexcept>

namespace edgewise::cli_test {

namespace {

/// Calls `take` with the prepared statement for every row of the query; for none while there is no such
/// store.
template <class Take>
void for_each_row(const std::filesystem::path& store, const std::string& sql, const Take& take) {
    sqlite3* opened = nullptr;
    const bool open = sqlite3_open_v2(store.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK;
    const std::unique_ptr<sqlite3, decltype(&sqlite3_close)> database(opened, sqlite3_close);
    if (!open) return;
    sqlite3_busy_timeout(opened, 5000);
    sqlite3_stmt* prepared = nullptr;
    if (sqlite3_prepare_v2(opened, sql.c_str(), -1, &prepared, nullptr) != SQLITE_OK) return;
    const std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> statement(prepared, sqlite3_finalize);
    while (sqlite3_step(prepared) == SQLITE_ROW) take(prepared);
}

std::string text_in(sqlite3_stmt* row, int column) {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(row, column));
    return text == nullptr ? "null" : text;
}

}  // namespace

std::vector<std::string> rows_of(const std::filesystem::path& store, const std::string& sql) {
    std::vector<std::string> rows;
    for_each_row(store, sql, [&](sqlite3_stmt* row) {
        std::string text;
        for (int column = 0; column < sqlite3_column_count(row); ++column)
            text += (column > 0 ? "|" : "") + text_in(row, column);
        rows.push_back(text);
    });
    return rows;
}

void change(const std::filesystem::path& store, const std::string& sql) {
    sqlite3* opened = nullptr;
    const int code = sqlite3_open_v2(store.c_str(), &opened, SQLITE_OPEN_READWRITE, nullptr);
    const std::unique_ptr<sqlite3, decltype(&sqlite3_close)> database(opened, sqlite3_close);
    if (code != SQLITE_OK || sqlite3_exec(opened, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
        throw std::runtime_error(sqlite3_errmsg(opened));
}

std::map<std::string, double> figures_in(const std::filesystem::path& store) {
    std::map<std::string, double> values;
    for_each_row(store, "select hash, probe, name, value from figure where value is not null",
                 [&](sqlite3_stmt* row) {
                     values[text_in(row, 0) + " " + text_in(row, 1) + "." + text_in(row, 2)] =
                         sqlite3_column_double(row, 3);
                 });
    return values;
}

std::vector<std::string> rounds_in(const std::filesystem::path& store) {
    return rows_of(store, "select * from round order by build, hash, number");
}

}  // namespace edgewise::cli_test
