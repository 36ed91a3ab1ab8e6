// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/answer.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

bool any_unfinished(const std::vector<SweepRun>& runs) {
    return std::ranges::any_of(runs, [](const SweepRun& run) { return !run.finished(); });
}

std::size_t missing_cells(const std::vector<SweepRun>& runs) {
    std::size_t missing = 0;
    for (const SweepRun& run : runs)
        if (!run.finished() && run.planned > run.done) missing += run.planned - run.done;
    return missing;
}

namespace {

/// Returns the sweeps of the build that is shown.
std::vector<SweepRun> sweep_runs(const ReportData& data) {
    std::vector<SweepRun> runs;
    for (const auto& [command, value] : data.meta_with(store::run_key)) {
        const auto json = input::json_or_null(value);
        if (input::text_member(json, "build") != data.build.id) continue;
        const auto count = [&](const char* name) {
            return json.contains(name) && json[name].is_number_unsigned() ? json[name].get<std::size_t>() : 0;
        };
        runs.push_back({command, count("cells"), count("done"), input::text_member(json, "started"),
                        input::text_member(json, "ended")});
    }
    return runs;
}

/// Returns "# cases at #e-#" for "3 cases at 1e-6", so that reasons that differ in numbers are equal.
std::string without_numbers(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (!std::isdigit(static_cast<unsigned char>(c)) && !(c == '.' && !out.empty() && out.back() == '#'))
            out += c;
        else if (out.empty() || out.back() != '#')
            out += '#';
    }
    return out;
}

struct Found {
    Gap gap;
    std::set<std::string> probes, reasons;
};

/// Counts the gaps of a store's cells and rows. Reasons that differ in numbers only are one, each number a #.
Gaps gaps_of(const ReportData& data) {
    Gaps all;
    std::map<std::pair<std::string, std::string>, Found> found;
    for (const ReportCell* cell : data.rows_and_peers()) {
        for (const store::FigureRow& figure : cell->figures) {
            ++(figure.value ? all.measured : all.missing);
            if (figure.value) continue;
            Found& one = found[{without_numbers(figure.reason), without_numbers(figure.remedy)}];
            if (one.gap.figures++ == 0) one.gap.remedy = figure.remedy, one.gap.reason = figure.reason;
            one.probes.insert(figure.probe);
            one.reasons.insert(figure.reason);
        }
    }
    for (auto& [key, one] : found) {
        if (one.reasons.size() > 1) one.gap.reason = key.first, one.gap.remedy = key.second;
        one.gap.probes.assign(one.probes.begin(), one.probes.end());
        all.gaps.push_back(std::move(one.gap));
    }
    std::ranges::stable_sort(all.gaps, [](const Gap& a, const Gap& b) { return a.figures > b.figures; });
    return all;
}

/// Cells of one scene by shape.
using ByShape = std::map<std::string, std::vector<const ReportCell*>>;

/// Keeps the cells of one number of queries and one seed, of which most were timed: processes of one cell
/// answer the same queries.
void keep_one_population(std::vector<const ReportCell*>& cells) {
    std::map<std::pair<std::int64_t, std::uint64_t>, std::size_t> timed;
    for (const ReportCell* cell : cells)
        if (cell->is_timed() && !cell->judged()) ++timed[{cell->queries, cell->seed}];
    if (timed.size() < 2) return;
    const auto most =
        std::ranges::max_element(timed, {}, [](const auto& one) { return std::pair(one.second, one.first); });
    std::erase_if(
        cells, [&](const ReportCell* cell) { return std::pair(cell->queries, cell->seed) != most->first; });
}

/// Returns the scenes as the cells come.
std::vector<ByShape> scenes_of(const ReportData& data) {
    std::vector<ByShape> scenes;
    DistinctTexts keys;
    for (const ReportCell* cell : cells_in({&data.cells, &data.from_files, &data.peers, &data.again})) {
        const std::size_t place = keys.place(cell->scene + '\n' + cell->scene_parameters);
        if (place == scenes.size()) scenes.emplace_back();
        scenes[place][cell->shape].push_back(cell);
    }
    for (ByShape& shapes : scenes)
        for (auto& [shape, cells] : shapes) keep_one_population(cells);
    return scenes;
}

