// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/chapters/compare_chapter.hpp"

#include "edgewise/reports/compare/comparison_grids.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

Chapter compare_chapter(const Comparison& comparison, double slack, const std::string& other) {
    Chapter chapter{.id = "changes",
                    .title = "What changed since " + other + "?",
                    .paragraph = prose("comparison.md", fmt::arg("slack", 100 * slack),
                                       fmt::arg("noise_low", comparison.noise_low),
                                       fmt::arg("noise_high", comparison.noise_high)),
                    .link = "What changed",
                    .sentence = comparison_sentence(comparison, slack)};
    for (TextGrid& grid : change_grids(comparison, slack))
        chapter.blocks.push_back({.grids = {std::move(grid)}});
    chapter.blocks.push_back({.grids = {conditions_grid(comparison)}});
    return chapter;
}

}  // namespace edgewise::reports
