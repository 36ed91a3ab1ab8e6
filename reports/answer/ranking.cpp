// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/ranking.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "edgewise/measure/machine/quietness.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

/// The axes of the scene's own question: a scene file's needs are axes of all its cells.
std::string plain_axes(std::span<const ReportCell* const> cells) {
    std::set<std::pair<std::size_t, std::string>> axes;  // the plainest first
    for (const ReportCell* cell : cells)
        if (!cell->judged()) axes.emplace(cell->axes.size(), cell->axes);
    return axes.empty() ? std::string() : axes.begin()->second;
}

constexpr double widest_interval = 2;

/// Other libraries, and the cells of a scene's question with these axes, each with all that measured it;
/// fastest first.
std::vector<RankedCell> ranked_cells(std::span<const ReportCell* const> cells, const std::string& axes,
                                     bool peers, double error_limit) {
    std::map<std::pair<std::string, std::string>, std::vector<const ReportCell*>> runs;
    for (const ReportCell* cell : cells)
        if (!cell->is_raw() && cell->judged() == peers && cell->axes == axes)
            runs[{cell->algorithm, cell->table}].push_back(cell);
    std::vector<RankedCell> ranked;
    for (const auto& [name, measured] : runs)
        if (auto one = ranked_cell(measured, error_limit)) ranked.push_back(std::move(*one));
    std::ranges::stable_sort(ranked, {}, &RankedCell::ratio);
    return ranked;
}

const RankedCell* find_in(const std::vector<RankedCell>& cells, const std::string& algorithm,
                          const std::string& table) {
    const auto found = std::ranges::find_if(
        cells, [&](const RankedCell& one) { return one.cell->algorithm == algorithm && one.table == table; });
    return found == cells.end() ? nullptr : &*found;
}

/// The cells compiled with default flags, by their ratio to the baseline among them; empty without one.
std::vector<RankedCell> with_default_flags(std::span<const ReportCell* const> cells, const std::string& axes,
                                           double error_limit, const Baseline& baseline) {
    std::vector<RankedCell> ranked = ranked_cells(cells, axes, false, error_limit);
    const RankedCell* const to = find_in(ranked, baseline.algorithm, baseline.table);
    if (!to) return {};
    const double ratio = to->ratio;
    for (RankedCell& one : ranked) {
        one.ratio /= ratio;
        if (one.interval) one.interval->low /= ratio, one.interval->high /= ratio;
    }
    return ranked;
}

void find_own_variation(SceneRanking& scene) {
    const RankedCell* own = scene.baseline();
    if (!own) return;
    const bool several = own->holds_between_processes();
    const double low = several ? own->low() : own->ratio, high = several ? own->high() : own->ratio;
    scene.own_variation.factor = std::max(high, 1 / low);
}

void find_ties(SceneRanking& scene) {
    const auto first = std::ranges::find_if(scene.cells, &RankedCell::meets_error);
    for (std::size_t i = 0; i < scene.cells.size(); ++i) {
        const RankedCell& one = scene.cells[i];
        if (one.meets_error() && ties(one.range(), first->range(), scene.own_variation))
            scene.ties.push_back(i);
    }
}

/// The first process that has the figure.
std::optional<double> first_of(std::span<const ReportCell* const> runs, const store::FigureName& figure) {
    for (const ReportCell* run : runs)
        if (const auto value = run->figure(figure).value) return value;
    return std::nullopt;
}

std::string why_dropped(const std::optional<double>& error, double limit) {
    if (!error) return "its error was not measured";
    if (*error <= limit) return {};
    return fmt::format("error {} is over {}", number_text(*error, "scale"), limit_text(limit));
}

