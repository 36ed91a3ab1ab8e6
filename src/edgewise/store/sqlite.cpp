// SPDX-License-Identifier: MIT
//
// The owners of sqlite.hpp over the C interface (sqlite.org/cintro.html).
#include "edgewise/store/sqlite.hpp"

#include <fmt/core.h>
#include <sqlite3.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>

namespace edgewise::store::sqlite {

namespace {

/// Much longer than any transaction: another sweep on the same store waits.
constexpr int busy_timeout_ms = 20'000;

const char* remedy(int code) {
    switch (code & 0xff) {
        case SQLITE_NOTADB:
            return "; not an SQLite file: move it away or name another store; it was not touched";
        case SQLITE_CANTOPEN:
            return "; does its directory exist, and may it be written? A store with a log (-wal) in a directory "
                   "that may not be written must be copied with its log";
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return "; another program holds it: end that program or name another store";
        case SQLITE_READONLY:
            return "; make it writable or name another store";
        case SQLITE_FULL:
            return "; free some space: what was stored before is safe";
        case SQLITE_CORRUPT:
            return "; the file is damaged: move it away and measure again";
        default:
            return "";
    }
}

/// The path, in a form that SQLite takes for a file: a name that begins with a colon would be a database in
/// memory.
std::string as_file(const std::string& path) { return path.starts_with(':') ? "./" + path : path; }

/// The path in the same form. Throws for a device or a pipe: SQLite would open it and leave a journal there.
std::string file_to_write(const std::string& path) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw std::runtime_error(
            fmt::format("store {}: is {}: name a file; nothing was written", path,
                        std::filesystem::is_directory(status) ? "a folder" : "a device, a pipe or the like"));
    return as_file(path);
}

/// URI of the file, for SQLite to treat it as immutable: then it makes no log and no shared memory next to
/// it.
std::string immutable_uri(const std::string& path) {
    std::string uri = "file:";
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        uri += std::isalnum(byte) || c == '/' || c == '.' ? std::string(1, c) : fmt::format("%{:02X}", byte);
    }
    return uri + "?immutable=1";
}

/// Returns true if SQLite may write the file and make others next to it.
bool is_writable(const std::filesystem::path& path) {
    const auto folder = path.parent_path();
    return access(path.c_str(), W_OK) == 0 && access(folder.empty() ? "." : folder.c_str(), W_OK) == 0;
}

}  // namespace

Database::Database(const std::string& path)
    : Database(path, file_to_write(path), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE) {}

Database Database::for_reading(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        throw std::runtime_error(
            fmt::format("no results store at {}: run a sweep first, or name the store", path));
    }
    const auto log = std::filesystem::file_size(path + "-wal", ignored);
    const bool has_log = !ignored && log > 0;
    // A connection that may write removes the log that it made when it ends; one that only reads leaves it.
    const std::string file = as_file(path);
    if (is_writable(path)) return {path, file, SQLITE_OPEN_READWRITE, has_log};
    if (has_log) return {path, file, SQLITE_OPEN_READONLY};
    return {path, immutable_uri(file), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI};
}

Database::Database(const std::string& path, const std::string& name, int flags, bool leaves_log)
    : path_(path) {
    // SQLite would take an empty name for a temporary file, gone at the end.
    if (path.empty()) throw std::runtime_error("store: no file name given");
    if (sqlite3_open_v2(name.c_str(), &handle_, flags, nullptr) != SQLITE_OK) {
        // The handle exists even then (it holds the message), and a constructor that throws runs no
        // destructor.
        try {
            fail("opening");
        } catch (...) {
            sqlite3_close(handle_);
            throw;
        }
    }
    sqlite3_busy_timeout(handle_, busy_timeout_ms);
    if (leaves_log) sqlite3_db_config(handle_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
}

Database::~Database() { sqlite3_close(handle_); }

void Database::execute(const char* sql) const {
    if (sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail("writing");
}

std::int64_t Database::number(const char* sql) const {
    Statement statement(*this, sql);
    if (!statement.step()) fail("reading");
    return statement.integer(0);
}

void Database::fail(std::string_view doing) const {
    std::string what = sqlite3_errmsg(handle_);  // it may quote the contents of a damaged file
    std::replace_if(
        what.begin(), what.end(), [](unsigned char c) { return c < ' '; }, ' ');
    throw std::runtime_error(
        fmt::format("store {}: {}: {}{}", path_, doing, what, remedy(sqlite3_errcode(handle_))));
}

Statement::Statement(const Database& database, const std::string& sql) : database_(database) {
    if (sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &handle_, nullptr) != SQLITE_OK) {
        database.fail("reading its schema");
    }
}

Statement::~Statement() { sqlite3_finalize(handle_); }

bool Statement::step() {
    const int code = sqlite3_step(handle_);
    if (code != SQLITE_ROW && code != SQLITE_DONE) {
        database_.fail(sqlite3_stmt_readonly(handle_) ? "reading" : "writing");
    }
    return code == SQLITE_ROW;
}

void Statement::reset() { sqlite3_reset(handle_); }

void Statement::bind_integer(int index, std::int64_t value) {
    check_bound(sqlite3_bind_int64(handle_, index, value));
}

void Statement::bind_real(int index, const std::optional<double>& value) {
    check_bound(value ? sqlite3_bind_double(handle_, index, *value) : sqlite3_bind_null(handle_, index));
}

void Statement::bind_text(int index, std::string_view value) {
    // A null pointer would bind NULL; an empty text is not null.
    const char* data = value.data() != nullptr ? value.data() : "";
    check_bound(sqlite3_bind_text64(handle_, index, data, value.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
}

void Statement::check_bound(int code) const {
    if (code != SQLITE_OK) database_.fail("binding");
}

Statement& Statement::bind_row(const Statement& row) {
    reset();
    for (int i = 0; i < sqlite3_column_count(row.handle_); ++i)
        check_bound(sqlite3_bind_value(handle_, i + 1, sqlite3_column_value(row.handle_, i)));
    return *this;
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(handle_, column); }

double Statement::real(int column) const { return sqlite3_column_double(handle_, column); }

std::optional<double> Statement::optional_real(int column) const {
    if (sqlite3_column_type(handle_, column) == SQLITE_NULL) return std::nullopt;
    return real(column);
}

std::string Statement::text(int column) const {
    const void* data = sqlite3_column_text(handle_, column);
    if (data == nullptr) return {};
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_, column));
    return std::string(static_cast<const char*>(data), size);
}

Transaction::Transaction(const Database& database) : database_(database) {
    database.execute("begin immediate");
}

Transaction::~Transaction() {
    // After a full disk SQLite has rolled back by itself; then there is nothing left to do.
    if (open_ && sqlite3_get_autocommit(database_.handle()) == 0) {
        sqlite3_exec(database_.handle(), "rollback", nullptr, nullptr, nullptr);
    }
}

void Transaction::commit() {
    database_.execute("commit");
    open_ = false;
}

}  // namespace edgewise::store::sqlite