/// Returns the cells of the shape that a scene answers for; null if it has no shape of that name.
const std::vector<const ReportCell*>* chosen_shape(const ByShape& shapes, const Question& question,
                                                   const std::string& reference) {
    const auto found = shapes.find(question.shape.value_or(reference));
    if (found != shapes.end()) return &found->second;
    if (question.shape) return nullptr;
    return &std::ranges::max_element(shapes, [](const auto& a, const auto& b) {
                return a.second.front()->vertices < b.second.front()->vertices;
            })->second;
}

/// Returns the option of `edgewise advise` for the cell's body: its name or file, or the recording that has
/// it.
std::string body_option_of(const ReportData& data, const ReportCell& cell) {
    for (const auto& [name, text] : data.scene_files)
        if (name == cell.scene && scene_kind(cell) == "recorded")
            return " --scene " + input::json_or_null(text).value("recording", "");
    const std::string source = cell.shape_source.substr(0, cell.shape_source.find(", "));
    return " --shape " + (source.empty() || source == "built-in" ? cell.shape : source);
}

CellCounts counts_of(const ReportData& data) {
    CellCounts counts{data.cell_count(),
                      data.count(store::CellStatus::verified),
                      data.count(store::CellStatus::failed),
                      data.count(store::CellStatus::unavailable),
                      data.stability.size(),
                      0};
    for (const ReportCell& row : data.stability) {
        counts.stability_failed += row.failed();
        counts.stability_verified += row.verified() && !row.is_raw();
    }
    return counts;
}

/// Results of one table type over all scenes.
struct Tally {
    std::size_t losses = 0, ties = 0, choices = 0, dropped = 0;
    double log_ratios = 0, bytes = std::numeric_limits<double>::infinity();

    /// Geometric mean of its ratios.
    [[nodiscard]] double ratio() const { return std::exp(log_ratios / static_cast<double>(ties + losses)); }
    [[nodiscard]] bool ties_in_more_than(const Tally& other) const {
        return std::make_tuple(other.ties, losses) < std::make_tuple(ties, other.losses);
    }
    [[nodiscard]] bool better_than(const Tally& other) const {
        return std::make_tuple(other.choices, bytes) < std::make_tuple(choices, other.bytes);
    }
};

/// Table types whose mean ratios differ by no more than this are as fast.
constexpr double as_fast = 1.05;

/// By algorithm and table type.
using Tallies = std::map<std::pair<std::string, std::string>, Tally>;

/// Keeps, of what meets the error limit in every scene, what ties in most scenes among those that are no
/// slower on average than the paper's layout, and of these what is as fast on average; the paper's layout
/// itself if all that tie somewhere are slower, or over the limit.
void keep_best(Tallies& tallies, const Baseline& paper) {
    const auto own = tallies.find({paper.algorithm, paper.table});
    const Tallies only_own = own == tallies.end() || own->second.dropped > 0 ? Tallies{} : Tallies{*own};
    std::erase_if(tallies, [](const auto& one) { return one.second.ties == 0; });
    if (tallies.empty()) return;
    std::erase_if(tallies, [](const auto& one) { return one.second.dropped > 0; });
    if (tallies.empty()) tallies = only_own;
    if (!only_own.empty()) {
        const double ratio = only_own.begin()->second.ratio();
        std::erase_if(tallies, [ratio](const auto& one) { return one.second.ratio() > ratio; });
        if (tallies.empty()) tallies = only_own;
    }
    if (tallies.empty()) return;
    const auto tally_of = [](const auto& one) -> const Tally& { return one.second; };
    const Tally most = std::ranges::min_element(tallies, &Tally::ties_in_more_than, tally_of)->second;
    std::erase_if(tallies, [&](const auto& one) { return most.ties_in_more_than(one.second); });
    const double least = std::ranges::min_element(tallies, {}, [](const auto& one) {
                             return one.second.ratio();
                         })->second.ratio();
    std::erase_if(tallies, [&](const auto& one) { return one.second.ratio() > as_fast * least; });
}

}  // namespace

Baseline baseline_of(const ReportData& data) {
    const std::string pair = data.meta_value("baseline").value_or("");
    const std::size_t cross = pair.find(" x ");
    if (cross == pair.npos) return {};
    return {pair.substr(0, cross), pair.substr(cross + 3)};
}

std::vector<const SceneRanking*> Answer::scenes() const {
    std::vector<const SceneRanking*> all;
    for (const auto* from : {&shared, &own, &near})
        for (const SceneRanking& scene : *from) all.push_back(&scene);
    return all;
}

