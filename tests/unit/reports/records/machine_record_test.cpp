// SPDX-License-Identifier: MIT
//
// Machine records: what of a store goes into them and what must not, that they are read as they were written,
// and who wins where.
#include "edgewise/reports/records/machine_record.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "edgewise/reports/records/compare_records.hpp"

namespace edgewise::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

measure::Round round(int number, double ratio) {
    measure::Round result;
    result.number = number;
    result.timing.separated_queries = result.baseline.separated_queries = 1000;
    result.timing.separated_ns = ratio * 1e6;
    result.baseline.separated_ns = 1e6;
    return result;
}

ReportCell cell(const std::string& table, double ratio, double modelled_ns) {
    ReportCell result;
    result.scene = "tumble";
    result.scene_parameters = R"({"rotation_step":0.1})";
    result.shape = "sphere386";
    result.shape_source = "built-in";
    result.algorithm = "vclip";
    result.table = table;
    result.status = store::CellStatus::verified;
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

std::string line_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const std::runtime_error& problem) {
        return problem.what();
    }
    return "nothing thrown";
}

TEST(MachineRecord, HoldsRatiosCachesAndNoNames) {
    ReportData data = data_of_a_sweep();
    data.cells.push_back(cell("linked_f64", 2, 200));
    data.cells.back().shape = "secret_part";
    data.cells.back().shape_source = "secret/part.stl";
    data.cells.push_back(cell("soa_f64", 3, 300));
    data.cells.back().status = store::CellStatus::failed;
    const MachineRecord record = measured_record(data);
    EXPECT_EQ(record.machine, "Fast 9000");
    EXPECT_FALSE(record.is_model);
    ASSERT_EQ(record.rows.size(), 3U);
    EXPECT_EQ(record.rows[1].table, "lean_f32");
    EXPECT_EQ(record.rows[1].ratio, 0.5);
    EXPECT_LT(record.rows[1].low, 0.5);
    EXPECT_GT(record.rows[1].high, 0.5);
    EXPECT_EQ(record.rows[1].bytes_per_edge, 12.5);
    const std::string text = to_json(record).dump();
    for (const char* hidden : {"secret", "123", "shared_cpus"})
        EXPECT_EQ(text.find(hidden), text.npos) << hidden;
    EXPECT_THAT(text, HasSubstr("32768"));
}

TEST(MachineRecord, IsReadAsItWasWritten) {
    const MachineRecord record = measured_record(data_of_a_sweep());
    const MachineRecord read = parse_record(to_json(record).dump(), "file");
    EXPECT_EQ(to_json(read), to_json(record));
    EXPECT_EQ(read.rows[2].question(), record.rows[2].question());
}

TEST(MachineRecord, OfAModelSaysSo) {
    const MachineRecord record = modelled_record(data_of_a_sweep(), "zen5");
    EXPECT_TRUE(record.is_model);
    ASSERT_EQ(record.rows.size(), 3U);
    EXPECT_EQ(record.rows[1].ratio, 0.4);
    EXPECT_THAT(to_json(record)["times"].get<std::string>(), HasSubstr("no such machine was measured"));
    EXPECT_THAT(line_of([] { static_cast<void>(modelled_record(data_of_a_sweep(), "zen2")); }),
                HasSubstr("--machines zen2"));
}

TEST(MachineRecord, WhatIsNoneIsOneLine) {
    const std::string right = to_json(measured_record(data_of_a_sweep())).dump();
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"{\"edgewise", "[\"edgewise"},
             {"\"edgewise_machine_record\":1", "\"edgewise_machine_record\":2"},
             {"\"ratio\":0.5", "\"ratio\":-1"},
             {"\"table\":\"lean_f32\"", "\"table\":3"},
             {"\"rows\":[", "\"row\":["}}) {
        std::string wrong = right;
        const auto at = wrong.find(from);
        ASSERT_NE(at, wrong.npos) << from;
        wrong.replace(at, from.size(), to);
        EXPECT_THAT(line_of([&] { static_cast<void>(parse_record(wrong, "theirs.json")); }),
                    testing::StartsWith("theirs.json: "))
            << to;
    }
    EXPECT_THAT(line_of([] { static_cast<void>(measured_record({})); }), HasSubstr("edgewise sweep"));
}

MachineRecord made_up(const std::string& machine, std::vector<RecordRow> rows) {
    MachineRecord record;
    record.machine = machine;
    record.rows = std::move(rows);
    return record;
}

TEST(CompareRecords, FirstPlacesAreSharedWhereIntervalsMeet) {
    const auto row = [](const char* shape, const char* table, double low, double ratio, double high) {
        return RecordRow{"tumble", "{}", shape, "vclip", table, ratio, low, high, {}};
    };
    const std::vector<MachineRecord> records = {
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
