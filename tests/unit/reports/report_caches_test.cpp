// SPDX-License-Identifier: MIT
//
// The report's chapter on caches, from synthetic figures with known tables.
#include <gmock/gmock.h>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/page/report.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "made_up_data.hpp"
#include "report_store.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;

/// Returns SQL for a traced cell with the given misses under LRU, tree-PLRU and random replacement.
std::string traced_sql(const std::string& hash, const std::string& precision, double lru, double plru,
                       double random) {
    std::string sql = cell_sql(hash, "static", "cube8", 8, "vclip", precision, "verified", "");
    const auto add = [&](const std::string& probe, const std::string& name, double value) {
        sql += figure_sql(hash, probe, name, std::to_string(value), "misses");
    };
    add("caches", "zen5.L1D.misses_per_query", lru);
    add("caches", "zen5/tree_plru.L1D.misses_per_query", plru);
    add("caches", "zen5/random.L1D.misses_per_query", random);
    add("caches", "zen5.L1 dTLB.misses_per_query", 0.5);
    add("caches", "zen5.L1D.field.vertex", lru / 2);
    add("caches", "zen5.L1D.step.settle", lru / 4);
    sql += figure_sql(hash, "caches", "zen5.modelled_memory_ns", "70", "ns, model of unverified latencies");
    add("reuse", "line_knee_bytes", 2048);
    add("reuse", "lines_per_query", lru);
    add("reuse", "line_misses_at_2^10", 5);
    add("reuse", "page_misses_at_2^14", 1);
    sql += figure_sql(hash, "caches", "host.L1D.misses_per_query", "null", "misses", "sysfs is silent");
    return sql;
}

std::string traced_store_sql() {
    return empty_store_sql() + "insert into build values('b2','r2','g++','-O3','Release','{}');" +
           "insert into meta values('build','b2');" + traced_sql("h-a", "f64", 10, 12, 11) +
           traced_sql("h-b", "f32", 8, 7, 14) + traced_sql("h-c", "mixed", 9.95, 12, 8.1) +
           cell_sql("h-d", "static", "cube8", 8, "gjk", "f64", "verified", "");
}

TEST_F(Report, OfCachesRanksByLinesAndNamesMachines) {
    const ReportData data = read_report(make_store(traced_store_sql()));
    const auto cells = modelled_cells(data);
    ASSERT_EQ(cells.size(), 3U) << "the cell without a trace is not there";
    EXPECT_EQ(cells[0]->table, "aos_f32");
    EXPECT_EQ(modelled_machines(data), (std::vector<std::string>{"host", "zen5"}));
    const TextGrid grid = misses_grid(data, "zen5");
    ASSERT_EQ(grid.rows.size(), 3U);
    EXPECT_THAT(texts_of(grid.rows[0]), testing::Contains("8"));
    EXPECT_EQ(working_sets_grid(data).rows.size(), 3U);
    EXPECT_THAT(texts_of(grid.rows[0]), testing::Contains("70 *")) << "no source proves its latencies";
    EXPECT_EQ(broken_down_levels(data, "zen5"), std::vector<std::string>{"L1D"}) << "not the TLB";
    EXPECT_EQ(breakdown_grid(data, "zen5", "L1D", misses_by_field).columns.back().title, "vertex");
    EXPECT_EQ(breakdown_grid(data, "zen5", "L1D", misses_by_step).columns.back().title, "settle");
}

/// f64 and f32 swap places under random replacement; f64 and mixed are a tie under LRU, which is no order.
TEST_F(Report, OfCachesSaysWhetherThePolicyMatters) {
    const TextGrid grid = policy_grid(read_report(make_store(traced_store_sql())));
    ASSERT_EQ(grid.rows.size(), 2U);
    EXPECT_EQ(texts_of(grid.rows[0])[3], "zen5/random");
    EXPECT_EQ(texts_of(grid.rows[0])[4], "L1D");
    EXPECT_THAT(texts_of(grid.rows[0]), testing::IsSupersetOf({"3", "2", "yes"}));
    EXPECT_THAT(grid.rows[0].back().text, testing::AllOf(HasSubstr("aos_f32"), HasSubstr("14")));
    EXPECT_THAT(texts_of(grid.rows[1]), testing::IsSupersetOf({"3", "0", "no"}));
}

/// 6 of 10 misses are answered by L2 in 5 ns, 4 by memory in 80.
TEST(MissesGrid, HasWhatQueriesWaitForOnTheMachineThatMeasuredItsLatencies) {
    ReportData data;
    data.build.id = "b";
    ReportCell cell;
    cell.status = store::CellStatus::verified;
    cell.figures = {{{"line_knee_bytes", 2048.0, "B"}, "reuse"},
                    {{"host.L1D.misses_per_query", 10.0, "misses"}, "caches"},
                    {{"host.L2.misses_per_query", 4.0, "misses"}, "caches"},
                    {{"host.modelled_memory_ns", std::nullopt, "ns", "not known"}, "caches"}};
    data.cells = {cell};
    EXPECT_EQ((misses_grid(data, "host").rows[0].end() - 2)->why, "not known");
    data.meta = {{"latencies_ns b", "[5, 80]"}};
    const TextGrid grid = misses_grid(data, "host");
    EXPECT_EQ((grid.rows[0].end() - 2)->text, "350");
    EXPECT_THAT(grid.caption, HasSubstr("5 ns in L2, 80 ns in memory"));
    data.meta = {{"latencies_ns another", "[5, 80]"}};
    EXPECT_EQ((misses_grid(data, "host").rows[0].end() - 2)->why, "not known");
}

