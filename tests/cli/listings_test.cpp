// SPDX-License-Identifier: MIT
//
// The commands that print what there is: bytes, list, machine. Their JSON is what other programs rely on.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;

json json_of(const Arguments& arguments) {
    const Folder folder;
    const Outcome outcome = run(arguments, folder);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(lines_of(outcome.out).size(), 1u);
    return json::parse(outcome.out);
}

/// The paper's figure: 21 scalars an edge. Its parts are added up in
/// tests/unit/layout_parts/layout_bytes_test.cpp.
TEST(Bytes, GivesThePapersFigures) {
    const json ledger = json_of({"bytes", "--layouts", "aos_f64,aos_f32", "--shape", "sphere386", "--json"});
    ASSERT_EQ(ledger["rows"].size(), 2u);
    for (const json& row : ledger["rows"]) {
        const double scalar = row["precision"] == "f64" ? 8 : 4;
        EXPECT_EQ(row["table"], scalar == 8 ? "aos_f64" : "aos_f32");
        EXPECT_EQ(row["layout"], "aos");
        EXPECT_EQ(row["shape"], "sphere386");
        EXPECT_EQ(row["edges"], 1152);
        EXPECT_NEAR(row["paper_bytes_per_edge"].get<double>(), 21 * scalar, 1e-9);
        EXPECT_GT(row["slope_bytes_per_edge"].get<double>(), 21 * scalar);
        double sum = 0;
        for (const auto& [name, bytes] : row["components"].items()) sum += bytes.get<double>();
        EXPECT_NEAR(row["total_bytes_per_edge"].get<double>(), sum, 1e-9);
    }
}

/// The row of this table type.
const json& row_of(const json& ledger, const std::string& table) {
    for (const json& row : ledger["rows"]) {
        if (row["table"] == table) return row;
    }
    ADD_FAILURE() << table;
    return ledger["rows"][0];
}

/// A support table has no planes, lean ones no topology to speak of, quantised ones hardly coordinates.
TEST(Bytes, GivesTheFamilysFigures) {
    const json ledger = json_of({"bytes", "--layouts", "lean_f64,lean_f32,quantised_f32", "--json"});
    EXPECT_LE(ledger["rows"][0]["total_bytes_per_edge"], 13);
    EXPECT_LE(ledger["rows"][1]["total_bytes_per_edge"], 9);
    EXPECT_LE(ledger["rows"][2]["total_bytes_per_edge"], 7);
    for (const json& row : ledger["rows"]) {
        EXPECT_TRUE(row["paper_bytes_per_edge"].is_null());
        EXPECT_FALSE(row.contains("slopes_by_index_width")) << "only when asked";
        for (const json& entry : row["queries"]) {
            EXPECT_GT(entry["lines_per_query"], 2);
            EXPECT_EQ(entry["line_bytes_per_query"], 64 * entry["lines_per_query"].get<double>());
        }
    }
}

/// Allocators take at least the requested bytes; jemalloc's statistics agree with the sum of its size
/// classes.
TEST(Bytes, SaysWhatAllocatorsTake) {
    const json ledger = json_of({"bytes", "--layouts", "aos_f64,linked_f64", "--json"});
    for (const json& row : ledger["rows"]) {
        const json& allocators = row["allocators"];
        ASSERT_EQ(allocators.size(), 3U);
        for (const json& cost : allocators) {
            if (cost["taken_bytes"].is_null()) {
                EXPECT_TRUE(cost["reason"].is_string()) << cost;
                continue;
            }
            EXPECT_GE(cost["taken_bytes"], row["table_bytes"]) << cost;
            if (!cost["by_its_statistics"].is_null()) {
                EXPECT_EQ(cost["by_its_statistics"], cost["taken_bytes"]);
            }
        }
        EXPECT_GE(allocators[0]["resident_bytes"], row["table_bytes"]);
    }
    const auto slack = [](const json& row) {
        return row["allocators"][2]["taken_bytes"].get<double>() / row["table_bytes"].get<double>();
    };
    EXPECT_LT(slack(row_of(ledger, "aos_f64")), 1.01) << "one block";
    EXPECT_GT(slack(row_of(ledger, "linked_f64")), 1.05) << "a header a node";
}

/// Wider indices cost more, and only where a layout has them.
TEST(Bytes, FitsSlopesByIndexWidth) {
    const json ledger = json_of({"bytes", "--layouts", "lean_f64,aos_f64", "--slopes", "--json"});
    const auto slope = [&](const char* table, int range) {
        return row_of(ledger, table)["slopes_by_index_width"][range]["bytes_per_edge"].get<double>();
    };
    EXPECT_NEAR(slope("lean_f64", 2), 8 + 2.0 / 3 + 4, 0.05)
        << "coordinates, an offset a third, two neighbours";
    EXPECT_NEAR(slope("lean_f64", 4), 8 + 4.0 / 3 + 8, 0.05);
    EXPECT_NEAR(slope("aos_f64", 2), slope("aos_f64", 4), 0.05);
}

TEST(Draw, PaintsATableToScale) {
    const Folder folder;
    const Outcome outcome = run({"draw", "layout", "aos_f64"}, folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, testing::StartsWith("<svg "));
    EXPECT_THAT(outcome.out, testing::HasSubstr("<title>aos_f64, cube8</title>"));
    EXPECT_THAT(outcome.out, testing::HasSubstr("voronoi_planes 1536 B"));
    folder.write("a&b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
    EXPECT_THAT(run({"draw", "layout", "aos_f64", "--shape", "a&b.obj"}, folder).out,
                testing::HasSubstr("<title>aos_f64, a&amp;b</title>"));
}

TEST(List, NamesEveryEntry) {
    for (const char* what : {"layouts", "probes", "algorithms", "scenes", "shapes", "plans", "figures"}) {
        const json list = json_of({"list", what, "--json"});
        ASSERT_TRUE(list.contains(what));
        ASSERT_FALSE(list[what].empty()) << what;
        for (const json& entry : list[what]) EXPECT_FALSE(entry.at("name").get<std::string>().empty());
    }
}

TEST(List, SaysWhatALayoutIs) {
    const json list = json_of({"list", "layouts", "--json"});
    for (const json& layout : list["layouts"]) {
        EXPECT_FALSE(layout.at("stores").get<std::string>().empty());
        EXPECT_FALSE(layout.at("derives").get<std::string>().empty());
        EXPECT_FALSE(layout.at("precisions").empty());
        EXPECT_FALSE(layout.at("algorithms").empty());
    }
}

TEST(Machine, SaysWhereItMayRun) {
    const Folder folder;
    if (run_in_shell("command -v taskset", {}, folder).exit_code != 0)
        GTEST_SKIP() << "no taskset here (Debian: util-linux)";
    const json cores = json_of({"machine", "--json"})["cores"];
    if (cores.empty()) GTEST_SKIP() << "the kernel describes no caches here";
    const std::string allowed = cores[0]["allowed"];
    const std::string first = allowed.substr(0, allowed.find_first_of(",-"));
    const Outcome bound = run_in_shell("taskset -c " + first + " \"$0\" machine --json", {}, folder);
    ASSERT_EQ(bound.exit_code, 0) << bound.err;
    const json machine = json::parse(bound.out);
    EXPECT_EQ(machine["cores"][0]["allowed"], first);
    EXPECT_THAT(machine["binding"].get<std::string>(),
                testing::HasSubstr(machine["cores"].size() == 1 ? "taskset -c " + first : "bound to"));
}

}  // namespace
}  // namespace edgewise::cli_test
