// SPDX-License-Identifier: MIT
//
// The tables of the chapter on the paper's figures from synthetic data; and the answer to the thrash at 386
// vertices, from synthetic stores in which it is the cache, paging, both, neither, or not known.
#include <gmock/gmock.h>

#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/claims/claims.hpp"
#include "made_up_data.hpp"

namespace edgewise::reports {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(PaperTables, StaticHasBothAlgorithmsInOneRow) {
    ReportData data;
    add_scene(data, "paper_static", "");
    data.from_files = {made_up_cell("paper_static", "vclip", "{}", times(400)),
                       made_up_cell("paper_static", "gjk", "{}", times(300))};
    const TextGrid grid = static_grid(data);
    ASSERT_EQ(grid.rows.size(), 1U);
    expect_texts(grid.rows[0], {{3, "400"}, {4, "300"}, {5, "0.750"}});
    EXPECT_FALSE(grid.rows[0][6].why.empty()) << "builds were not timed";
}

TEST(PaperTables, CostsStandTermByTerm) {
    ReportData data;
    add_scene(data, "paper_bodies", "bodies");
    add_both(data, "paper_bodies", R"({"bodies":100})",
             {{"cost.pairs_per_step", 50}, {"cost.equation_2_ns", 900}, {"cost.step_ns", 1000}});
    const TextGrid grid = cost_grid(data, true);
    ASSERT_EQ(grid.rows.size(), 2U);
    EXPECT_EQ(grid.rows[0].size(), grid.columns.size());
    EXPECT_EQ(grid.rows[0][2].text, "100");
    EXPECT_EQ(grid.rows[0].back().text, "0.900");
    EXPECT_TRUE(cost_grid(data, false).rows.empty());
}

TEST(PaperTables, NeedsAreRatiosToThePlainCell) {
    ReportData data;
    add_scene(data, "paper_needs", "");
    data.from_files = {made_up_cell("paper_needs", "gjk", "{}", times(100)),
                       made_up_cell("paper_needs", "gjk", "{}", times(40))};
    data.from_files[1].axes = "needs=verdict";
    data.from_files[1].table += " needs=verdict";
    const TextGrid grid = needs_grid(data);
    ASSERT_EQ(grid.rows.size(), 2U) << "separated and overlapping";
    expect_texts(grid.rows[0], {{4, "100"}, {5, "0.400"}});
    EXPECT_THAT(grid.rows[0][6].why, HasSubstr("needs=distance"));
}

TEST(PaperTables, StaticTestsStandByBodyAndDistance) {
    ReportData data;
    add_scene(data, "paper_static_gap", "gap");
    const auto add = [&](const char* algorithm, const char* gap, double ns, double steps) {
        MadeUp figures = times(ns);
        figures["error.mean_steps.cold"] = steps;
        data.from_files.push_back(made_up_cell("paper_static_gap", algorithm, gap, figures));
    };
    add("gjk", R"({"gap":1})", 300, 3);
    add("vclip", R"({"gap":1})", 200, 10);
    add("vclip", R"({"gap":0.001})", 80, 4);
    const TextGrid grid = static_gap_grid(data);
    ASSERT_EQ(grid.rows.size(), 2U);
    ASSERT_EQ(grid.rows[0].size(), grid.columns.size());
    EXPECT_EQ(grid.rows[0][3].text, "–") << "no GJK at the smaller gap";
    expect_texts(grid.rows[1], {{5, "10"}, {7, "20.000"}, {8, "100.000"}});
}

TEST(PaperTables, MarginsStandBesideEachOther) {
    ReportData data;
    add_scene(data, "paper_margin", "margin");
    const auto add = [&](const char* algorithm, const char* margin, double ns) {
        MadeUp figures = times(ns);
        figures.insert({{"error.overlapping", 30}, {"error.checked", 120}, {"work.first_share", 0.125}});
        data.from_files.push_back(made_up_cell("paper_margin", algorithm, margin, figures));
    };
    add("vclip", R"({"margin":0.2})", 120);
    add("gjk", R"({"margin":0.2})", 100);
    add("vclip", R"({"margin":0})", 80);
    add("gjk", R"({"margin":0})", 100);
    const TextGrid grid = margin_grid(data);
    ASSERT_EQ(grid.rows.size(), 2U);
    ASSERT_EQ(grid.rows[0].size(), grid.columns.size());
    EXPECT_EQ(grid.rows[0][2].text, "0");
    EXPECT_EQ(grid.rows[1][2].text, "0.200");
    expect_texts(grid.rows[0], {{4, "0.250"}, {5, "0.125"}, {6, "80"}, {8, "0.800"}});
    EXPECT_EQ(grid.rows[1][8].text, "1.200");
}

TEST(PaperTables, TheTolerancesStandBesideEachOther) {
    ReportData data;
    add_scene(data, "paper_tolerance", "rotation_step");
    const auto add = [&](const char* axes, double ns, double separated) {
        MadeUp figures = times(ns);
        figures.insert({{"error.mean_steps.warm", ns / 10}, {"error.separated", separated}});
        if (*axes) figures["error.wrong_verdicts"] = 0;
        data.from_files.push_back(
            made_up_cell("paper_tolerance", "gjk", R"({"rotation_step":0.1})", figures));
        data.from_files.back().axes = axes;
    };
    add("", 100, 90);
    add("contact_tolerance=1e-05", 50, 85);
    const TextGrid grid = tolerance_grid(data);
    ASSERT_EQ(grid.rows.size(), 1U);
    ASSERT_EQ(grid.rows[0].size(), grid.columns.size());
    const std::vector<GridCell>& row = grid.rows[0];
    expect_texts(row, {{3, "100"}, {4, "50"}, {5, "0.500"}, {7, "5"}, {8, "90"}, {9, "85"}, {10, "0"}});
}

TEST(PaperTables, NearnessStandsBesideTheOtherNeeds) {
    ReportData data;
    add_scene(data, "paper_needs", "");
    const auto add = [&](const char* axes, const MadeUp& figures) {
        data.from_files.push_back(made_up_cell("paper_needs", "gjk", "{}", figures));
        data.from_files.back().axes = axes;
    };
    add("", {{"time.all_ns", 100}, {"lines.lines_per_query.warm", 9}});
    add("needs=certificate", {{"time.all_ns", 400}});
    add("needs=nearer+margin=1", {{"time.all_ns", 12}});
    add("needs=nearer+margin=0.1",
        {{"time.all_ns", 8}, {"lines.lines_per_query.warm", 0.5}, {"work.told_by_bounds", 0.912}});
    const TextGrid grid = all_needs_grid(data);
    ASSERT_EQ(grid.rows.size(), 4U);
    EXPECT_EQ(grid.rows[0].size(), grid.columns.size());
    EXPECT_EQ(grid.rows[0][3].text, "nearer, margin 0.1");
    EXPECT_EQ(grid.rows[1][3].text, "nearer, margin 1");
    EXPECT_EQ(grid.rows[2][3].text, "witnesses");
    EXPECT_EQ(grid.rows[3][3].text, "certificate");
    expect_texts(grid.rows[0], {{4, "8"}, {5, "0.080"}, {6, "0.500"}, {7, "0.912"}});
    EXPECT_FALSE(grid.rows[3][7].why.empty()) << "no bounds were asked";
}

TEST(PaperTables, RobustnessIsInPercentWithItsNumber) {
    ReportData data;
    add_scene(data, "paper_static", "");
    add_both(data, "paper_static", "{}",
             {{"error.checked", 400},
              {"error.wrong_verdicts", 0},
              {"error.control_checked", 200},
              {"error.control_disagreements", 5},
              {"error.control_disagreements_outside_band", 0}});
    const TextGrid grid = robustness_grid(data);
    ASSERT_EQ(grid.rows.size(), 4U) << "each algorithm in all scenes and in the one";
    expect_texts(grid.rows[0], {{3, "400"}, {4, "0"}});
    EXPECT_FALSE(grid.rows[0][5].why.empty()) << "pairs in the band were not counted";
    expect_texts(grid.rows[0], {{7, "2.5 (5)"}, {8, "0"}});
}

/// V-Clip on aos_f64 at the slowest and the fastest rotation: memory time and the knee of the pages.
void add_thrash(ReportData& data, int vertices, double memory_ns, double page_knee) {
    const std::string scene = "paper_thrash_" + std::to_string(vertices);
    add_scene(data, scene, "rotation_step");
    for (const char* step : {"0.0166667", "3.1415927"})
        add_both(data, scene, std::string(R"({"bodies":300,"rotation_step":)") + step + "}",
                 {{"caches.pentium3_coppermine.modelled_memory_ns.warm", memory_ns},
                  {"reuse.line_knee_bytes.warm", page_knee / 8},
                  {"reuse.page_knee_bytes.warm", page_knee}});
}

ReportData made_up(double memory_ns, double page_knee) {
    ReportData data;
    add_thrash(data, 8, 5000, 1e6);
    add_thrash(data, 38, 10000, 2e6);
    add_thrash(data, 386, memory_ns, page_knee);
    return data;
}

constexpr double thrashing = 2e5, calm = 2e4;  ///< memory time, ns: 20 times and twice that of 38 vertices
constexpr double large = 1e8, small = 4e6;     ///< pages, bytes: more than 64 MiB, and not with 1000 bodies

TEST(PaperThrash, IsTheCache) {
    const std::string text = thrash_paragraph(made_up(thrashing, small));
    EXPECT_THAT(text, StartsWith("It is the cache, not paging"));
    EXPECT_THAT(text, AllOf(HasSubstr("on-board cache\" (section 5) holds"), HasSubstr("by a factor of 20"),
                            HasSubstr("swapping) does not account for it")));
}

TEST(PaperThrash, IsPaging) {
    const std::string text = thrash_paragraph(made_up(calm, large));
    EXPECT_THAT(text, StartsWith("It is paging, not the cache"));
    EXPECT_THAT(text, AllOf(HasSubstr("swapping) holds"), HasSubstr("the tables do not fit the cache")));
    // 300 bodies use 1e8 bytes: 64 MiB are too little from 300 x 67108864 / 1e8 = 201.3 on.
    EXPECT_THAT(text, HasSubstr("from 202 bodies of 386 vertices on"));
    EXPECT_THAT(text,
                HasSubstr("it passes 64 MiB from 386 vertices on, with 386 from 0.017 rad per step on"));
}

TEST(PaperThrash, IsBothOrNeither) {
    EXPECT_THAT(thrash_paragraph(made_up(thrashing, large)), StartsWith("Both:"));
    EXPECT_THAT(thrash_paragraph(made_up(calm, small)), StartsWith("Neither"));
}

/// A factor of 12 in what takes next to no time makes no figure.
TEST(PaperThrash, IsNotACacheThatCostsNothing) {
    ReportData data;
    add_thrash(data, 38, 10, 2e6);
    add_thrash(data, 386, 200, small);
    EXPECT_EQ(cache_is_a_cause(data), false);
}

/// If bodies of 38 vertices page as well, paging is not what sets 386 apart.
TEST(PaperThrash, IsNotPagingAtEverySize) {
    ReportData data;
    add_thrash(data, 38, 10, large);
    add_thrash(data, 386, 10, large);
    EXPECT_EQ(paging_is_a_cause(data), false);
}

TEST(PaperThrash, HeedsMeasuredFaults) {
    ReportData data = made_up(calm, small);
    ReportCell row = made_up_cell(
        "paging", "vclip", R"({"bodies":600})",
        {{"paging.limit_bytes.0", 2e8}, {"paging.held_bytes.0", 1e8}, {"paging.faults_per_query.0", 0.5}});
    row.vertices = 386;
    data.paging.push_back(row);
    EXPECT_EQ(paging_is_a_cause(data), true);
    EXPECT_THAT(thrash_paragraph(data), HasSubstr("600 bodies: 0.500 faults per query with 95.37 MiB"));
    data.paging[0].figures = figures_of(
        {{"paging.limit_bytes.0", 2e8}, {"paging.held_bytes.0", 1e8}, {"paging.faults_per_query.0", 0}});
    EXPECT_EQ(paging_is_a_cause(data), false);
    EXPECT_EQ(paging_grid(data).rows.size(), 1U);
}

TEST(PaperThrash, SaysWhatIsMissing) {
    const std::string nothing = thrash_paragraph({});
    EXPECT_THAT(nothing, AllOf(HasSubstr("Whether the cache makes figure 8 is not known"),
                               HasSubstr("Whether paging makes it is not known"),
                               HasSubstr("no verified cell of paper_thrash_386"),
                               HasSubstr("the store holds no paging run"), Not(HasSubstr("nan"))));
    ReportData data = made_up(thrashing, large);
    for (ReportCell& cell : data.from_files)
        for (store::FigureRow& figure : cell.figures)
            if (figure.probe == "caches") figure.value.reset(), figure.reason = "not modelled here";
    EXPECT_FALSE(cache_is_a_cause(data));
    EXPECT_THAT(thrash_paragraph(data), AllOf(HasSubstr("not modelled here"), HasSubstr("Paging makes it."),
                                              HasSubstr("(section 5) cannot be judged")));
}

TEST(PaperThrash, TellsWhatLayoutsDoToIt) {
    ReportData data = made_up(thrashing, large);
    ReportCell lean = made_up_cell("paper_thrash_386", "vclip", R"({"bodies":300,"rotation_step":0.0166667})",
                                   {{"caches.pentium3_coppermine.modelled_memory_ns.warm", thrashing / 4},
                                    {"reuse.line_knee_bytes.warm", large / 16},
                                    {"reuse.page_knee_bytes.warm", large / 2}});
    lean.layout = "lean", lean.table = "lean_f64";
    data.from_files.push_back(lean);
    EXPECT_THAT(thrash_paragraph(data), HasSubstr("lean_f64 0.500, 0.500, 0.250"));
    EXPECT_EQ(thrash_grid(data).rows.size(), data.from_files.size());
}

/// The paragraph has the times of this machine, or says that they are missing.
TEST(PaperThrash, TellsWhatThisMachineDoes) {
    ReportData data = made_up(calm, large);
    EXPECT_THAT(thrash_paragraph(data), HasSubstr("On this machine it was not timed"));
    for (const int vertices : {38, 386}) {
        const std::string scene = "paper_angular_" + std::to_string(vertices);
        add_scene(data, scene, "rotation_step");
        add_both(data, scene, R"({"rotation_step":3.1415927})",
                 {{"time.all_ns", vertices == 38 ? 1000.0 : 15000.0}});
    }
    EXPECT_THAT(thrash_paragraph(data), HasSubstr("rises from 1 to 15 us, by a factor of 15 at half a turn"));
}

// The chapter shows raw V-Clip next to the hardened cell of the same queries; no claim uses raw V-Clip.

ReportData static_data(double raw_wrong) {
    ReportData data;
    add_scene(data, "paper_static", "");
    add_both(data, "paper_static", "{}",
             {{"error.checked", 1000},
              {"error.wrong_verdicts", 0},
              {"error.wrong_answers", 0},
              {"error.fallbacks", 7},
              {"error.refinements", 4},
              {"error.cycles", 0}});
    ReportCell raw = made_up_cell("paper_static", "vclip", "{}",
                                  {{"error.checked", 1000},
                                   {"error.wrong_verdicts", raw_wrong},
                                   {"error.wrong_answers", raw_wrong > 0 ? raw_wrong + 5 : 0},
                                   {"error.cycles", 2}});
    raw.table = "aos_f64 hardening=off";
    raw.axes = "hardening=off";
    raw.status = store::CellStatus::judged;
    data.from_files.push_back(raw);
    return data;
}

TEST(RawVClipGrid, StandsBesideTheHardenedOne) {
    const TextGrid right = raw_vclip_grid(static_data(0)), wrong = raw_vclip_grid(static_data(25));
    ASSERT_EQ(right.rows.size(), 1U);
    EXPECT_THAT(texts_of(right.rows[0]),
                testing::ElementsAre("paper_static", "sphere", "aos_f64 hardening=off", "1000", "0", "0",
                                     "0.003 (3/n)", "2", "0", "11"));
    EXPECT_EQ(wrong.rows[0][4].text, "30");
    EXPECT_EQ(wrong.rows[0][5].text, "25");
    EXPECT_EQ(wrong.rows[0][6].text, "0.03");
}

/// A wrong distance in a hard family counts as a wrong answer; its share is then shown without the bound 3/n.
TEST(RawVClipGrid, CountsWrongDistancesOfFamilies) {
    ReportData data;
    ReportCell raw = made_up_cell("stability", "vclip", "{}",
                                  {{"stability.cases", 100},
                                   {"stability.wrong_outside_band", 0},
                                   {"stability.wrong_answers", 1},
                                   {"stability.cycles", 0}});
    raw.run = "stability";
    raw.axes = "hardening=off";
    raw.table = "aos_f64 hardening=off";
    data.stability.push_back(raw);
    const TextGrid grid = raw_vclip_grid(data);
    ASSERT_EQ(grid.rows.size(), 1U);
    EXPECT_EQ(grid.rows[0][4].text, "1");
    EXPECT_EQ(grid.rows[0][5].text, "0");
    EXPECT_EQ(grid.rows[0][6].text, "0.01");
}

TEST(RawVClipGrid, FailsNoClaim) {
    const auto verdict_of = [](const ReportData& data) {
        for (const Claim& claim : judge_claims(data))
            if (claim.id == "zero_failures_exact") return claim.ours;
        return std::string();
    };
    EXPECT_EQ(verdict_of(static_data(25)), verdict_of(static_data(0)));
    EXPECT_THAT(verdict_of(static_data(25)), testing::HasSubstr("answers checked 2000"));
}

/// A library has its own algorithm and table; its time is compared with V-Clip on the paper's record.
TEST(StaticGrid, HasLibrariesInPlaceOfGjkAndNoRawVClip) {
    ReportData data = static_data(0);
    ReportCell peer = made_up_cell("paper_static", "openGJK", "{}", times(50));
    peer.table = "opengjk_f64";
    peer.status = store::CellStatus::judged;
    for (ReportCell& cell : data.from_files) cell.figures = figures_of(times(100));
    data.from_files.push_back(peer);
    const TextGrid grid = static_grid(data);
    ASSERT_EQ(grid.rows.size(), 2U);
    EXPECT_EQ(grid.rows[0][2].text, "aos_f64");
    EXPECT_EQ(grid.rows[1][2].text, "opengjk_f64");
    EXPECT_EQ(grid.rows[1][3].text, grid.rows[0][3].text);
    EXPECT_EQ(grid.rows[1][5].text, "0.500");
}

}  // namespace
}  // namespace edgewise::reports