TEST(PolicySentence, CountsPrefetchersApart) {
    ReportData data;
    for (const double misses : {10.0, 8.0}) {
        ReportCell cell;
        cell.status = store::CellStatus::verified, cell.table = misses > 9 ? "aos_f64" : "aos_f32";
        cell.figures = {{{"line_knee_bytes", 2048.0, "B"}, "reuse"},
                        {{"zen5.L1D.misses_per_query", misses, "misses"}, "caches"},
                        {{"zen5/random.L1D.misses_per_query", misses, "misses"}, "caches"},
                        {{"zen5/next_line.L1D.misses_per_query", 18 - misses, "misses"}, "caches"}};
        data.cells.push_back(cell);
    }
    EXPECT_EQ(
        policy_sentence(data),
        "Under tree-PLRU or random replacement instead of LRU, 0 of 1 pairs of tables change places by misses; "
        "with a next-line or a stream prefetcher, 1 of 1.");
}

TEST_F(Report, OfCachesDrawsMissesAgainstSize) {
    const Chart chart = misses_chart(read_report(make_store(traced_store_sql())));
    const ChartJson& values = chart.spec["data"]["values"];
    ASSERT_EQ(values.size(), 6U);
    EXPECT_EQ(values[0]["bytes"], 1024);
    fs::remove(directory_ / "store.db");
    EXPECT_TRUE(misses_chart(read_report(make_store())).spec.is_null()) << "nothing was traced";
}

TEST_F(Report, OfCachesIsInThePageOrSaysHowToGetIt) {
    (void)write_report(make_store(traced_store_sql()), (directory_ / "out").string(), "");
    EXPECT_THAT(text("out/index.html"), testing::AllOf(HasSubstr("2 of 6 pairs of tables change places"),
                                                       HasSubstr("sysfs is silent")));
    fs::remove(directory_ / "store.db");
    (void)write_report(make_store(), (directory_ / "out").string(), "");
    EXPECT_THAT(text("out/index.html"), HasSubstr("edgewise sweep --caches all"));
}

// Tables of effort from synthetic rows: the algorithms and libraries that they show, their order, the
// machines with simulated misses, and the chapter that shows the tables.

ReportCell made_up(store::CellStatus status, const std::string& name, std::optional<double> instructions) {
    ReportCell row;
    row.status = status;
    row.run = "effort";
    row.scene = "tumble", row.scene_label = "effort tumble";
    row.shape = "cube8";
    row.vertices = 8;
    row.algorithm = row.layout = name;
    row.precision = "f64";
    row.table = status == store::CellStatus::judged ? name + "_f64" : "lean_f64";
    row.figures = {{{"instructions", instructions, "1", "no valgrind"}, "effort"},
                   {{"zen5.d1_misses", 2.5, "1"}, "effort"},
                   {{"steps", std::nullopt, "steps", "not told"}, "effort"},
                   {{"instructions_over_floor", 12.0, "1"}, "effort"},
                   {{"table_bytes", 280.0, "B"}, "bytes"}};
    return row;
}

ReportData data_with_effort() {
    ReportData data;
    data.effort = {made_up(store::CellStatus::judged, "slow", 9000),
                   made_up(store::CellStatus::verified, "vclip", 700),
                   made_up(store::CellStatus::failed, "gjk", 10),
                   made_up(store::CellStatus::judged, "uncounted", std::nullopt)};
    return data;
}

TEST(EffortTables, StandFewestInstructionsFirstWithReasons) {
    const TextGrid grid = effort_grid(data_with_effort());
    ASSERT_EQ(grid.rows.size(), 3U) << "what failed was not measured";
    const char* const names[] = {"vclip", "slow", "uncounted"};
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(grid.rows[i].size(), grid.columns.size());
        EXPECT_EQ(cell_of(grid, i, "algorithm or library").text, names[i]);
    }
    EXPECT_EQ(cell_of(grid, 0, "table type or precision").text, "lean_f64");
    EXPECT_EQ(cell_of(grid, 1, "table type or precision").text, "f64");
    EXPECT_EQ(cell_of(grid, 0, "instructions").text, "700");
    EXPECT_EQ(cell_of(grid, 0, "D1 misses, zen5").text, "2.50");
    EXPECT_EQ(cell_of(grid, 0, "bytes of a table").text, "280");
    EXPECT_THAT(cell_of(grid, 2, "instructions").why, testing::HasSubstr("no valgrind"));
    EXPECT_THAT(cell_of(grid, 0, "steps").why, testing::HasSubstr("not told"));
    EXPECT_EQ(cell_of(effort_floor_grid(data_with_effort()), 0, "instructions per flop of it").text, "12");
}

TEST(EffortTables, StandInTheChapterOfPeers) {
    const auto chapter_of = [](const ReportData& data) {
        std::optional<Chapter> found;
        for (Chapter& chapter : report_chapters(answer_of(data), data, {}))
            if (chapter.id == "peers") found = std::move(chapter);
        return found;
    };
    EXPECT_FALSE(chapter_of({}));
    const auto chapter = chapter_of(data_with_effort());
    ASSERT_TRUE(chapter);
    EXPECT_EQ(chapter->blocks.back().title, "What a query takes");
    EXPECT_THAT(chapter->blocks.back().paragraph, testing::HasSubstr("Callgrind"));
    EXPECT_TRUE(data_with_effort().any_failed());
}

/// A row of any study that fails is a problem of the report.
TEST(Problems, AreOfTheRowsOfAllStudies) {
    for (auto rows : {&ReportData::stability, &ReportData::paging, &ReportData::thrash, &ReportData::effort,
                      &ReportData::fields, &ReportData::other_studies}) {
        ReportData data;
        (data.*rows).emplace_back().status = store::CellStatus::failed;
        EXPECT_TRUE(data.any_failed());
        EXPECT_EQ(problems_grid(data).rows.size(), 1U);
    }
}

}  // namespace
}  // namespace edgewise::reports