/// Why no cell of the scene can be chosen by its time; empty: one can.
std::string noise_of(const SceneRanking& scene, std::span<const ReportCell* const> cells) {
    double others = 0;
    for (const ReportCell* cell : cells) others = std::max(others, cell->others);
    if (others > measure::most_of_others)
        return fmt::format(
            "others took {:.0f} % of the processor while it was timed; measure again when the machine is "
            "quiet, a sweep into a new store",
            100 * others);
    const RankedCell* const winner = scene.winner();
    return winner && winner->high() > widest_interval * winner->low()
               ? "the winner's interval spans more than a factor of 2"
               : "";
}

/// The winner beats it by more than its own interval and the baseline's own variation.
bool beats_baseline(const SceneRanking& answer) {
    const RankedCell *winner = answer.winner(), *baseline = answer.baseline();
    return winner && winner != baseline && winner->high() < 1 && !answer.own_variation.holds(winner->ratio) &&
           !(baseline && answer.ties_with_winner(*baseline));
}

}  // namespace

std::string algorithm_title(const std::string& algorithm) {
    if (algorithm == "vclip") return "V-Clip";
    return algorithm == "gjk" ? "GJK" : algorithm;
}

std::string RankedCell::name() const {
    return cell->judged() ? cell->layout : fmt::format("{} on {}", algorithm_title(cell->algorithm), table);
}

bool ties(const RatioRange& cell, const RatioRange& fastest, const OwnVariation& variation) {
    return cell.low <= fastest.high || cell.ratio <= fastest.ratio * variation.high();
}

std::optional<RankedCell> ranked_cell(std::span<const ReportCell* const> runs, double error_limit) {
    RankedCell ranked;
    std::vector<double> times, ratios, rounds;
    for (const ReportCell* run : runs) {
        const auto ns = run->figure(store::all_time.ns).value,
                   ratio = run->figure(store::all_time.ratio).value;
        if (!run->is_timed() || !ns || !ratio || !(*ratio > 0)) continue;
        if (times.empty()) ranked.cell = run;
        times.push_back(*ns);
        ratios.push_back(*ratio);
        for (const measure::Round& round : run->rounds)
            if (const auto one = round.ratio(&measure::Timing::all)) rounds.push_back(*one);
    }
    if (times.empty()) return std::nullopt;
    ranked.processes = times.size();
    ranked.table = ranked.cell->table.substr(0, ranked.cell->table.find(' '));
    ranked.ns = *measure::median(times);
    ranked.ratio = *measure::median(ratios);
    if (ranked.processes == 1)
        ranked.interval = median_interval(std::move(rounds));
    else if (ranked.holds_between_processes())
        ranked.interval = median_interval(std::move(ratios));
    ranked.worst_error = first_of(runs, "error.worst_error_given");
    ranked.bytes_per_edge = first_of(runs, "bytes.total_bytes_per_edge");
    ranked.table_bytes = first_of(runs, "bytes.table_bytes");
    ranked.scene_bytes = first_of(runs, "memory.requested_bytes");
    ranked.tables = first_of(runs, "memory.tables");
    ranked.lines_per_query = first_of(runs, "lines.lines_per_query");
    ranked.steps = first_of(runs, "error.mean_steps");
    ranked.dropped = why_dropped(ranked.worst_error, error_limit);
    return ranked;
}

std::optional<RankedCell> ranked_cell(const ReportCell& cell, double error_limit) {
    const ReportCell* const one = &cell;
    return ranked_cell(std::span(&one, 1), error_limit);
}

const RankedCell* SceneRanking::winner() const { return ties.empty() ? nullptr : &cells[ties.front()]; }

const RankedCell* SceneRanking::find(const std::string& algorithm, const std::string& table) const {
    return find_in(cells, algorithm, table);
}

const RankedCell* SceneRanking::baseline() const { return find(ratios_to.algorithm, ratios_to.table); }

const RankedCell* SceneRanking::best(const std::string& algorithm) const {
    const auto found = std::ranges::find_if(
        cells, [&](const RankedCell& one) { return one.meets_error() && one.cell->algorithm == algorithm; });
    return found == cells.end() ? nullptr : &*found;
}

