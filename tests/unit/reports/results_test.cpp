// SPDX-License-Identifier: MIT
//
// The results as files: read back, they are the store's numbers to the bit, and no text of theirs is a
// formula to a spreadsheet.
#include "edgewise/reports/results/export.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <set>

#include "../complaint.hpp"
#include "csv_reader.hpp"
#include "edgewise/reports/page/report.hpp"
#include "made_up_data.hpp"
#include "report_store.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;

/// Returns one scene with two cells, breakdowns and extreme numbers; the second cell lacks one figure.
ReportData two_cells() {
    ReportData data;
    data.build.id = "b";
    const MadeUp values = {{"time.all_ns", 0.1},
                           {"time.all_ratio", -1.0 / 3},
                           {"error.worst_error_given", 5e-324},
                           {"bytes.table_bytes", 9007199254740993.0},
                           {"caches.zen5.L1.misses_per_query", 1e300},
                           {"caches.zen5/fifo.L1.misses_per_query", 7},
                           {"caches.zen5.L1.step.vertex_face", 8},
                           {"reuse.line_misses_at_2^12", 9}};
    MadeUp fewer = values;
    fewer.erase("time.all_ns");
    data.cells = {made_up_cell("cold", "vclip", "{\"a\":1}", values),
                  made_up_cell("cold", "gjk", "{\"a\":1}", fewer)};
    data.cells[0].hash = "1", data.cells[1].hash = "2";
    return data;
}

TEST(WideResults, ReadBackAreTheStoresNumbersToTheBit) {
    const ReportData data = two_cells();
    const CsvTable table(wide_results(data).at("cold.csv"));
    ASSERT_EQ(table.rows(), 2u);
    for (const ReportCell& cell : data.cells) {
        const std::size_t row = table.where("hash", cell.hash);
        EXPECT_EQ(table.text(row, "algorithm"), cell.algorithm);
        EXPECT_EQ(table.text(row, "scene_parameters"), "{\"a\":1}");
        std::size_t found = 0;
        for (const store::FigureRow& figure : cell.figures) {
            const std::string key = figure_key(figure);
            if (!main_place(key)) continue;
            ++found;
            EXPECT_EQ(std::strtod(table.raw(row, key).c_str(), nullptr), *figure.value) << key;
        }
        EXPECT_EQ(found, cell.hash == "1" ? 5u : 4u);
    }
    EXPECT_EQ(table.raw(table.where("hash", "2"), "time.all_ns"), "") << "not measured is no number";
}

TEST(WideResults, LeaveBreakdownsToTheStore) {
    const CsvTable table(wide_results(two_cells()).at("cold.csv"));
    EXPECT_TRUE(table.has("caches.zen5.L1.misses_per_query"));
    for (const char* breakdown : {"caches.zen5/fifo.L1.misses_per_query", "caches.zen5.L1.step.vertex_face",
                                  "reuse.line_misses_at_2^12"})
        EXPECT_FALSE(table.has(breakdown)) << breakdown;
}

TEST(WideResults, SayWhyFieldsAreEmptyAndWhatColumnsAre) {
    ReportData data = two_cells();
    data.cells[1].figures.push_back({{"all_ns", std::nullopt, "ns", "no clock", "bring one"}, "time"});
    const auto files = wide_results(data);
    const CsvTable missing(files.at("about/not_measured.csv"));
    ASSERT_EQ(missing.rows(), 1u);
    EXPECT_EQ(missing.text(0, "file"), "cold.csv");
    EXPECT_EQ(missing.text(0, "figure"), "time.all_ns");
    EXPECT_EQ(missing.text(0, "cells"), "1");
    EXPECT_EQ(missing.text(0, "reason"), "no clock");
    EXPECT_EQ(missing.text(0, "remedy"), "bring one");
    const CsvTable about(files.at("about/columns.csv"));
    const std::size_t row = about.where("figure", "time.all_ns");
    EXPECT_EQ(about.text(row, "population"), "steady");
    EXPECT_EQ(about.text(row, "repeats"), "timed");
    EXPECT_EQ(about.text(about.where("figure", "bytes.table_bytes"), "repeats"), "exactly");
}

