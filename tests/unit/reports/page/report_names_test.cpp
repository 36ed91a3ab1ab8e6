// SPDX-License-Identifier: MIT
//
// A scene may have any name: that of a study, of a chapter, of a file of the report, one that begins like a
// scene that comes along, a very long one, or one with bytes that act on a terminal. Its cells are in the
// answer, the tables, the charts and the results, and nothing of the name acts.
#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "../answer/answer_cells.hpp"
#include "../report_store.hpp"
#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/page/report.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/results/export.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/store/store.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

const TimedCell scene_cells[] = {{"vclip", "aos", "f64", {0.98, 1.0, 1.02}},
                                 {"vclip", "lean", "f32", {0.70, 0.72, 0.74}, 1e-7, 8.8},
                                 {"gjk", "lean", "f64", {1.4, 1.5, 1.6}, 1e-15, 12.8}};

constexpr const char* study_runs[] = {"stability", "paging", "thrash", "thrash_realised", "effort", "fields"};

/// The rows of one of each study, and a scene file of each name.
std::string store_with(const std::vector<std::string>& names, const std::string& path) {
    store::Store store(path);
    store.put_build({"b", "abc", "g++", "-O3 -march=native", "Release", R"({"cpu":"Test CPU"})"});
    store.set_meta("build", "b");
    for (const char* run : study_runs) {
        ReportCell row = answer_cell(scene_cells[0]);
        row.hash = row.scene = row.run = run;
        store.put_cell("b", row, row.figures);
    }
    for (const std::string& name : names) {
        store.set_meta(store::scene_file_key + name, R"({"scene":"tumble","vary":{"bodies":[100]}})");
        for (const TimedCell& made : scene_cells) {
            ReportCell cell = answer_cell(made);
            cell.scene = name;
            cell.hash = name + made.algorithm + made.layout;
            store.put_cell("b", cell, cell.figures);
            std::vector<std::pair<std::string, measure::Round>> rounds;
            for (const measure::Round& round : cell.rounds) rounds.emplace_back(cell.hash, round);
            store.put_round("b", rounds);
        }
    }
    return path;
}

std::vector<std::string> names_to_try(const ReportData& empty) {
    std::vector<std::string> names = {
        "thrashing",     "answer",  "cells",   "problems",   "look",
        "passed",        "results", "sweep",   "sweep2",     "sweeping",
        "sweep_mine",    "about",   "columns", "paper_mine", "paper_bodies_mine",
        "effort tumble", "a b",     "a.b",     "a_b"};
    for (const char* run : study_runs)
        for (const char* end : {"", "2", "ing", "_mine"}) names.push_back(std::string(run) + end);
    for (const scene::SceneInfo& kind : scene::list_scenes()) {
        names.push_back(kind.name + "2");
        names.push_back(kind.name.substr(0, kind.name.size() - 1));
    }
    for (const Chapter& chapter : report_chapters(answer_of(empty), empty, all_charts(empty)))
        names.push_back(chapter.id);
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

std::size_t rows_with(const TextGrid& grid, const std::string& text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(grid.rows, [&](const auto& row) { return row[0].text == text; }));
}