Answer answer_of_scenes(const ReportData& data, const Question& question) {
    Answer answer;
    answer.question = question;
    answer.baseline = baseline_of(data);
    answer.runs = sweep_runs(data);
    answer.shape = question.shape.value_or(reference_shape(data));
    std::vector<SceneRanking> scenes;
    for (const ByShape& shapes : scenes_of(data)) {
        const auto* cells = chosen_shape(shapes, question, answer.shape);
        if (!cells) continue;
        const ReportCell& any = *cells->front();
        if (any.shape == answer.shape) answer.body_option = body_option_of(data, any);
        SceneRanking scene = rank_scene(*cells, question.error_limit, answer.baseline);
        if (!scene.cells.empty()) scenes.push_back(std::move(scene));
    }
    check_contests(scenes);
    for (SceneRanking& scene : scenes) {
        const bool near = is_near_contact(*scene.cells.front().cell);
        if (!near && scene.own_tables != question.own_tables.value_or(scene.own_tables)) continue;
        const double bodies = parameter_of(*scene.cells.front().cell, "bodies").value_or(0);
        if (scene.own_tables && question.bodies.value_or(bodies) != bodies) continue;
        if (scene.shape == answer.shape) answer.vertices = scene.vertices;
        (near ? answer.near : scene.own_tables ? answer.own : answer.shared).push_back(std::move(scene));
    }
    return answer;
}

Answer answer_of(const ReportData& data, const Question& question) {
    Answer answer = answer_of_scenes(data, question);
    answer.counts = counts_of(data);
    answer.gaps = gaps_of(data);
    return answer;
}

const Recommendation::InScene& Recommendation::example() const {
    const InScene* best = nullptr;
    const auto rank = [](const InScene& one) { return std::make_tuple(!one.ties, one.cell->ratio); };
    for (const InScene& one : scenes)
        if (one.cell && (!best || rank(one) < rank(*best))) best = &one;
    return *best;
}

bool Recommendation::beats_baseline_somewhere() const {
    return std::ranges::any_of(scenes,
                               [](const InScene& one) { return one.ties && one.scene->beats_baseline; });
}

std::optional<double> worst_error_of(const std::vector<SceneRanking>& scenes, const std::string& algorithm,
                                     const std::string& table) {
    std::optional<double> worst;
    for (const SceneRanking& scene : scenes) {
        const RankedCell* one = scene.recommends() ? scene.find(algorithm, table) : nullptr;
        if (one && one->worst_error) worst = std::max(worst.value_or(0), *one->worst_error);
    }
    return worst;
}

std::optional<Recommendation> recommendation_of(const std::vector<SceneRanking>& scenes) {
    Tallies tallies;
    const bool any_quiet = std::ranges::any_of(scenes, [](const SceneRanking& scene) {
        return scene.winner() && scene.recommends() && !scene.too_noisy();
    });
    for (const SceneRanking& scene : scenes) {
        if (!scene.recommends() || (any_quiet && scene.too_noisy())) continue;
        for (const RankedCell& one : scene.cells) {
            Tally& tally = tallies[{one.cell->algorithm, one.table}];
            const bool fast = scene.winner() && one.ratio <= store::fast_ratio * scene.winner()->ratio;
            ++(fast && scene.ties_with_winner(one) ? tally.ties : tally.losses);
            tally.choices += &one == scene.choice();
            tally.dropped += !one.dropped.empty();
            tally.log_ratios += std::log(one.ratio);
            tally.bytes = one.bytes_per_edge.value_or(tally.bytes);
        }
    }
    if (!scenes.empty()) keep_best(tallies, scenes.front().ratios_to);
    if (tallies.empty()) return std::nullopt;
    const auto best = std::ranges::min_element(
        tallies, [](const auto& a, const auto& b) { return a.second.better_than(b.second); });
    Recommendation take{best->first.first, best->first.second, {}};
    take.worst_error = worst_error_of(scenes, take.algorithm, take.table);
    for (const SceneRanking& scene : scenes) {
        if (!scene.winner() || !scene.recommends() || (any_quiet && scene.too_noisy())) continue;
        const RankedCell* cell = scene.find(take.algorithm, take.table);
        take.scenes.push_back({&scene, cell, cell && scene.ties_with_winner(*cell)});
    }
    return take;
}

}  // namespace edgewise::reports
