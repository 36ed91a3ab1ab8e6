// SPDX-License-Identifier: MIT
//
// Machine records: what of a store goes into them and what must not, and which table wins where.
#include "edgewise/reports/records/machine_record.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "../../complaint.hpp"
#include "../made_up_data.hpp"

namespace edgewise::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

measure::Round round(int number, double ratio) {
    measure::Round result;
    result.number = number;
    result.timing.separated_queries = result.baseline.separated_queries = 1000;
    result.timing.separated_ns = ratio * 1e6;
    result.baseline.separated_ns = 1e6;
    return result;
}

ReportCell cell(const std::string& table, double ratio, double modelled_ns) {
    ReportCell result = base_cell("tumble", "sphere386", "vclip", "aos");
    result.scene_parameters = R"({"rotation_step":0.1})";
    result.table = table;
    result.figures = {{{"all_ns", 100 * ratio, "ns", "", ""}, "time"},
                      {{"all_ratio", ratio, "1", "", ""}, "time"},
                      {{"total_bytes_per_edge", 12.5, "B/edge", "", ""}, "bytes"},
                      {{"zen5.modelled_memory_ns", modelled_ns, "ns, model", "", ""}, "caches"}};
    for (int i = 0; i < 8; ++i) result.rounds.push_back(round(i, ratio * (1 + 0.001 * (i - 4))));
    return result;
}

ReportData data_of_a_sweep() {
    ReportData data;
    data.build.machine_json =
        R"({"host":"secret-host","cpu":{"vendor":"V","name":"Fast 9000","cores":4,"serial":"123"},)"
        R"("caches":[{"level":1,"type":"Data","bytes":32768,"ways":8,"line_bytes":64,"shared_cpus":"0-1"}]})";
    data.cells = {cell("aos_f64", 1, 100), cell("lean_f32", 0.5, 40), cell("lean_f64", 0.6, 60)};
    return data;
}

TEST(MachineRecord, HoldsRatiosCachesAndNoNames) {
    ReportData data = data_of_a_sweep();
    data.cells.push_back(cell("linked_f64", 2, 200));
    data.cells.back().shape = "secret_part";
    data.cells.back().shape_source = "secret/part.stl";
    data.cells.push_back(cell("soa_f64", 3, 300));
    data.cells.back().status = store::CellStatus::failed;
    const measure::FigureRecord record = measured_record(data);
    EXPECT_THAT(record.with, testing::IsSupersetOf(measure::Conditions{
                                 {"machine", "Fast 9000"}, {"times", "measured"}, {"cpu.cores", "4"}}));
    ASSERT_EQ(record.rows.size(), 6U) << "a ratio and bytes of three tables";
    const measure::RecordRow& lean = record.rows[2];
    EXPECT_EQ(lean.cell, R"(tumble {"rotation_step":0.1} sphere386 vclip lean_f32)");
    EXPECT_EQ(lean.value, 0.5);
    EXPECT_LT(lean.low, 0.5);
    EXPECT_GT(lean.high, 0.5);
    EXPECT_EQ(record.rows[3].value, 12.5);
    const std::string text = to_json(record);
    for (const char* hidden : {"secret", "123", "shared_cpus"})
        EXPECT_THAT(text, Not(HasSubstr(hidden))) << hidden;
    EXPECT_THAT(text, HasSubstr("32768"));
    EXPECT_EQ(to_json(measure::parse_record(text, "file", machine_kind)), text);
    EXPECT_THAT(complaint_of([] { return measured_record({}); }), HasSubstr("edgewise sweep"));
}

measure::CacheMachine machine_named(const std::string& name) {
    measure::CacheMachine machine;
    machine.name = name;
    return machine;
}

TEST(MachineRecord, OfAModelSaysSo) {
    const measure::FigureRecord record = modelled_record(data_of_a_sweep(), machine_named("zen5"));
    ASSERT_EQ(record.rows.size(), 6U);
    EXPECT_EQ(record.rows[2].value, 0.4);
    EXPECT_THAT(to_json(record), HasSubstr("no such machine was measured"));
    EXPECT_THAT(complaint_of([] { return modelled_record(data_of_a_sweep(), machine_named("zen2")); }),
                HasSubstr("--machines zen2"));
}

measure::FigureRecord made_up(const std::string& machine, std::vector<measure::RecordRow> rows) {
    return {machine_kind, {}, {{"machine", machine}, {"times", "measured"}}, {}, std::move(rows)};
}

TEST(CompareRecords, FirstPlacesAreSharedWhereIntervalsMeet) {
    const auto row = [](const char* shape, const char* table, double low, double ratio, double high) {
        return measure::RecordRow{
            fmt::format("tumble {{}} {} vclip {}", shape, table), ratio_figure, ratio, low, high, true};
    };
    const std::vector<measure::FigureRecord> records = {
        made_up("one", {row("cube8", "aos_f64", 0.9, 1, 1.1), row("cube8", "lean_f32", 0.7, 0.75, 0.8)}),
        made_up("two", {row("cube8", "aos_f64", 0.9, 1, 1.1), row("cube8", "lean_f32", 0.8, 0.95, 1.0),
                        row("tetra4", "aos_f64", 0.9, 1, 1.1)}),
        made_up("three", {row("cube8", "aos_f64", 0.9, 1, 1.1), row("cube8", "lean_f32", 1.2, 1.3, 1.4)})};
    const auto compared = compare_records(records);
    ASSERT_EQ(compared.size(), 2U);
    EXPECT_THAT(compared[0].machines[0]->tables, ElementsAre("lean_f32"));
    EXPECT_THAT(compared[0].machines[1]->tables, ElementsAre("lean_f32", "aos_f64"));
    EXPECT_THAT(compared[0].machines[2]->tables, ElementsAre("aos_f64"));
    EXPECT_TRUE(compared[0].first_everywhere.empty());
    EXPECT_THAT(compare_records(std::span(records).first(2))[0].first_everywhere, ElementsAre("lean_f32"));
    EXPECT_FALSE(compared[1].machines[0]);
    EXPECT_THAT(comparison_text(records), HasSubstr("1 of 2 questions"));
    EXPECT_EQ(comparison_json(records)["questions"].size(), 2U);
}

}  // namespace
}  // namespace edgewise::reports
