// SPDX-License-Identifier: MIT
//
// What the tests of the store share: a directory of their own and rounds to put in.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>

#include "../temporary_folder.hpp"
#include "edgewise/store/store.hpp"

namespace edgewise::store {

/// A directory of its own for each test, gone afterwards.
class StoreTest : public testing::Test {
  protected:
    const TemporaryFolder folder_;
    const std::filesystem::path& directory_ = folder_.path();
    const std::string path_ = folder_ / "test.db";
};

/// Runs SQL past the store, as a foreign program would.
inline void run_sql(const std::string& path, const std::string& sql) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
    char* message = nullptr;
    EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &message), SQLITE_OK) << message;
    sqlite3_close(database);
}

inline std::string bytes_of(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// What `meta` holds under a key.
inline std::optional<std::string> find_meta(const std::string& path, const std::string& key) {
    const sqlite::Database database = sqlite::Database::for_reading(path);
    sqlite::Statement select(database, "select value from meta where key = ?");
    if (!select.bind(key).step()) return std::nullopt;
    return select.text(0);
}

/// Every number different, so that no two columns can be swapped unseen.
inline measure::Round sample_round(int number) {
    const auto n = static_cast<std::uint64_t>(number);
    return {number,
            {n * 100 + 1, n * 100 + 2, number + 0.125, number + 0.25, n * 100 + 5, number + 0.625,
             n * 100 + 6, number + 0.75},
            {n * 100 + 3, n * 100 + 4, number + 0.375, number + 0.5}};
}

inline bool equal(const measure::Round& a, const measure::Round& b) {
    const auto tied = [](const measure::Round& r) {
        return std::tie(r.number, r.timing.separated_queries, r.timing.overlapping_queries,
                        r.timing.separated_ns, r.timing.overlapping_ns, r.timing.either_queries,
                        r.timing.either_ns, r.timing.first_queries, r.timing.first_ns,
                        r.baseline.separated_queries, r.baseline.overlapping_queries, r.baseline.separated_ns,
                        r.baseline.overlapping_ns);
    };
    return tied(a) == tied(b);
}

}  // namespace edgewise::store
