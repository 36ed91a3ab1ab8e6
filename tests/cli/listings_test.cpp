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

/// The paper's figure: 21 scalars an edge, of which 16 are Voronoi planes, 4 direction and length, and the
/// vertices' share is 1 (3 coordinates, V/E -> 1/3).
void expect_paper_bytes(const json& row, double scalar) {
    EXPECT_NEAR(row["paper_bytes_per_edge"].get<double>(), 21 * scalar, 1e-9);
    const json& components = row["components"];
    EXPECT_EQ(components["voronoi_planes"], 16 * scalar);
    EXPECT_EQ(components["edge_geometry"], 4 * scalar);
    EXPECT_NEAR(components["vertex_coordinates"].get<double>(), 386.0 / 1152 * 3 * scalar, 1e-9);
    double sum = 0;
    for (const auto& [name, bytes] : components.items()) sum += bytes.get<double>();
    EXPECT_NEAR(row["total_bytes_per_edge"].get<double>(), sum, 1e-9);
    for (const char* own_line : {"face_planes", "topology", "padding"})
        EXPECT_TRUE(components.contains(own_line));
    EXPECT_GT(row["slope_bytes_per_edge"].get<double>(), 21 * scalar);
}

TEST(Bytes, GivesThePapersFigures) {
    const json ledger = json_of({"bytes", "--layouts", "aos_f64,aos_f32", "--shape", "sphere386", "--json"});
    const json& rows = ledger["rows"];
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["table"], "aos_f64");
    EXPECT_EQ(rows[0]["layout"], "aos");
    EXPECT_EQ(rows[0]["precision"], "f64");
    EXPECT_EQ(rows[1]["table"], "aos_f32");
    for (const json& row : rows) {
        EXPECT_EQ(row["shape"], "sphere386");
        EXPECT_EQ(row["vertices"], 386);
        EXPECT_EQ(row["edges"], 1152);
    }
    expect_paper_bytes(rows[0], 8);
    expect_paper_bytes(rows[1], 4);
}

TEST(Bytes, ReadsAMeshFile) {
    const Folder folder;
    folder.write("corner.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    const Outcome outcome = run({"bytes", "--mesh", "corner.obj", "--json", "--layouts", "soa_f32"}, folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json row = json::parse(outcome.out)["rows"].at(0);
    EXPECT_EQ(row["vertices"], 4);
    EXPECT_EQ(row["edges"], 6);
}

class List : public testing::TestWithParam<const char*> {};

TEST_P(List, NamesEveryEntry) {
    const json list = json_of({"list", GetParam(), "--json"});
    ASSERT_TRUE(list.contains(GetParam()));
    const json& entries = list[GetParam()];
    ASSERT_FALSE(entries.empty());
    for (const json& entry : entries) EXPECT_FALSE(entry.at("name").get<std::string>().empty());
}

INSTANTIATE_TEST_SUITE_P(Of, List,
                         testing::Values("layouts", "probes", "algorithms", "scenes", "shapes", "plans"),
                         [](const auto& of) { return std::string(of.param); });

TEST(List, SaysWhatALayoutIs) {
    const json list = json_of({"list", "layouts", "--json"});
    for (const json& layout : list["layouts"]) {
        EXPECT_FALSE(layout.at("stores").get<std::string>().empty());
        EXPECT_FALSE(layout.at("derives").get<std::string>().empty());
        EXPECT_FALSE(layout.at("precisions").empty());
        EXPECT_FALSE(layout.at("algorithms").empty());
    }
}

/// A counter that cannot be had is null with a reason and a remedy, never 0 and never absent.
TEST(Machine, TellsCountersOrWhyNot) {
    const json machine = json_of({"machine", "--json"});
    EXPECT_TRUE(machine.contains("cpu"));
    EXPECT_TRUE(machine.at("caches").is_array());
    const json& counters = machine.at("counters");
    ASSERT_GT(counters.size(), 5u);
    for (const json& counter : counters) {
        for (const char* key :
             {"event", "status", "encoding", "level", "value", "errno", "reason", "remedy"}) {
            EXPECT_TRUE(counter.contains(key)) << counter.dump();
        }
        const bool counted = counter["status"] == "counted";
        EXPECT_TRUE(counted || counter["status"] == "unavailable") << counter.dump();
        EXPECT_EQ(counter["value"].is_null(), !counted) << counter.dump();
        EXPECT_EQ(counter["reason"].is_string() && !counter["reason"].empty(), !counted) << counter.dump();
    }
}

TEST(Listings, AreForPeopleToo) {
    const Folder folder;
    for (const Arguments& arguments :
         {Arguments{"bytes", "--shape", "cube8"}, Arguments{"list", "scenes"}, Arguments{"machine"}}) {
        const Outcome outcome = run(arguments, folder);
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_GT(lines_of(outcome.out).size(), 2u);
    }
}

}  // namespace
}  // namespace edgewise::cli_test
