// SPDX-License-Identifier: MIT
//
// A small store written with raw SQL from the schema, and the fixture that reports on it: two builds; five
// cells of the latest: three verified, one failed, one unavailable, with names that need escaping.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "../complaint.hpp"
#include "../temporary_folder.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/reports/reader.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace fs = std::filesystem;

inline void execute(sqlite3* database, const std::string& sql) {
    char* error = nullptr;
    if (sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &error) != SQLITE_OK)
        throw std::runtime_error(std::string(error) + " in " + sql);
}

/// SQL that inserts all columns of a cell except `run`, which defaults to a sweep.
inline const std::string into_cell =
    "insert into cell(build, hash, scene, scene_parameters, shape, shape_source, algorithm, layout, precision, "
    "table_type, vertices, edges, faces, seed, queries, status, reason, axes) ";

inline std::string cell_sql(const std::string& hash, const std::string& scene, const std::string& shape,
                            int vertices, const std::string& algorithm, const std::string& precision,
                            const std::string& status, const std::string& reason) {
    const std::string parameters = scene == "tumble" ? R"({"rotation_step":0.01})" : "{}";
    return into_cell + "values('b2','" + hash + "','" + scene + "','" + parameters + "','" + shape +
           "','built-in','" + algorithm + "','aos','" + precision + "','aos_" + precision + "'," +
           std::to_string(vertices) + "," + std::to_string(3 * vertices - 6) + ",4,-1,1000,'" + status +
           "','" + reason + "','');";
}

inline std::string figure_sql(const std::string& hash, const std::string& probe, const std::string& name,
                              const std::string& value, const std::string& unit,
                              const std::string& reason = {}) {
    return "insert into figure values('b2','" + hash + "','" + probe + "','" + name + "'," + value + ",'" +
           unit + "','" + reason + "','');";
}

inline std::string full_cell_sql(const std::string& hash, double ns) {
    std::string sql = figure_sql(hash, "bytes", "voronoi_planes", "128", "B/edge");
    sql += figure_sql(hash, "bytes", "topology", "40", "B/edge");
    sql += figure_sql(hash, "bytes", "paper_bytes_per_edge", "168", "B/edge");
    sql += figure_sql(hash, "error", "checked", "400", "queries");
    sql += figure_sql(hash, "error", "worst_error_given", "2.5e-16", "scale");
    for (const std::string pairs : {"separated", "overlapping"}) {
        const bool none = pairs == "overlapping" && hash == "h-null";
        const std::string why = none ? "no overlapping pair in this cell" : "";
        const auto value = [&](double number) { return none ? std::string("null") : std::to_string(number); };
        sql += figure_sql(hash, "time", pairs + "_ns", value(ns), "ns", why);
        sql += figure_sql(hash, "time", pairs + "_ns_low", value(ns * .9), "ns", why);
        sql += figure_sql(hash, "time", pairs + "_ns_high", value(ns * 1.1), "ns", why);
        sql += figure_sql(hash, "time", pairs + "_ratio", value(ns / 100), "1", why);
    }
    return sql;
}

inline std::string empty_store_sql() {
    return "pragma application_id = " + std::to_string(store::store_application_id) +
           "; pragma user_version = " + std::to_string(store::store_schema_version) + ";" +
           store::store_schema;
}

/// Two builds; five cells of the latest: three verified, one failed, one unavailable, with names that need
/// escaping.
inline std::string store_sql() {
    std::string sql = empty_store_sql();
    sql += "insert into build values('b1','r1','g++','-O3','Release','{}');";
    sql +=
        "insert into build values('b2','r2','g++ <12>','-O3','Release',"
        "'{\"cpu\":\"Test CPU\",\"counters\":[{\"event\":\"cycles\",\"status\":\"unavailable\",\"errno\":2,"
        "\"reason\":\"no PMU\",\"remedy\":\"bare metal\"}]}');";
    sql += "insert into meta values('build','b2'),('plan','quick');";
    sql += into_cell +
           "select 'b1','old','static','{}','s','s','vclip','aos','f64','aos_f64',4,6,4,7,1,"
           "'verified','','';";
    sql += cell_sql("h-full", "static", "cube8", 8, "vclip", "f64", "verified", "");
    sql += cell_sql("h-null", "tumble", "cow</script><b>&\"", 20, "gjk", "f64", "verified", "");
    sql += cell_sql("h-bare", "static", "cube8", 8, "gjk", "f32", "verified", "");
    sql += cell_sql("h-failed", "static", "cube8", 8, "gjk", "mixed", "failed",
                    "3 wrong verdicts, \"first\" at 17");
    sql += cell_sql("h-gone", "tumble", "cube8", 8, "vclip", "mixed", "unavailable", "mesh unreadable");
    sql += full_cell_sql("h-full", 100) + full_cell_sql("h-null", 250);
    for (int number = 0; number < 7; ++number)
        sql += "insert into round values('b2','h-full'," + std::to_string(number) + ",10," +
               std::to_string(1000 + number) + ",0,0,10,1000,0,0,0,0,0,0);";
    return sql;
}

class Report : public testing::Test {
  protected:
    std::string make_store(const std::string& sql = store_sql()) const {
        const std::string path = (directory_ / "store.db").string();
        sqlite3* database = nullptr;
        EXPECT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
        execute(database, "begin;" + sql + "commit;");
        sqlite3_close(database);
        return path;
    }
    std::string text(const fs::path& name) const {
        return input::read_file_text(directory_ / name).value.value_or("(missing)");
    }
    /// The one line that reading `path` fails with.
    static std::string failure(const std::string& path) {
        return complaint_of([&] { return read_report(path); });
    }

    const TemporaryFolder folder_;
    const fs::path& directory_ = folder_.path();
};

}  // namespace edgewise::reports
