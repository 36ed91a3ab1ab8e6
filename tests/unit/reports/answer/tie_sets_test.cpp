// SPDX-License-Identifier: MIT
//
// One rule says who ties. The page's table, the map, report.md, the JSON and the map's table show the same
// sets, in stores of which every scene has a noise of its own.
#include <gmock/gmock.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <set>

#include "answer_cells.hpp"
#include "edgewise/reports/answer/answer_json.hpp"
#include "edgewise/reports/answer/break_even_map.hpp"
#include "edgewise/reports/answer/break_even_text.hpp"
#include "edgewise/reports/page/first_screen/answer_rows.hpp"

namespace edgewise::reports {
namespace {

using TieNames = std::set<std::string>;

/// Six scenes on two bodies; the baseline differs from itself by up to a quarter, in either direction.
ReportData noisy_store(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> middle(0.6, 1.6), spread(0.001, 0.03), noise(-0.2, 0.25);
    ReportData data;
    for (int scene = 0; scene < 6; ++scene) {
        const std::string parameters = R"({"bodies":)" + std::to_string(scene == 0 ? 5 : 50 * scene) +
                                       R"(,"own_tables":1,"rotation_step":0.1})";
        for (const char* shape : {"cube8", "sphere386"}) {
            const double quiet = scene % 2 == 0 ? 0.02 : 1;
            for (const char* algorithm : {"vclip", "gjk"}) {
                for (const char* layout : {"aos", "lean", "quantised"}) {
                    const bool baseline = std::string(algorithm) + layout == "vclipaos";
                    const double ratio = baseline ? 1 + quiet * noise(random) : middle(random);
                    const double half = ratio * spread(random);
                    data.cells.push_back(answer_cell(
                        {algorithm, layout, "f64", {ratio - half, ratio, ratio + half}}, parameters, shape));
                    data.cells.back().scene_label = "scene " + std::to_string(scene);
                }
            }
        }
    }
    return data;
}

TieNames tie_names_of(const SceneAnswer& scene) {
    TieNames names;
    for (const std::size_t place : scene.ties) names.insert(scene.candidates[place].name());
    return names;
}

/// What a row of the table says, of a scene whose ties are known: "alone", "ties with A, B", "smallest of 3
/// that tie", "3 tie".
void expect_said(const std::string& said, const SceneAnswer& scene) {
    const TieNames ties = tie_names_of(scene);
    std::smatch number;
    if (said == "alone") {
        EXPECT_EQ(ties.size(), 1U);
    } else if (std::regex_search(said, number, std::regex("(\\d+) (that )?tie"))) {
        EXPECT_EQ(std::stoul(number[1]), ties.size()) << said;
    } else {
        ASSERT_TRUE(said.starts_with("ties with ")) << said;
        const std::string rest = said.substr(10);
        const std::size_t more =
            std::regex_search(rest, number, std::regex(" and (\\d+) more")) ? std::stoul(number[1]) : 0;
        EXPECT_EQ(static_cast<std::size_t>(std::count(rest.begin(), rest.end(), ',')) + 1 + more,
                  ties.size() - 1);
        for (const std::string& name : ties) {
            if (more > 0 || name == scene.choice()->name()) continue;
            EXPECT_THAT(rest, testing::HasSubstr(name));
        }
    }
}

struct TiesSeen {
    std::size_t alone = 0, tied = 0, by_noise = 0;
};

void check_ties_of_map(const BreakEvenMap& map, std::size_t column, const Answer& answer, TiesSeen& seen) {
    for (const MapPanel& panel : map.panels) {
        for (const MapRow& row : panel.rows) {
            const MapCell& cell = row.cells[column];
            if (!cell.scene) continue;
            const auto scenes = answer.scenes();
            const auto same = std::find_if(scenes.begin(), scenes.end(), [&](const SceneAnswer* scene) {
                return scene->label == cell.scene->label;
            });
            ASSERT_NE(same, scenes.end());
            TieNames shown = {cell.best->name()};
            for (const Candidate* one : cell.ties) shown.insert(one->name());
            EXPECT_EQ(shown, tie_names_of(**same)) << cell.scene->label;
            for (const std::string& name : tie_names_of(**same))
                EXPECT_THAT(cell_text(cell), testing::HasSubstr(name));
            ++(shown.size() == 1 ? seen.alone : seen.tied);
            for (const Candidate* one : cell.ties) seen.by_noise += one->low() > cell.best->high();
        }
    }
}

TEST(TieSets, AreTheSameInTableMapMarkdownAndJson) {
    TiesSeen seen;
    for (unsigned seed = 1; seed <= 24; ++seed) {
        const ReportData data = noisy_store(seed);
        const BreakEvenMap map = break_even_map(data, 1e-6);
        for (std::size_t column = 0; column < map.columns.size(); ++column) {
            const Answer answer = answer_of(data, {.shape = map.columns[column].shape});
            check_ties_of_map(map, column, answer, seen);
            const TextGrid grid = answer_grid(answer);
            const std::string page = answer_rows_html(answer);
            const nlohmann::json json = answer_json(answer);
            ASSERT_EQ(grid.rows.size(), answer.scenes().size());
            for (std::size_t i = 0; i < grid.rows.size(); ++i) {
                const SceneAnswer& scene = *answer.scenes()[i];
                expect_said(grid.rows[i][3].text, scene);
                EXPECT_THAT(page, testing::HasSubstr("<small>" + grid.rows[i][3].text + "</small>"));
                TieNames marked;
                for (const auto& one : json["scenes"][i]["candidates"])
                    if (one["ties"]) marked.insert(scene.find(one["algorithm"], one["table"])->name());
                EXPECT_EQ(marked, tie_names_of(scene));
            }
        }
    }
    EXPECT_GT(seen.alone, 20U);
    EXPECT_GT(seen.tied, 20U);
    EXPECT_GT(seen.by_noise, 10U) << "ties whose intervals do not meet";
    std::cout << seen.alone << " alone, " << seen.tied << " tied, " << seen.by_noise << " by noise\n";
}

}  // namespace
}  // namespace edgewise::reports