/// Names of files are letters, digits, '_' and '-': none leaves the folder.
TEST(WideResults, AreAFilePerSceneAndRun) {
    ReportData data = two_cells();
    data.from_files = {made_up_cell("../mine", "gjk", "{}", {{"time.all_ns", 3}})};
    const std::pair<std::vector<ReportCell>*, const char*> studies[] = {
        {&data.effort, "effort"}, {&data.stability, "stability"}, {&data.paging, "paging"},
        {&data.thrash, "thrash"}, {&data.fields, "fields"},       {&data.other_studies, "scratch"}};
    for (const auto& [rows, run] : studies) {
        *rows = {made_up_cell("tumble", "gjk", "{}", {{"time.all_ns", 4}})};
        rows->front().run = run;
    }
    data.peers = {made_up_cell("static", "gjk", "{}", {{"time.all_ns", 5}})};
    std::vector<std::string> names;
    for (const auto& [name, text] : wide_results(data)) names.push_back(name);
    EXPECT_THAT(
        names, testing::UnorderedElementsAre("cold.csv", "___mine.csv", "static.csv", "effort_tumble.csv",
                                             "stability_tumble.csv", "paging_tumble.csv", "thrash_tumble.csv",
                                             "fields_tumble.csv", "scratch_tumble.csv", "about/columns.csv",
                                             "about/not_measured.csv"));
}

TEST(CsvRow, TextsAreNoFormulasAndComeBack) {
    const std::vector<std::string> texts = {"=1+1", "+1", "-1",           "@sum(a1)", "'quoted'", "\ttab",
                                            "a,b",  "\"", "two\r\nlines", "=\"a\",b", "",         "a=b"};
    CsvRow header, row;
    for (std::size_t i = 0; i < texts.size(); ++i) header.text("c" + std::to_string(i)), row.text(texts[i]);
    const CsvTable table(header.line() + row.line());
    ASSERT_EQ(table.rows(), 1u);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const std::string column = "c" + std::to_string(i), raw = table.raw(0, column);
        EXPECT_EQ(table.text(0, column), texts[i]);
        EXPECT_TRUE(raw.empty() || std::string("=+-@\t").find(raw[0]) == std::string::npos) << raw;
    }
}

TEST(CsvRow, NumbersAreNotTouched) {
    EXPECT_EQ(CsvRow().number(-1.5).number(std::nullopt).field(-3).field(~0ull).number(5e-324).line(),
              "-1.5,,-3,18446744073709551615,5e-324\r\n");
}

TEST_F(Report, HasEveryCellOfTheBuildInItsResults) {
    (void)write_report(make_store(), (directory_ / "out").string(), "");
    const CsvTable fixed(text("out/results/static.csv")), turning(text("out/results/tumble.csv"));
    EXPECT_EQ(fixed.rows(), 3u);
    EXPECT_EQ(turning.rows(), 2u);
    for (const char* hash : {"h-full", "h-bare", "h-failed"})
        EXPECT_NO_THROW((void)fixed.where("hash", hash));
    EXPECT_EQ(fixed.text(fixed.where("hash", "h-failed"), "status_reason"),
              "3 wrong verdicts, \"first\" at 17");
    EXPECT_EQ(std::stod(fixed.raw(fixed.where("hash", "h-full"), "error.worst_error_given")), 2.5e-16);
    const std::size_t null = turning.where("hash", "h-null");
    EXPECT_EQ(turning.text(null, "shape"), "cow</script><b>&\"");
    EXPECT_EQ(turning.raw(null, "time.overlapping_ns"), "");
    const CsvTable missing(text("out/results/about/not_measured.csv"));
    EXPECT_NO_THROW((void)missing.where("reason", "no overlapping pair in this cell"));
    EXPECT_NO_THROW((void)missing.where("reason", "the cell is unavailable: mesh unreadable"));
}

TEST_F(Report, LeavesNoResultsOfAnEarlierStore) {
    fs::create_directories(directory_ / "out" / "results");
    input::write_output(directory_ / "out" / "results" / "gone.csv", "old\r\n");
    (void)write_report(make_store(), (directory_ / "out").string(), "");
    EXPECT_FALSE(fs::exists(directory_ / "out" / "results" / "gone.csv"));
}

// Compares the output of `edgewise export` with the exported data.

ReportData data_to_export() {
    ReportData data;
    const MadeUp values = {{"time.all_ns", 0.3},
                           {"caches.zen5.L1.step.edge_edge", 2.0 / 3},
                           {"caches.zen5.L1.step.vertex_face", 8}};
    data.cells = {made_up_cell("cold", "vclip", "{}", values), made_up_cell("cold", "gjk", "{}", values),
                  made_up_cell("tumble", "gjk", "{}", {{"time.all_ns", 7}})};
    data.cells[1].layout = "lean", data.cells[1].table = "lean_f64";
    for (std::size_t i = 0; i < 3; ++i) data.cells[i].hash = std::to_string(i);
    data.cells[1].figures.push_back({{"all_ns_low", std::nullopt, "ns", "one round", "time more"}, "time"});
    return data;
}

