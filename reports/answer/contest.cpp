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

constexpr const char* contenders[] = {"vclip", "gjk"};

/// Shape, algorithm and table type.
using Known = std::set<std::tuple<std::string, std::string, std::string>>;

std::ptrdiff_t types_of(const SceneAnswer& scene, const char* algorithm) {
    return std::ranges::count_if(scene.candidates,
                                 [&](const Candidate& one) { return one.cell->algorithm == algorithm; });
}

/// Those that are fast in a scene with the most table types.
Known fast_ones(const std::vector<SceneAnswer>& scenes) {
    Known fast;
    for (const char* const algorithm : contenders) {
        std::map<std::string, std::ptrdiff_t> most;  // by shape
        for (const SceneAnswer& scene : scenes)
            most[scene.shape] = std::max(most[scene.shape], types_of(scene, algorithm));
        for (const SceneAnswer& scene : scenes) {
            const Candidate* best = scene.best(algorithm);
            if (!best || types_of(scene, algorithm) < most[scene.shape]) continue;
            for (const Candidate& one : scene.candidates)
                if (one.cell->algorithm == algorithm && one.ratio <= fast_ratio * best->ratio)
                    fast.emplace(scene.shape, algorithm, one.table);
        }
    }
    return fast;
}

bool is_small(const Candidate& one) {
    return one.bytes_per_edge && *one.bytes_per_edge <= small_bytes_per_edge;
}

std::vector<std::string> missing_from(const SceneAnswer& scene, const Known& fast) {
    std::vector<std::string> missing;
    for (const char* const algorithm : contenders) {
        bool has_small = false, has_fast = false;
        for (const Candidate& one : scene.candidates) {
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

void check_contests(std::vector<SceneAnswer>& scenes) {
    const Known fast = fast_ones(scenes);
    for (SceneAnswer& scene : scenes) scene.not_measured = missing_from(scene, fast);
}

std::string contest_rule() {
    return prose("contest.md", fmt::arg("small", small_bytes_per_edge), fmt::arg("fast", fast_ratio));
}

}  // namespace edgewise::reports
