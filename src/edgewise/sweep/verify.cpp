// SPDX-License-Identifier: MIT
#include "edgewise/sweep/verify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/truth/accuracy_band.hpp"

namespace edgewise {

namespace {

/// | |p_a - p_b| - d | over scale: do the witness points lie as far apart as the answer says?
double witness_error(const Distance& answer, const AccuracyBand& band) {
    if (answer.status != Status::separated) return 0;
    const double apart = norm(Vec3d(answer.point_a - answer.point_b));
    return std::abs(apart - answer.distance) / band.scale;
}

/// With a contact tolerance the question is whether the distance exceeds it, and the answer how far.
ExactDistance beyond(ExactDistance exact, double tolerance) {
    if (tolerance == 0 || exact.verdict != ExactVerdict::separated) return exact;
    exact.distance -= tolerance;
    if (exact.distance <= 0) {
        exact.distance = 0;
        exact.verdict = ExactVerdict::touching;
    }
    return exact;
}

CheckedAnswer check(const Distance& answer, ExactDistance stored, ExactDistance given,
                    const AccuracyBand& band, const QueryOptions& options) {
    const double given_away = options.gap_tolerance * stored.distance / band.scale;
    stored = beyond(stored, options.contact_tolerance);
    given = beyond(given, options.contact_tolerance);
    const JudgedAnswer judged{answer.status == Status::separated,
                              answer.distance - options.contact_tolerance};
    const Judgement on_stored = judge(judged, stored, band);
    CheckedAnswer result;
    result.separated = stored.verdict == ExactVerdict::separated;
    result.touching = stored.verdict == ExactVerdict::touching;
    result.verdict_wrong = on_stored.verdict_wrong || answer.status == Status::failed;
    result.in_band = on_stored.in_band;
    result.given_away = given_away;
    if (options.verdict_only) return result;  // the distance is a bound, and no witness was asked for
    result.error_stored = on_stored.error_over_scale;
    result.error_given = judge(judged, given, band).error_over_scale;
    result.witness_error = witness_error(answer, band);
    return result;
}

}  // namespace

std::vector<CheckedAnswer> check_answers(Group& group, std::span<const Polyhedron> stored,
                                         std::span<const Distance> answers, double eps,
                                         const QueryOptions& options) {
    const auto& exact_stored = group.exact(stored);
    const auto& exact_given = group.exact(group.workload().bodies);
    const auto& control = group.control(stored);
    std::vector<CheckedAnswer> result;
    for (std::size_t k = 0; k < group.checked().size(); ++k) {
        const std::size_t i = group.checked()[k];
        const Query& query = group.workload().queries[i];
        const AccuracyBand band = accuracy_band(stored[query.body_a].vertices, query.pose_a,
                                                stored[query.body_b].vertices, query.pose_b, eps);
        result.push_back(check(answers[i], exact_stored[k], exact_given[k], band, options));
        if (k < control.size() && control[k])
            result.back().control_disagrees = *control[k] != (answers[i].status != Status::separated);
    }
    return result;
}

std::string what_is_wrong(const Group& group, std::span<const CheckedAnswer> checked, double eps) {
    const double bound = eps > Tolerance<double>::eps ? verified_error_single : verified_error_double;
    const auto bad = [&](const CheckedAnswer& a) {
        return a.verdict_wrong || !(a.error_stored <= bound + a.given_away) || !(a.witness_error <= bound);
    };
    const auto first = std::find_if(checked.begin(), checked.end(), bad);
    if (first == checked.end()) return {};
    return fmt::format(
        "{} of {} checked answers are wrong; first: query {} ({}), error {:.3g} of scale, witness error "
        "{:.3g}, "
        "allowed {:.0e}",
        std::count_if(checked.begin(), checked.end(), bad), checked.size(),
        group.checked()[static_cast<std::size_t>(first - checked.begin())],
        first->verdict_wrong ? "wrong verdict" : "wrong distance", first->error_stored, first->witness_error,
        bound);
}

AnswerCounts count_answers(std::span<const Distance> answers, std::span<const std::uint8_t> cold) {
    AnswerCounts counts;
    counts.queries = answers.size();
    for (std::size_t i = 0; i < cold.size(); ++i) {
        counts.warm += !cold[i];
        counts.unchanged += !cold[i] && answers[i].steps == 1;
    }
    for (const Distance& answer : answers) {
        counts.steps += static_cast<std::uint64_t>(answer.steps);
        counts.fallbacks += static_cast<std::uint64_t>(answer.fallbacks);
        counts.refinements += static_cast<std::uint64_t>(answer.refinements);
        counts.escapes += static_cast<std::uint64_t>(answer.escapes);
        counts.cycles += static_cast<std::uint64_t>(answer.cycles);
        counts.max_steps = std::max(counts.max_steps, answer.steps);
    }
    return counts;
}

}  // namespace edgewise
