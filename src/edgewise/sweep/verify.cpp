// SPDX-License-Identifier: MIT
#include "edgewise/sweep/verify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/truth/accuracy_band.hpp"

namespace edgewise::sweep {

namespace {

/// | |p_a - p_b| - d | divided by scale: do the witness points lie as far apart as the answer says?
double witness_error(const Distance& answer, const truth::AccuracyBand& band) {
    if (answer.status != Status::separated) return 0;
    const double between = norm(Vec3d(answer.point_a - answer.point_b));
    return std::abs(between - answer.distance) / band.scale;
}

/// With a contact tolerance the question is whether the distance exceeds it, and the answer how far.
truth::ExactDistance beyond(truth::ExactDistance exact, double tolerance) {
    if (tolerance == 0 || exact.verdict != truth::ExactVerdict::separated) return exact;
    exact.distance -= tolerance;
    if (exact.distance <= 0) {
        exact.distance = 0;
        exact.verdict = truth::ExactVerdict::touching;
    }
    return exact;
}

measure::CheckedAnswer without_errors(const truth::ExactDistance& exact) {
    measure::CheckedAnswer result;
    result.separated = exact.verdict == truth::ExactVerdict::separated;
    result.touching = exact.verdict == truth::ExactVerdict::touching;
    return result;
}

/// By how much an answer may be too long: by gap_tolerance of itself, so by a little more of the true
/// distance.
double most_given_away(const QueryOptions& options, double distance) {
    return options.gap_tolerance / (1 - options.gap_tolerance) * distance;
}

measure::CheckedAnswer check(const Distance& answer, truth::ExactDistance stored, truth::ExactDistance given,
                             const truth::AccuracyBand& band, const QueryOptions& options) {
    const double given_away = most_given_away(options, stored.distance) / band.scale;
    stored = beyond(stored, options.contact_tolerance);
    given = beyond(given, options.contact_tolerance);
    const truth::JudgedAnswer judged{answer.status == Status::separated,
                                     answer.distance - options.contact_tolerance};
    const truth::Judgement on_stored = truth::judge(judged, stored, band);
    measure::CheckedAnswer result = without_errors(stored);
    result.verdict_wrong = on_stored.verdict_wrong || answer.status == Status::failed;
    result.in_band = on_stored.in_band;
    result.given_away = given_away;
    if (options.verdict_only) return result;  // the distance is a bound, and no witness was asked for
    result.error_stored = on_stored.error_over_scale;
    result.error_given = truth::judge(judged, given, band).error_over_scale;
    result.witness_error = witness_error(answer, band);
    return result;
}

/// Written so that no answer, and NaN, are wrong.
measure::CheckedAnswer check_near(const Distance& answer, const truth::ExactDistance& exact, double margin,
                                  const truth::AccuracyBand& band, const QueryOptions& options) {
    measure::CheckedAnswer result = without_errors(exact);
    const bool nearer = answer.status == Status::touching;
    const double beyond = exact.distance - margin;
    result.in_band = std::abs(beyond) <= band.band;
    const bool right = nearer ? beyond < 0 : beyond + most_given_away(options, exact.distance) >= 0;
    const bool is_answer = nearer || answer.status == Status::separated;
    result.verdict_wrong = !is_answer || !(right || result.in_band);
    return result;
}

double allowed_error(double eps) {
    return eps > Tolerance<double>::eps ? verified_error_single : verified_error_double;
}

/// Written so that NaN is wrong.
bool is_wrong(const measure::CheckedAnswer& answer, double eps) {
    const double bound = allowed_error(eps);
    return answer.verdict_wrong || !(answer.error_stored <= bound + answer.given_away) ||
           !(answer.witness_error <= bound);
}

truth::AccuracyBand band_of(const scene::Query& query, std::span<const Polyhedron> stored, double eps) {
    return truth::accuracy_band(stored[query.body_a].vertices, query.pose_a, stored[query.body_b].vertices,
                                query.pose_b, eps);
}

}  // namespace

std::vector<measure::CheckedAnswer> check_answers(SharedQueries& shared, std::span<const Polyhedron> stored,
                                                  std::span<const Distance> answers, double eps,
                                                  const QueryOptions& options) {
    const auto& exact_stored = shared.exact(stored);
    const auto& exact_given = shared.exact(shared.workload().bodies);
    const auto& control = shared.control(stored);
    std::vector<measure::CheckedAnswer> result;
    for (std::size_t k = 0; k < shared.checked().size(); ++k) {
        const std::size_t i = shared.checked()[k];
        const scene::Query& query = shared.workload().queries[i];
        const truth::AccuracyBand band = band_of(query, stored, eps);
        result.push_back(check(answers[i], exact_stored[k], exact_given[k], band, options));
        result.back().wrong = is_wrong(result.back(), eps);
        if (k < control.size() && control[k])
            result.back().control_disagrees = *control[k] != (answers[i].status != Status::separated);
    }
    return result;
}

std::vector<measure::CheckedAnswer> check_nearness(SharedQueries& shared, std::span<const Polyhedron> stored,
                                                   std::span<const Distance> answers, double eps,
                                                   const QueryOptions& options,
                                                   const std::function<double(const scene::Query&)>& margin) {
    const auto& exact = shared.exact(stored);
    std::vector<measure::CheckedAnswer> result;
    for (std::size_t k = 0; k < shared.checked().size(); ++k) {
        const std::size_t i = shared.checked()[k];
        const scene::Query& query = shared.workload().queries[i];
        result.push_back(
            check_near(answers[i], exact[k], margin(query), band_of(query, stored, eps), options));
        result.back().wrong = is_wrong(result.back(), eps);
    }
    return result;
}

std::string what_is_wrong(const SharedQueries& shared, std::span<const measure::CheckedAnswer> checked,
                          double eps) {
    const auto first = std::ranges::find_if(checked, &measure::CheckedAnswer::wrong);
    if (first == checked.end()) return {};
    return fmt::format(
        "{} of {} checked answers are wrong; first: query {} ({}), error {:.3g} of scale, witness error "
        "{:.3g}, "
        "allowed {:.0e}",
        std::ranges::count_if(checked, &measure::CheckedAnswer::wrong), checked.size(),
        shared.checked()[static_cast<std::size_t>(first - checked.begin())],
        first->verdict_wrong ? "wrong verdict" : "wrong distance", first->error_stored, first->witness_error,
        allowed_error(eps));
}

measure::AnswerCounts count_answers(std::span<const Distance> answers, std::span<const std::uint8_t> cold) {
    measure::AnswerCounts counts;
    counts.queries = answers.size();
    counts.follows_pairs = !cold.empty();
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const bool warm = !cold.empty() && !cold[i];
        int& most = warm ? counts.max_warm_steps : counts.max_cold_steps;
        most = std::max(most, answers[i].steps);
        if (warm) counts.warm_steps += static_cast<std::uint64_t>(answers[i].steps);
    }
    for (std::size_t i = 0; i < cold.size(); ++i) {
        counts.warm += !cold[i];
        counts.unchanged += !cold[i] && answers[i].steps == 1;
        counts.told += !cold[i] && answers[i].steps == 0 && answers[i].status != Status::failed;
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

}  // namespace edgewise::sweep