TEST_F(Report, ShowsScenesOfAnyName) {
    const std::vector<std::string> names = names_to_try({});
    EXPECT_GT(names.size(), 50U);
    const ReportData data = read_report(store_with(names, (directory_ / "names.db").string()));
    EXPECT_EQ(data.from_files.size(), 3 * names.size());
    EXPECT_EQ(data.cells.size(), 0U);
    for (const auto* study : {&data.stability, &data.paging, &data.effort, &data.fields})
        EXPECT_EQ(study->size(), 1U);
    EXPECT_EQ(data.thrash.size(), 2U);
    const Answer answer = answer_of(data);
    EXPECT_EQ(answer.counts.verified, 3 * names.size());
    const TextGrid errors = error_grid(data);
    const auto results = wide_results(data);
    std::set<std::string> charts;
    for (const Chart& chart : all_charts(data)) {
        EXPECT_TRUE(charts.insert(chart.name).second) << chart.name << " twice";
        if (!chart.name.starts_with("scene_")) continue;
        EXPECT_EQ(chart.points.size(), 3U) << chart.name;
    }
    EXPECT_EQ(std::ranges::count_if(charts, [](const auto& name) { return name.starts_with("scene_"); }),
              static_cast<std::ptrdiff_t>(names.size()));
    EXPECT_EQ(results.size(), names.size() + 6 + 2) << "a file each; studies; about/";
    for (const std::string& name : names) {
        const std::string label = name + " (bodies 100)";
        EXPECT_EQ(std::ranges::count(answer.shared, label, &SceneRanking::label), 1) << name;
        EXPECT_EQ(rows_with(errors, label), 3U) << name;
        EXPECT_EQ(time_grid(data, label, PairKind::Separated).rows.size(), 3U) << name;
        EXPECT_THAT(export_text(data, {.scenes = {name}}), HasSubstr("sweep," + name + ",")) << name;
    }
}

/// A name of 5,000 bytes is shown whole, and shortened where it names a file.
TEST_F(Report, IsWrittenWhateverTheNamesAre) {
    const std::vector<std::string> names = {std::string(5000, 'x'),
                                            std::string(5000, 'x') + "y",
                                            "esc\x1b[31mred",
                                            "turn\xe2\x80\xaeround",
                                            "c1\xc2\x9b"
                                            "31m",
                                            "latin\xff",
                                            std::string(300, '/')};
    const std::string store = store_with(names, (directory_ / "names.db").string());
    EXPECT_NO_THROW(write_report(store, (directory_ / "out").string(), "no_bundles"));
    std::vector<std::string> texts = {text("out/report.md"), export_text(read_report(store), {}),
                                      export_text(read_report(store), {.format = ExportFormat::json})};
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(directory_ / "out")) {
        if (!entry.is_regular_file()) continue;
        EXPECT_LT(entry.path().filename().string().size(), 200U);
        if (entry.path().extension() == ".csv")
            texts.push_back(*input::read_file_text(entry.path())), ++files;
    }
    EXPECT_GT(files, names.size());
    for (const std::string& shown : texts)
        for (const char* acting : {"\x1b", "\xe2\x80\xae", "\xc2\x9b", "\xff"})
            EXPECT_THAT(shown, Not(HasSubstr(acting)));
    EXPECT_THAT(texts[0], HasSubstr("esc\\\\x1B"));
    EXPECT_THAT(texts[1], HasSubstr("latin\\xFF"));
    EXPECT_THAT(texts[2], HasSubstr("latin\\\\xFF"));
}

/// Brackets of another program, 40,000 deep, in every text that is read as JSON.
TEST_F(Report, BoundsTheDepthOfItsTexts) {
    const std::string deep = std::string(40000, '[') + std::string(40000, ']');
    const std::string path = store_with({"mine"}, (directory_ / "deep.db").string());
    {
        store::Store store(path);
        store.put_build({"b", "abc", "g++", "", "Release", deep});
        ReportCell cell = answer_cell(scene_cells[1]);
        cell.scene = "mine", cell.scene_parameters = deep, cell.hash = "deep";
        store.put_cell("b", cell, cell.figures);
        for (const std::string key :
             {"scene mine", "body cube8", "heat deep", "run sweep", "drawing aos_f64", "peer x"})
            store.set_meta(key, deep);
    }
    EXPECT_NO_THROW(write_report(path, (directory_ / "out").string(), "no_bundles"));
    EXPECT_THAT(export_text(read_report(path), {}), HasSubstr(deep));
    EXPECT_THAT(text("out/report.md"), HasSubstr("compiler flags not recorded"));
}

TEST_F(Report, KnowsThePapersScenesByName) {
    std::set<std::string_view> names(std::begin(paper_scenes), std::end(paper_scenes)), there;
    for (const scene::SceneText& text : scene::scene_texts()) there.insert(text.name);
    EXPECT_EQ(names, there);
}

}  // namespace
}  // namespace edgewise::reports