std::string line_thrown_by(const ExportChoice& choice) {
    return complaint_of([&] { return export_text(data_to_export(), choice); });
}

/// "hash probe.figure" of every row.
std::set<std::string> rows_of_export(const CsvTable& table) {
    std::set<std::string> rows;
    for (std::size_t i = 0; i < table.rows(); ++i)
        rows.insert(table.text(i, "hash") + " " + table.text(i, "probe") + "." + table.text(i, "figure"));
    return rows;
}

TEST(Export, IsOfMainFiguresUnlessAskedForMore) {
    EXPECT_THAT(rows_of_export(CsvTable(export_text(data_to_export(), {}))),
                testing::UnorderedElementsAre("0 time.all_ns", "1 time.all_ns", "1 time.all_ns_low",
                                              "2 time.all_ns"));
}

TEST(Export, HasBreakdownsByPatternAndEveryNumberToTheBit) {
    const ReportData data = data_to_export();
    const CsvTable table(export_text(data, {.figures = {"*"}}));
    std::size_t figures = 0, row = 0;
    for (const ReportCell& cell : data.cells)
        for (const store::FigureRow& figure : cell.figures) {
            ASSERT_LT(row, table.rows());
            EXPECT_EQ(table.text(row, "hash"), cell.hash);
            EXPECT_EQ(table.text(row, "figure"), figure.name);
            if (figure.value) {
                EXPECT_EQ(std::stod(table.raw(row, "value")), *figure.value) << figure.name;
            }
            ++row, ++figures;
        }
    EXPECT_EQ(table.rows(), figures);
    const std::size_t null = table.where("state", "not measured");
    EXPECT_EQ(table.raw(null, "value"), "");
    EXPECT_EQ(table.text(null, "reason"), "one round");
    EXPECT_EQ(table.text(null, "remedy"), "time more");
}

TEST(Export, ChoosesScenesLayoutsAndTableTypes) {
    const ReportData data = data_to_export();
    EXPECT_THAT(rows_of_export(CsvTable(export_text(data, {.figures = {"*.step.*"}, .layouts = {"lean"}}))),
                testing::UnorderedElementsAre("1 caches.zen5.L1.step.edge_edge",
                                              "1 caches.zen5.L1.step.vertex_face"));
    EXPECT_THAT(rows_of_export(CsvTable(export_text(data, {.scenes = {"tumble"}, .layouts = {"aos_f64"}}))),
                testing::UnorderedElementsAre("2 time.all_ns"));
}

/// A cell without any chosen figure does not vanish.
TEST(Export, HasARowForEveryChosenCell) {
    const CsvTable table(export_text(data_to_export(), {.figures = {"*.step.edge_edge"}}));
    EXPECT_EQ(table.rows(), 3u);
    EXPECT_EQ(table.text(table.where("hash", "2"), "reason"), "no such figure is stored");
}

TEST(Export, IsTheSameAsJson) {
    const ReportData data = data_to_export();
    const auto all =
        nlohmann::json::parse(export_text(data, {.figures = {"*"}, .format = ExportFormat::json}))["cells"];
    ASSERT_EQ(all.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(all[i]["hash"], data.cells[i].hash);
        ASSERT_EQ(all[i]["figures"].size(), data.cells[i].figures.size());
        for (std::size_t k = 0; k < data.cells[i].figures.size(); ++k) {
            const store::FigureRow& figure = data.cells[i].figures[k];
            const auto& found = all[i]["figures"][k];
            EXPECT_EQ(found["figure"], figure.probe + "." + figure.name);
            EXPECT_EQ(found["value"].is_null(), !figure.value);
            EXPECT_EQ(found.contains("reason"), !figure.value);
            if (figure.value) {
                EXPECT_EQ(found["value"].get<double>(), *figure.value);
            }
        }
    }
}

TEST(Export, OfWhatIsNotThereIsOneLine) {
    EXPECT_THAT(line_thrown_by({.scenes = {"nope"}}),
                HasSubstr("unknown scene of the store 'nope'; known: cold, tumble"));
    EXPECT_THAT(line_thrown_by({.layouts = {"soa"}}),
                HasSubstr("unknown layout or table type of the store 'soa'"));
    EXPECT_THAT(line_thrown_by({.figures = {"time.*", "nope.*"}}), HasSubstr("matches 'nope.*'"));
}

}  // namespace
}  // namespace edgewise::reports
