// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/chapters/chapters.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>

#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

constexpr store::FigureName total_bytes("bytes.total_bytes_per_edge"), plane_bytes("bytes.voronoi_planes"),
    knee_bytes("reuse.line_knee_bytes"), query_lines("reuse.lines_per_query"), build_ns("build.build_ns"),
    refit_ns("build.refit_ns");

std::string full_name(const ReportCell& cell) {
    return fmt::format("{} on {}", algorithm_title(cell.algorithm), cell.table);
}

/// The cell with the smallest value of a figure; null where none has it.
const ReportCell* cell_of_least(const std::vector<const ReportCell*>& cells, const store::FigureName& name) {
    const ReportCell* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const ReportCell* cell : cells) {
        const auto value = cell->figure(name).value;
        if (value && *value < least) least = *value, best = cell;
    }
    return best;
}

const ReportCell* cell_of(const std::vector<const ReportCell*>& cells, const Baseline& baseline) {
    const auto found = std::ranges::find_if(
        cells, [&](const ReportCell* cell) { return baseline.is(cell->algorithm, cell->table); });
    return found == cells.end() ? nullptr : *found;
}

std::string lines_and_knee(const ReportCell& cell) {
    const auto lines = cell.figure(query_lines).value, knee = cell.figure(knee_bytes).value;
    std::string text = fmt::format("{} touches {} lines", full_name(cell), lines ? number_text(*lines) : "?");
    return knee ? fmt::format("{} and thrashes below {} of cache", text, size_text(*knee)) : text;
}

/// Empty where the cell has no such figures.
std::string lines_and_building(const ReportCell& cell) {
    const auto lines = cell.figure(store::lines_read.warm()).value, build = cell.figure(build_ns).value,
               refit = cell.figure(refit_ns).value;
    if (!lines || !build || !refit) return {};
    return fmt::format("{} reads {} lines per warm query, is built in {} us and refitted in {}", cell.table,
                       number_text(*lines), number_text(*build / 1000), number_text(*refit / 1000));
}

double sum_of(const std::vector<ReportCell>& rows, const store::FigureName& name) {
    double sum = 0;
    for (const ReportCell& row : rows)
        if (!row.is_raw()) sum += row.figure(name).value.value_or(0);
    return sum;
}

}  // namespace

std::string errors_sentence(const ReportData& data) {
    double checked = 0, wrong = 0;
    std::map<std::string, double> worst;  // by precision
    for (const ReportCell* cell : data.swept()) {
        if (cell->judged()) continue;
        checked += cell->figure("error.checked").value.value_or(0);
        wrong += cell->figure("error.wrong_verdicts").value.value_or(0);
        if (const auto error = cell->figure("error.worst_error_given").value)
            worst[cell->precision] = std::max(worst[cell->precision], *error);
    }
    if (checked == 0) return {};
    std::string errors;
    for (const auto& [precision, error] : worst)
        append(errors, fmt::format("{} in {}", number_text(error, "scale"), precision));
    return fmt::format(
        "Of {} checked answers {} have a wrong verdict; the worst error of a distance over the pair's scale is {}.",
        checked, wrong, errors);
}

std::string counters_sentence(const ReportData& data) {
    const std::vector<const ReportCell*> cells = verified_cells(data, reference_shape(data));
    if (cells.empty()) return {};
    const ReportCell& cell = cell_of(cells, {}) ? *cell_of(cells, {}) : *cells.front();
    const measure::Figure counted = cell.figure("counters.instructions");
    return counted.value ? fmt::format("In {}, {}, {} retires {} instructions per query.", cell.scene_label,
                                       cell.shape, full_name(cell), number_text(*counted.value))
                         : "Instructions and misses were not counted: " + counted.reason + ".";
}

std::string bytes_sentence(const ReportData& data) {
    const std::string shape = reference_shape(data);
    std::vector<const ReportCell*> cells = verified_cells(data, shape);
    std::erase_if(cells, [](const ReportCell* cell) { return cell->algorithm != "vclip"; });
    const ReportCell *smallest = cell_of_least(cells, total_bytes), *paper = cell_of(cells, {});
    if (!smallest || !paper) return {};
    const auto total = paper->figure(total_bytes).value, planes = paper->figure(plane_bytes).value;
    if (!total || !planes) return {};
    return fmt::format(
        "Of the {} bytes per edge that V-Clip's table takes in the paper's layout ({}, {}), {:.0f} % are "
        "Voronoi planes; the smallest table that it runs on takes {} ({}).",
        number_text(*total, "B/edge"), paper->table, shape, 100 * *planes / *total,
        number_text(*smallest->figure(total_bytes).value, "B/edge"), smallest->table);
}

std::string misses_sentence(const ReportData& data) {
    std::vector<const ReportCell*> cells = modelled_cells(data);
    if (cells.empty()) return {};
    // The scene with the most lines is where caches matter.
    const auto most = std::ranges::max_element(cells, [](const auto* a, const auto* b) {
        constexpr store::FigureName lines("reuse.lines_of_scene");
        return a->figure(lines).value.value_or(0) < b->figure(lines).value.value_or(0);
    });
    const std::string scene = (*most)->scene_label, shape = (*most)->shape;
    std::erase_if(cells, [&](const ReportCell* cell) {
        return cell->scene_label != scene || cell->shape != shape || cell->algorithm != "vclip";
    });
    const ReportCell *paper = cell_of(cells, {}), *least = cell_of_least(cells, knee_bytes);
    if (!paper || !least) return {};
    std::string text = fmt::format("In {}, {}, a query of {}", scene, shape, lines_and_knee(*paper));
    if (least != paper) text += fmt::format("; one of {}", lines_and_knee(*least));
    return text + ".";
}

