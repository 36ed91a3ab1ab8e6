// SPDX-License-Identifier: MIT
//
// SQLite's C interface with owners: a connection, a statement, a transaction. Only the functions that the
// store needs. Every failure is a std::runtime_error with one line: the file, the action and SQLite's own
// message. One thread per connection; a connection does not survive fork().
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

struct sqlite3;
struct sqlite3_stmt;

namespace edgewise::store::sqlite {

class Database {
  public:
    /// Opens for reading and writing, and creates the file if it does not exist. Nothing is written yet:
    /// SQLite creates an empty file, and reads even the header only with the first statement.
    explicit Database(const std::string& path);
    /// Opens for reading; throws if the file does not exist. Leaves no other files next to it, and reads
    /// write-protected files and files in write-protected folders.
    [[nodiscard]] static Database for_reading(const std::string& path);
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    /// Runs one or more statements and ignores the rows that they return.
    void execute(const char* sql) const;
    /// The first column of the first row of a query, as a number.
    [[nodiscard]] std::int64_t number(const char* sql) const;

    [[noreturn]] void fail(std::string_view doing) const;
    [[nodiscard]] sqlite3* handle() const { return handle_; }
    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    /// `name`: the path, or a URI of it; `leaves_log`: the write-ahead log is kept.
    Database(const std::string& path, const std::string& name, int flags, bool leaves_log = false);

    std::string path_;
    sqlite3* handle_ = nullptr;
};

class Statement {
  public:
    Statement(const Database& database, const std::string& sql);
    ~Statement();
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    /// Starts over with these values for the parameters ?, in order.
    template <class... Values>
    Statement& bind(const Values&... values) {
        reset();
        int index = 0;
        (bind_value(++index, values), ...);
        return *this;
    }

    /// True while there is a row to read.
    bool step();
    /// Runs a statement that returns no row.
    void run() {
        while (step()) {
        }
    }

    /// Starts over with the columns of another statement's row as the values.
    Statement& bind_row(const Statement& row);

    [[nodiscard]] std::int64_t integer(int column) const;
    /// Unsigned numbers are stored as the signed number of the same bits (SQLite knows no unsigned ones).
    [[nodiscard]] std::uint64_t natural(int column) const {
        return static_cast<std::uint64_t>(integer(column));
    }
    [[nodiscard]] double real(int column) const;
    [[nodiscard]] std::optional<double> optional_real(int column) const;
    [[nodiscard]] std::string text(int column) const;

  private:
    void reset();
    void bind_integer(int index, std::int64_t value);
    void bind_real(int index, const std::optional<double>& value);
    void bind_text(int index, std::string_view value);
    void check_bound(int code) const;

    template <class Value>
    void bind_value(int index, const Value& value) {
        if constexpr (std::is_integral_v<Value>) {
            bind_integer(index, static_cast<std::int64_t>(value));
        } else if constexpr (std::is_convertible_v<Value, std::string_view>) {
            bind_text(index, value);
        } else {
            bind_real(index, value);
        }
    }

    const Database& database_;
    sqlite3_stmt* handle_ = nullptr;
};

/// A transaction, rolled back unless committed. Takes the write lock at once, so that it waits at its start
/// and not at its end.
class Transaction {
  public:
    explicit Transaction(const Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    void commit();

  private:
    const Database& database_;
    bool open_ = true;
};

}  // namespace edgewise::store::sqlite
