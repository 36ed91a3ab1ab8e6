// SPDX-License-Identifier: MIT
#include "edgewise/studies/judge/smaller_pair.hpp"

#include <algorithm>

#include "edgewise/geometry/hull/point_set.hpp"

namespace edgewise::studies {

namespace {

constexpr double least_part = 0.1;         ///< of the error over scale that was there first
constexpr std::size_t most_work = 200000;  ///< tries x vertices: some seconds

bool is_solid(const scene::CaseBody& body) {
    return flatness_error(body.vertices, distinct_points(body.vertices)).empty();
}

double over_scale(const JudgedResponse& answer, const PairTruth& truth) {
    return truth.band.scale > 0 ? answer.beyond / truth.band.scale : 0;
}

}  // namespace

std::optional<SmallerPair> smaller_pair(const Respondent& respondent, const scene::Case& pair) {
    const auto given = exact_truth_of(pair);
    if (!given) return std::nullopt;
    const JudgedResponse first = ask(respondent, pair, *given);
    if (!first.wrong()) return std::nullopt;
    const bool solid_a = is_solid(pair.a), solid_b = is_solid(pair.b);
    const auto still_fails = [&](const scene::Case& candidate) {
        if (is_solid(candidate.a) != solid_a || is_solid(candidate.b) != solid_b) return false;
        const auto truth = exact_truth_of(candidate);
        if (!truth) return false;
        const JudgedResponse answer = ask(respondent, candidate, *truth);
        return answer.is == first.is && over_scale(answer, *truth) >= least_part * over_scale(first, *given);
    };
    const std::size_t vertices = pair.a.vertices.size() + pair.b.vertices.size();
    SmallerPair result;
    result.found = scene::minimise(pair, still_fails, std::max<std::size_t>(200, most_work / vertices));
    result.truth = *truth_of(result.found.pair);
    result.answer = ask(respondent, result.found.pair, result.truth);
    return result;
}

}  // namespace edgewise::studies
