// SPDX-License-Identifier: MIT
//
// Output of the commands about caches and memory: speeds, calibration and page faults.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(Caches, OfAnUnknownMachineAreOneLineOfComplaint) {
    const Folder folder;
    const Outcome unknown =
        run({"sweep", "--scenes", "static", "--caches", "all", "--machines", "zen17"}, folder);
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.err, testing::AllOf(HasSubstr("zen17"), HasSubstr("known:"), HasSubstr("zen5")));
    folder.write("bad.json", "{}");
    const Outcome bad =
        run({"sweep", "--scenes", "static", "--caches", "all", "--machines", "bad.json"}, folder);
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_THAT(bad.err, HasSubstr("bad.json"));
    const Outcome shape = run({"sweep", "--scenes", "static", "--caches", "blob"}, folder);
    EXPECT_EQ(shape.exit_code, 2);
    EXPECT_THAT(shape.err, HasSubstr("blob"));
}

TEST(Heat, SaysWhatWasTouched) {
    const Folder folder;
    const Arguments cell = {"draw",      "heat", "--shape",     "sphere38",
                            "--queries", "100",  "--parameter", "bodies=2"};
    Arguments in_json = cell;
    in_json.emplace_back("--json");
    const json heat = json::parse(run(in_json, folder).out);
    EXPECT_EQ(heat["queries"], 100);
    const std::size_t vertices = heat["touched_of_first_table"]["vertices"].size();
    EXPECT_GT(vertices, 1U);
    EXPECT_NEAR(heat["touched_parts"]["vertices"].get<double>(), static_cast<double>(vertices) / 38, 1e-12);
    EXPECT_LE(heat["touched_bytes"], heat["table_bytes"]);
    Arguments picture = cell;
    picture.insert(picture.end(), {"--svg", "heat.svg"});
    EXPECT_THAT(run(picture, folder).out, HasSubstr("voronoi_plane"));
    EXPECT_THAT(text_of(folder / "heat.svg"),
                testing::AllOf(testing::StartsWith("<svg"), HasSubstr("</svg>")));
}

TEST(Bench, PrintsTheModelsSpeed) {
    const Folder folder;
    const Outcome outcome =
        run({"bench", "model", "--json", "--shape", "sphere38", "--queries", "200", "--repetitions", "1"},
            folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json rows = json::parse(outcome.out)["bench"];
    EXPECT_EQ(rows.size(), 9U);
    for (const json& row : rows) EXPECT_GT(row["accesses_per_second"].get<double>(), 0) << row;
}

TEST(Calibrate, SaysWhatItModelledAndCountedOrWhyNot) {
    const Folder folder;
    const Outcome outcome =
        run({"bench", "calibrate", "--json", "--times", "0.5,2", "--loads", "20000"}, folder);
    if (outcome.exit_code == 2) {
        EXPECT_THAT(outcome.err, HasSubstr("caches are not known"));
        GTEST_SKIP() << outcome.err;
    }
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json rows = json::parse(outcome.out)["calibration"];
    ASSERT_GE(rows.size(), 2U);
    for (const json& row : rows) EXPECT_NE(row["counted_per_load"].is_null(), row["reason"].is_null()) << row;
    EXPECT_NEAR(rows[0]["modelled_per_load"].get<double>(), 0, 0.01);
    EXPECT_NEAR(rows[1]["modelled_per_load"].get<double>(), 0.5, 0.05);
}

/// Limits far below and far above what the tables take.
json paged() {
    const Folder folder;
    const Outcome outcome = run(
        {"paging", "--json", "--layouts", "aos_f64", "--bodies", "100", "--steps", "2", "--limits", "6,64"},
        folder);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.exit_code == 0 ? json::parse(outcome.out)["paging"][0] : json();
}

/// What the kernel throws out depends on what else it does: the median of three runs.
TEST(Paging, MeasuresFaultsAndPredictsThem) {
    std::vector<double> ratios;
    for (int i = 0; i < 3; ++i) {
        const json result = paged();
        ASSERT_FALSE(result.is_null());
        EXPECT_GT(result["table_bytes"].get<double>(), 20e6);
        ASSERT_EQ(result["rows"].size(), 2U);
        const json &tight = result["rows"][0], &wide = result["rows"][1];
        EXPECT_GT(tight["predicted_at_limit"].get<double>(), 1);
        EXPECT_EQ(wide["predicted_at_limit"], 0);
        if (!tight["reason"].is_null()) GTEST_SKIP() << "not measured: " << tight["reason"];
        EXPECT_EQ(wide["faults_per_query"], 0);
        EXPECT_EQ(wide["predicted_at_held"], 0);
        EXPECT_GT(tight["faults_per_query"].get<double>(), 1);
        ratios.push_back(tight["faults_per_query"].get<double>() / tight["predicted_at_held"].get<double>());
        std::printf("faults over prediction at 6 MiB: %.3f\n", ratios.back());
        if (!result["keeps_recency"].get<bool>())
            GTEST_SKIP() << "pages are not thrown out by when they were used";
    }
    std::sort(ratios.begin(), ratios.end());
    EXPECT_GT(ratios[1], 1 / 1.5);
    EXPECT_LT(ratios[1], 1.5);
}

TEST(Crosscheck, SaysWhatItComparedOrWhyNot) {
    const Folder folder;
    const Outcome outcome = run({"bench", "crosscheck", "--json", "--shape", "cube8", "--queries", "50",
                                 "--machines", "zen5,pentium3_coppermine"},
                                folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json result = json::parse(outcome.out);
    ASSERT_EQ(result["crosscheck"].size(), 2U);
    for (const json& row : result["crosscheck"])
        EXPECT_NE(row["reason"].is_null(), !row.contains("callgrind")) << row;
    EXPECT_EQ(result["perf"].size(), 4U);
    for (const json& count : result["perf"])
        EXPECT_NE(count["value"].is_null(), count["reason"].is_null()) << count;
}

}  // namespace
}  // namespace edgewise::cli_test