const RankedCell* SceneRanking::best_peer() const {
    const auto within = std::ranges::find_if(peers, [](const RankedCell& one) { return one.meets_error(); });
    if (within != peers.end()) return &*within;
    const auto known =
        std::ranges::find_if(peers, [](const RankedCell& one) { return one.worst_error.has_value(); });
    return known == peers.end() ? nullptr : &*known;
}

const RankedCell* SceneRanking::smallest_of_ties() const {
    const RankedCell* smallest = nullptr;
    const auto bytes = [](const RankedCell& one) {
        return one.bytes_per_edge.value_or(std::numeric_limits<double>::infinity());
    };
    for (const std::size_t i : ties) {
        if (cells[i].ratio > store::fast_ratio * winner()->ratio) continue;
        if (!smallest || bytes(cells[i]) < bytes(*smallest)) smallest = &cells[i];
    }
    return smallest;
}

bool SceneRanking::ties_with_winner(const RankedCell& cell) const {
    return std::ranges::any_of(ties, [&](std::size_t i) { return &cells[i] == &cell; });
}

const RankedCell* SceneRanking::choice() const {
    if (beats_baseline) return winner();
    if (!too_noisy()) return smallest_of_ties();
    return baseline() && ties_with_winner(*baseline()) ? baseline() : winner();
}

SceneRanking rank_scene(std::span<const ReportCell* const> cells, double error_limit,
                        const Baseline& baseline) {
    SceneRanking scene;
    scene.ratios_to = baseline;
    const std::string plain = plain_axes(cells), default_flags = "build=default";
    scene.cells = ranked_cells(cells, plain, false, error_limit);
    scene.peers = ranked_cells(cells, plain, true, error_limit);
    scene.default_flags = with_default_flags(
        cells, plain.empty() ? default_flags : plain + "+" + default_flags, error_limit, baseline);
    find_own_variation(scene);
    find_ties(scene);
    scene.beats_baseline = beats_baseline(scene);
    scene.noise = noise_of(scene, cells);
    const ReportCell& any = *cells.front();
    scene.label = any.scene_label, scene.shape = any.shape;
    scene.vertices = any.vertices;
    scene.own_tables = has_own_tables(any);
    scene.sentence = scene_sentence(any);
    return scene;
}

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
                if (one.cell->algorithm == algorithm && one.ratio <= store::fast_ratio * best->ratio)
                    fast.emplace(scene.shape, algorithm, one.table);
        }
    }
    return fast;
}

void find_missing(SceneRanking& scene, const Known& fast) {
    for (const char* const algorithm : both_algorithms) {
        bool has_small = false, has_fast = false;
        for (const RankedCell& one : scene.cells) {
            if (one.cell->algorithm != algorithm) continue;
            has_small |= one.bytes_per_edge && *one.bytes_per_edge <= small_bytes_per_edge;
            has_fast = has_fast || fast.contains({scene.shape, algorithm, one.table});
        }
        const std::string name = algorithm_title(algorithm);
        if (types_of(scene, algorithm) > 0 && !scene.best(algorithm)) {
            scene.over_limit.push_back(name);
            continue;
        }
        if (!has_small) scene.not_measured.push_back(name + " on a small layout");
        if (!has_fast) scene.not_measured.push_back(name + " on a fast layout");
    }
}

}  // namespace

void check_contests(std::vector<SceneRanking>& scenes) {
    const Known fast = fast_ones(scenes);
    for (SceneRanking& scene : scenes) find_missing(scene, fast);
}

std::string SceneRanking::why_not() const {
    std::string missing, why;
    for (const std::string& cell : not_measured) append(missing, cell);
    if (!missing.empty()) why = "not measured: " + missing;
    for (const std::string& name : over_limit)
        append(why, fmt::format("every cell of {} exceeds the error limit", name), "; ");
    return why;
}

}  // namespace edgewise::reports
