// SPDX-License-Identifier: MIT
#include "edgewise/sweep/verify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "edgewise/scene/answer_claim.hpp"

namespace edgewise::sweep {

std::vector<truth::CheckedAnswer> check_answers(SharedQueries& shared, std::span<const Polyhedron> stored,
                                                std::span<const Distance> answers, double eps,
                                                const QueryOptions& options) {
    auto& known_stored = shared.known(stored);
    auto& known_given = shared.known(shared.workload().bodies);
    const auto& control = shared.control(stored);
    const truth::Leeway leeway{options.contact_tolerance, options.gap_tolerance};
    std::vector<truth::CheckedAnswer> result;
    for (std::size_t k = 0; k < shared.checked().size(); ++k) {
        const std::size_t i = shared.checked()[k];
        const scene::Query& query = shared.workload().queries[i];
        const truth::PlacedBodies bodies = scene::placed(stored, query);
        const truth::Claim claim = scene::claim_of(answers[i], options.verdict_only);
        truth::CheckedAnswer& checked = result.emplace_back(truth::check(
            claim, bodies, known_stored[k], bodies.band(eps), truth::allowed_errors(eps), leeway));
        const auto& given = known_given[k].exact(scene::placed(shared.workload().bodies, query));
        if (!options.verdict_only)
            checked.error_given = truth::distance_error(claim, given, leeway.contact_tolerance);
        if (k < control.size() && control[k]) checked.control_disagrees = *control[k] == claim.separated;
    }
    return result;
}

std::vector<truth::CheckedAnswer> check_nearness(SharedQueries& shared, std::span<const Polyhedron> stored,
                                                 std::span<const Distance> answers, double eps,
                                                 const QueryOptions& options,
                                                 const std::function<double(const scene::Query&)>& margin) {
    auto& known = shared.known(stored);
    std::vector<truth::CheckedAnswer> result;
    for (std::size_t k = 0; k < shared.checked().size(); ++k) {
        const scene::Query& query = shared.workload().queries[shared.checked()[k]];
        const Status status = answers[shared.checked()[k]].status;
        const truth::PlacedBodies bodies = scene::placed(stored, query);
        result.push_back(truth::check_nearness(status == Status::touching, known[k].exact(bodies),
                                               margin(query), bodies.band(eps), options.gap_tolerance));
        if (status > Status::touching) result.back().verdict_wrong = true;  // no answer to that question
    }
    return result;
}

std::string what_is_wrong(const SharedQueries& shared, std::span<const truth::CheckedAnswer> checked,
                          double eps) {
    const auto first = std::ranges::find_if(checked, &truth::CheckedAnswer::wrong);
    if (first == checked.end()) return {};
    return fmt::format(
        "{} of {} checked answers are wrong; first: query {} ({}), error {:.3g} of scale, witness error "
        "{:.3g}, allowed {:.0e}",
        std::ranges::count_if(checked, &truth::CheckedAnswer::wrong), checked.size(),
        shared.checked()[static_cast<std::size_t>(first - checked.begin())],
        first->verdict_wrong ? "wrong verdict" : "wrong distance", first->band.over_scale(first->error),
        first->band.over_scale(first->witness_error), truth::allowed_errors(eps).distance);
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
