// SPDX-License-Identifier: MIT
//
// Compares the output of `edgewise export` with the exported data.
#include "edgewise/reports/results/export.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "csv_reader.hpp"
#include "made_up_data.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;

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
    try {
        (void)export_text(data_to_export(), choice);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "nothing thrown";
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
