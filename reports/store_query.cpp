// SPDX-License-Identifier: MIT
//
// See store_query.hpp. Every failure becomes one line that names the file.
#include "edgewise/reports/store_query.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <stdexcept>

namespace edgewise::reports {

ReadOnlyDatabase::ReadOnlyDatabase(const std::string& path) : path_(path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
        throw std::runtime_error(
            fmt::format("no results store at {}: run a sweep first, or name the store", path));
    if (sqlite3_open_v2(path.c_str(), &handle_, SQLITE_OPEN_READONLY, nullptr) != SQLITE_OK) {
        const std::string why = sqlite3_errmsg(handle_);
        sqlite3_close(handle_);
        throw std::runtime_error(fmt::format("cannot open the results store {}: {}", path, why));
    }
    // A sweep may be writing: its transactions are short.
    sqlite3_busy_timeout(handle_, 5000);
}

ReadOnlyDatabase::~ReadOnlyDatabase() { sqlite3_close(handle_); }

StoreQuery::StoreQuery(const ReadOnlyDatabase& database, const std::string& sql) : database_(database) {
    if (sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &statement_, nullptr) != SQLITE_OK)
        throw std::runtime_error(
            fmt::format("{} is not a results store of this version ({}): write a new one with a sweep",
                        database.path(), sqlite3_errmsg(database.handle())));
}

StoreQuery::~StoreQuery() { sqlite3_finalize(statement_); }

void StoreQuery::bind(int parameter, const std::string& value) {
    sqlite3_bind_text(statement_, parameter, value.c_str(), -1, SQLITE_TRANSIENT);
}

bool StoreQuery::next() {
    const int state = sqlite3_step(statement_);
    if (state == SQLITE_ROW) return true;
    if (state == SQLITE_DONE) return false;
    if (state == SQLITE_NOTADB)
        throw std::runtime_error(
            fmt::format("{} is not a results store: name one that a sweep wrote", database_.path()));
    throw std::runtime_error(fmt::format("cannot read the results store {}: {}", database_.path(),
                                         sqlite3_errmsg(database_.handle())));
}

std::string StoreQuery::text(int column) const {
    const auto* bytes = sqlite3_column_text(statement_, column);
    return bytes ? reinterpret_cast<const char*>(bytes) : "";
}

std::int64_t StoreQuery::integer(int column) const { return sqlite3_column_int64(statement_, column); }

std::optional<double> StoreQuery::real(int column) const {
    if (sqlite3_column_type(statement_, column) == SQLITE_NULL) return std::nullopt;
    return sqlite3_column_double(statement_, column);
}

}  // namespace edgewise::reports
