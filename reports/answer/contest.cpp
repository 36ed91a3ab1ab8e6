// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/contest.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

constexpr const char* both_algorithms[] = {"vclip", "gjk"};

/// Shape, algorithm and table type.
using Known = std::set<std::tuple<std::string, std::string, std::string>>;

std::ptrdiff_t types_of(const SceneRanking& scene, const char* algorithm) {
    return std::ranges::count_if(scene.cells,
                                 [&](const RankedCell& one) { return one.cell->algorithm == algorithm; });
}

/// Returns the fast layouts in a scene with the most table types.
Known fast_ones(const std::vector<SceneRanking>& scenes) {
    Known fast;
    for (const char* const algorithm : both_algorithms) {
        std::map<std::string, std::ptrdiff_t> most;  // by shape
        for (const SceneRanking& scene : scenes)
            most[scene.shape] = std::max(most[scene.shape], types_of(scene, algorithm));
        for (const SceneRanking& scene : scenes) {
            const RankedCell* best = scene.best(algorithm);
            if (!best || types_of(scene, algorithm) < most[scene.shape]) continue;
            for (const RankedCell& one : scene.cells)
                if (one.cell->algorithm == algorithm && one.ratio <= fast_ratio * best->ratio)
                    fast.emplace(scene.shape, algorithm, one.table);
        }
    }
    return fast;
}

bool is_small(const RankedCell& one) {
    return one.bytes_per_edge && *one.bytes_per_edge <= small_bytes_per_edge;
}

std::vector<std::string> missing_from(const SceneRanking& scene, const Known& fast) {
    std::vector<std::string> missing;
    for (const char* const algorithm : both_algorithms) {
        bool has_small = false, has_fast = false;
        for (const RankedCell& one : scene.cells) {
            if (one.cell->algorithm != algorithm) continue;
            has_small = has_small || is_small(one);
            has_fast = has_fast || fast.contains({scene.shape, algorithm, one.table});
        }
        const std::string name = algorithm_title(algorithm);
        if (!has_small) missing.push_back(name + " on a small layout");
        if (!has_fast) missing.push_back(name + " on a fast layout");
    }
    return missing;
}

}  // namespace

void check_contests(std::vector<SceneRanking>& scenes) {
    const Known fast = fast_ones(scenes);
    for (SceneRanking& scene : scenes) scene.not_measured = missing_from(scene, fast);
}

std::string contest_rule() {
    return prose("contest.md", fmt::arg("small", small_bytes_per_edge), fmt::arg("fast", fast_ratio));
}

}  // namespace edgewise::reports