std::string layouts_sentence(const ReportData& data) {
    const std::string shape = reference_shape(data);
    std::vector<const ReportCell*> cells = verified_cells(data, shape, reference_scene(data));
    std::erase_if(cells, [](const ReportCell* cell) { return cell->algorithm != "vclip"; });
    const ReportCell *paper = cell_of(cells, {}), *least = cell_of_least(cells, store::lines_read.warm());
    if (!paper || !least) return {};
    const std::string of_paper = lines_and_building(*paper), of_least = lines_and_building(*least);
    if (of_paper.empty() || of_least.empty()) return {};
    const std::string text = fmt::format("V-Clip's table of {} in the paper's layout, {}", shape, of_paper);
    return least == paper ? text + "." : fmt::format("{}; {}.", text, of_least);
}

std::string times_sentence(const Answer& answer, const ReportData& data) {
    for (const SceneRanking* of : answer.scenes()) {
        const SceneRanking& scene = *of;
        const RankedCell* baseline = scene.baseline();
        if (!baseline) continue;
        std::vector<const ReportCell*> cells = verified_cells(data, "", scene.label);
        std::erase_if(cells, [&](const ReportCell* cell) {
            return cell->table != baseline->table || cell->algorithm != baseline->cell->algorithm ||
                   cell->shape_source != "built-in" || !cell->figure(store::all_time.ns).value;
        });
        if (cells.empty()) continue;
        const auto [small, large] = std::ranges::minmax_element(
            cells, [](const ReportCell* a, const ReportCell* b) { return a->vertices < b->vertices; });
        const auto ns = [](const ReportCell& cell) {
            return number_text(*cell.figure(store::all_time.ns).value);
        };
        std::string text = fmt::format("In {}, {} takes {} ns per query with {} vertices", scene.label,
                                       baseline->name(), ns(**small), (*small)->vertices);
        if (large != small) text += fmt::format(" and {} with {}", ns(**large), (*large)->vertices);
        return text + ".";
    }
    return {};
}

std::string fronts_sentence(const ReportData& data) {
    std::size_t points = 0, on_front = 0;
    const std::string shape = reference_shape(data);
    for (const FrontPanel& panel : fronts_of(data).panels) {
        if (panel.shape != shape) continue;
        points += panel.points.size();
        for (const FrontPoint& point : panel.points) on_front += point.on_any_front();
    }
    if (points == 0) return {};
    return fmt::format(
        "Of {} with {}, {} are on a front of time and error: no other of their scene is as "
        "fast and as exact.",
        plural(points, "cell"), shape, on_front);
}

std::string stability_sentence(const ReportData& data) {
    if (data.stability.empty()) return {};
    const double cases = sum_of(data.stability, "stability.cases"),
                 wrong = sum_of(data.stability, "stability.wrong_outside_band"),
                 beyond = sum_of(data.stability, "stability.errors_beyond"),
                 in_band = sum_of(data.stability, "stability.in_band"),
                 differing = sum_of(data.stability, "stability.wrong_inside_band");
    return prose("hard_cases.md", fmt::arg("cases", cases), fmt::arg("wrong", wrong),
                 fmt::arg("beyond", beyond), fmt::arg("in_band", in_band), fmt::arg("differing", differing));
}

std::string peers_sentence(const Answer& answer) {
    for (const SceneRanking* scene : answer.scenes()) {
        const RankedCell *peer = scene->best_peer(), *winner = scene->winner();
        if (!peer || !winner) continue;
        return fmt::format(
            "In {}, {}, the fastest other library {}, {}, takes {:.2f} times as long as {} (worst errors {} and {}).",
            scene->label, scene->shape,
            peer->meets_error() ? "within the error" : "(none is within the error)", peer->name(),
            peer->ratio / winner->ratio, winner->name(),
            peer->worst_error ? number_text(*peer->worst_error, "scale") : "not measured",
            number_text(*winner->worst_error, "scale"));
    }
    return {};
}

std::string policy_sentence(const ReportData& data) {
    std::size_t pairs[2] = {}, changed[2] = {};  // under other policies; under prefetchers
    for (const auto& row : policy_grid(data).rows) {
        const std::string& policy = row[3].text;
        const bool fetches = policy.ends_with("/next_line") || policy.ends_with("/stream");
        pairs[fetches] += std::stoul(row[5].text), changed[fetches] += std::stoul(row[6].text);
    }
    if (pairs[0] + pairs[1] == 0) return {};
    std::string text = fmt::format(
        "Under tree-PLRU or random replacement instead of LRU, {} of {} pairs of tables change places by "
        "misses",
        changed[0], pairs[0]);
    if (pairs[1] > 0)
        text += fmt::format("; with a next-line or a stream prefetcher, {} of {}", changed[1], pairs[1]);
    return text + ".";
}

}  // namespace edgewise::reports
