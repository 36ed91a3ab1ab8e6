// SPDX-License-Identifier: MIT
//
// A read-only SQLite connection and one prepared statement, as thin as they can be: what the reader needs to
// turn rows into structs.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <optional>
#include <string>

namespace edgewise::reports {

class ReadOnlyDatabase {
  public:
    /// Throws std::runtime_error when the file is missing or cannot be opened.
    explicit ReadOnlyDatabase(const std::string& path);
    ~ReadOnlyDatabase();
    ReadOnlyDatabase(const ReadOnlyDatabase&) = delete;
    ReadOnlyDatabase& operator=(const ReadOnlyDatabase&) = delete;

    [[nodiscard]] sqlite3* handle() const { return handle_; }
    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    std::string path_;
    sqlite3* handle_ = nullptr;
};

class StoreQuery {
  public:
    /// Throws std::runtime_error when the statement does not fit the file: then the store is foreign.
    StoreQuery(const ReadOnlyDatabase& database, const std::string& sql);
    ~StoreQuery();
    StoreQuery(const StoreQuery&) = delete;
    StoreQuery& operator=(const StoreQuery&) = delete;

    void bind(int parameter, const std::string& value);
    [[nodiscard]] bool next();  ///< false at the end; throws when the file cannot be read on
    [[nodiscard]] std::string text(int column) const;
    [[nodiscard]] std::int64_t integer(int column) const;
    [[nodiscard]] std::optional<double> real(int column) const;

  private:
    const ReadOnlyDatabase& database_;
    sqlite3_stmt* statement_ = nullptr;
};

}  // namespace edgewise::reports
