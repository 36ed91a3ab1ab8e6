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

TEST(Heat, SaysWhatWasTouched) {
    const Folder folder;
    const Arguments cell = {"draw",      "heat", "--shape",     "sphere38",
                            "--queries", "100",  "--parameter", "bodies=2"};
    const json heat = json::parse(run(with(cell, {"--json"}), folder).out);
    EXPECT_EQ(heat["queries"], 100);
    const std::size_t vertices = heat["touched_of_first_table"]["vertices"].size();
    EXPECT_GT(vertices, 1U);
    EXPECT_NEAR(heat["touched_parts"]["vertices"].get<double>(), static_cast<double>(vertices) / 38, 1e-12);
    EXPECT_LE(heat["touched_bytes"], heat["table_bytes"]);
    EXPECT_THAT(run(with(cell, {"--svg", "heat.svg"}), folder).out, HasSubstr("voronoi_plane"));
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

TEST(Bench, ScalingRefusesATableThatQueriesWrite) {
    const Outcome outcome = run({"bench", "scaling", "--table", "lazy_f64", "--algorithm", "vclip", "--shape",
                                 "cube8", "--queries", "50"},
                                Folder());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(lines_of(outcome.err), testing::ElementsAre(testing::AllOf(
                                           HasSubstr("lazy_f64"), HasSubstr("one thread at a time"))));
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
    const json result = json::parse(outcome.out);
    ASSERT_EQ(result["crosscheck"].size(), 2U);
    bool compared = false;
    for (const json& row : result["crosscheck"]) {
        EXPECT_NE(row["reason"].is_null(), !row.contains("callgrind")) << row;
        compared |= row["reason"].is_null();
    }
    EXPECT_EQ(outcome.exit_code, compared ? 0 : 1) << outcome.err;
    EXPECT_EQ(result["perf"].size(), 4U);
    for (const json& count : result["perf"])
        EXPECT_NE(count["value"].is_null(), count["reason"].is_null()) << count;
}

// `edgewise caches`: a cell and the trace file that it wrote are modelled equally. How lines are read and
// counted is tested in tests/unit/measure/trace_file_test.cpp.

json caches_of(const Arguments& more, const Folder& folder) {
    const Outcome outcome =
        run(with({"caches", "--json", "--machines", "zen5,pentium3_coppermine"}, more), folder);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
}

TEST(Traces, AreTheCellsThatWroteThem) {
    const Folder folder;
    json cell = caches_of(
        {"--table", "aos_f64", "--shape", "sphere38", "--queries", "100", "--write", "cell.din"}, folder);
    json file = caches_of({"--trace", "cell.din"}, folder);
    EXPECT_GT(cell["reads"], 1000);
    EXPECT_GT(cell["writes"], 50);
    EXPECT_GT(cell["machines"][1]["levels"][0]["misses"], cell["machines"][0]["levels"][0]["misses"]);
    EXPECT_EQ(file["trace"], "cell.din (din)");
    cell.erase("trace");
    file.erase("trace");
    EXPECT_EQ(cell, file);
}

TEST(Traces, OfLackeyLeaveFetchesOutUntilAsked) {
    const Folder folder;
    folder.write(
        "t.txt",
        "==7== Lackey\nI  0401ab70,3\n S 1fff00703c,8\n L 1fff007040,8\n M 1fff007044,4\nI  0401ab73,5\n==7== \n");
    EXPECT_EQ(caches_of({"--trace", "t.txt"}, folder)["distinct_lines"], 2);
    EXPECT_EQ(caches_of({"--trace", "t.txt", "--fetches"}, folder)["distinct_lines"], 3);
    const Outcome text = run({"caches", "--trace", "t.txt", "--machines", "zen5"}, folder);
    EXPECT_THAT(text.out,
                testing::AllOf(HasSubstr("t.txt (lackey): 2 reads, 2 writes, 2 instruction fetches left out"),
                               HasSubstr("2 distinct lines"), HasSubstr("L1D")));
}

/// Addresses without a letter are read as hexadecimal, as the form has it, but not without a word.
TEST(Traces, ThatLookDecimalAreWarnedAbout) {
    const Folder folder;
    std::string decimal;
    for (int i = 0; i < 200; ++i) decimal += "0 " + std::to_string(20734016 + 64 * i) + "\n";
    folder.write("cpu.trace", decimal);
    folder.write("hexadecimal.din", decimal + "0 20734a40\n");
    const auto warning = [&](const std::string& file) {
        const Outcome outcome = run({"caches", "--trace", file}, folder);
        EXPECT_EQ(outcome.exit_code, 0);
        return outcome.err;
    };
    EXPECT_THAT(warning("cpu.trace"), HasSubstr("cpu.trace: no address has a digit above 9"));
    EXPECT_EQ(warning("hexadecimal.din"), "");
}

}  // namespace
}  // namespace edgewise::cli_test
