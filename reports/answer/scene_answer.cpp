// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/scene_answer.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "edgewise/reports/answer/scene_words.hpp"

namespace edgewise::reports {

namespace {

/// The axes of the scene's own question: a scene file's needs are axes of all its cells.
std::string plain_axes(std::span<const ReportCell* const> cells) {
    const ReportCell* plainest = nullptr;
    for (const ReportCell* cell : cells) {
        if (cell->judged()) continue;
        if (!plainest || std::make_tuple(cell->axes.size(), cell->axes) <
                             std::make_tuple(plainest->axes.size(), plainest->axes))
            plainest = cell;
    }
    return plainest ? plainest->axes : std::string();
}

constexpr double slowest_tie = 1.25, widest_interval = 2;

void sort_by_ratio(std::vector<Candidate>& candidates) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.ratio < b.ratio; });
}

void find_ties(SceneAnswer& answer) {
    const auto& all = answer.candidates;
    const auto first =
        std::find_if(all.begin(), all.end(), [](const Candidate& one) { return one.meets_error; });
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].meets_error)
            answer.out.push_back(i);
        else if (all[i].low() <= first->high() || all[i].ratio <= first->ratio * answer.noise.high())
            answer.ties.push_back(i);
    }
}

/// The winner beats it by more than its own interval and the scene's noise.
bool beats_baseline(const SceneAnswer& answer) {
    const Candidate *winner = answer.winner(), *baseline = answer.baseline();
    return winner && winner != baseline && winner->high() < 1 && !answer.noise.holds(winner->ratio) &&
           !(baseline && answer.ties_with_winner(*baseline));
}

}  // namespace

const Candidate* SceneAnswer::winner() const { return ties.empty() ? nullptr : &candidates[ties.front()]; }

const Candidate* SceneAnswer::find(const std::string& algorithm, const std::string& table) const {
    const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& one) {
        return one.cell->algorithm == algorithm && one.table == table;
    });
    return found == candidates.end() ? nullptr : &*found;
}

const Candidate* SceneAnswer::baseline() const { return find(ratios_to.algorithm, ratios_to.table); }

const Candidate* SceneAnswer::best(const std::string& algorithm) const {
    const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& one) {
        return one.meets_error && one.cell->algorithm == algorithm;
    });
    return found == candidates.end() ? nullptr : &*found;
}

const Candidate* SceneAnswer::best_peer() const {
    const auto within =
        std::find_if(peers.begin(), peers.end(), [](const Candidate& one) { return one.meets_error; });
    if (within != peers.end()) return &*within;
    return peers.empty() ? nullptr : &peers.front();
}

const Candidate* SceneAnswer::smallest_of_ties() const {
    const Candidate* smallest = nullptr;
    const auto bytes = [](const Candidate& one) {
        return one.bytes_per_edge.value_or(std::numeric_limits<double>::infinity());
    };
    for (const std::size_t place : ties) {
        if (candidates[place].ratio > slowest_tie * winner()->ratio) continue;
        if (!smallest || bytes(candidates[place]) < bytes(*smallest)) smallest = &candidates[place];
    }
    return smallest;
}

bool SceneAnswer::ties_with_winner(const Candidate& candidate) const {
    return std::any_of(ties.begin(), ties.end(),
                       [&](std::size_t place) { return &candidates[place] == &candidate; });
}

const Candidate* SceneAnswer::choice() const {
    if (beats_baseline) return winner();
    if (!too_noisy) return smallest_of_ties();
    return baseline() && ties_with_winner(*baseline()) ? baseline() : winner();
}

SceneAnswer scene_answer(std::span<const ReportCell* const> cells, const Question& question,
                         const Baseline& baseline) {
    SceneAnswer answer;
    answer.ratios_to = baseline;
    const std::string plain = plain_axes(cells);
    for (const ReportCell* cell : cells) {
        if (cell->is_raw() || (!cell->judged() && cell->axes != plain)) continue;
        if (auto candidate = candidate_of(*cell, question.error_limit))
            (cell->judged() ? answer.peers : answer.candidates).push_back(std::move(*candidate));
    }
    sort_by_ratio(answer.candidates);
    sort_by_ratio(answer.peers);
    if (const Candidate* own = answer.baseline()) answer.noise.factor = std::max(own->ratio, 1 / own->ratio);
    find_ties(answer);
    answer.beats_baseline = beats_baseline(answer);
    if (const Candidate* winner = answer.winner())
        answer.too_noisy = winner->high() > widest_interval * winner->low();
    const ReportCell& any = *cells.front();
    answer.scene = any.scene, answer.label = any.scene_label, answer.shape = any.shape;
    answer.vertices = any.vertices, answer.edges = any.edges;
    answer.own_tables = has_own_tables(any);
    answer.sentence = scene_sentence(any);
    return answer;
}

}  // namespace edgewise::reports
