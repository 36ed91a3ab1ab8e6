// SPDX-License-Identifier: MIT
#include "sweep_store.hpp"

#include <sqlite3.h>

#include <memory>

namespace edgewise::cli_test {

std::vector<std::string> rows_of(const std::filesystem::path& store, const std::string& sql) {
    std::vector<std::string> rows;
    sqlite3* opened = nullptr;
    const bool open = sqlite3_open_v2(store.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK;
    const std::unique_ptr<sqlite3, decltype(&sqlite3_close)> database(opened, sqlite3_close);
    if (!open) return rows;
    sqlite3_busy_timeout(opened, 5000);
    sqlite3_stmt* prepared = nullptr;
    if (sqlite3_prepare_v2(opened, sql.c_str(), -1, &prepared, nullptr) != SQLITE_OK) return rows;
    const std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> statement(prepared, sqlite3_finalize);
    while (sqlite3_step(prepared) == SQLITE_ROW) {
        std::string row;
        for (int column = 0; column < sqlite3_column_count(prepared); ++column) {
            const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(prepared, column));
            row += (column > 0 ? "|" : "") + std::string(text == nullptr ? "null" : text);
        }
        rows.push_back(row);
    }
    return rows;
}

std::vector<std::string> rounds_in(const std::filesystem::path& store) {
    return rows_of(store, "select * from round order by build, hash, number");
}

}  // namespace edgewise::cli_test
