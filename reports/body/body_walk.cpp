// SPDX-License-Identifier: MIT
#include "edgewise/reports/body/body_heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "edgewise/reports/answer/ranking.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

struct StoredStep {
    std::string state;
    std::vector<std::uint32_t> a, b, lines;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StoredStep, state, a, b, lines)

struct StoredWalk {
    std::uint32_t query = 0;
    std::vector<std::uint32_t> tables;  ///< lines of each
    std::vector<StoredStep> steps;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StoredWalk, query, tables, steps)

namespace {

bool fits(const StoredWalk& walk, std::size_t vertices) {
    constexpr std::uint32_t most_lines = 1 << 24;
    const auto are_below = [](const std::vector<std::uint32_t>& numbers, std::size_t end) {
        return std::ranges::all_of(numbers, [&](std::uint32_t number) { return number < end; });
    };
    if (walk.tables.empty() || walk.tables.size() > 2 || !are_below(walk.tables, most_lines)) return false;
    const std::size_t lines = std::accumulate(walk.tables.begin(), walk.tables.end(), std::size_t{0});
    return !walk.steps.empty() && !walk.steps.back().a.empty() && !walk.steps.back().b.empty() &&
           std::ranges::all_of(walk.steps, [&](const StoredStep& step) {
               return are_below(step.a, vertices) && are_below(step.b, vertices) &&
                      are_below(step.lines, lines);
           });
}

std::optional<StoredWalk> stored_walk(const nlohmann::json& json, std::size_t vertices) {
    try {
        auto walk = json.get<StoredWalk>();
        if (fits(walk, vertices)) return walk;
    } catch (const nlohmann::json::exception&) {
        // A store of another program: it is drawn without the walk.
    }
    return std::nullopt;
}

const char* kind_of(const std::vector<std::uint32_t>& vertices) {
    return vertices.size() == 1 ? "vertex" : vertices.size() == 2 ? "edge" : "face";
}

bool is_simplex(const StoredStep& step) { return step.state == "gjk_iteration"; }

std::string step_text(const StoredStep& step, std::size_t number, std::size_t count) {
    const std::string what = step.state == "start" ? "search for the vertices that face each other"
                             : is_simplex(step)
                                 ? "simplex of " + plural(step.a.size(), "corner")
                                 : fmt::format("{} of A, {} of B", kind_of(step.a), kind_of(step.b));
    return fmt::format("Step {} of {}: {}.", number, count, what);
}

/// Draws the steps on a body as the other body sees it: the last feature is in the middle. Shows the part of
/// the body with the features.
WalkDrawing body_drawing(const std::string& name, const HeatBody& body, const StoredWalk& walk,
                         std::vector<std::uint32_t> StoredStep::*member) {
    const std::array<double, 3> middle = middle_of(body);
    std::array<double, 3> towards = {};
    for (const std::uint32_t v : walk.steps.back().*member)
        for (std::size_t k = 0; k < 3; ++k) towards[k] += body.vertices[v][k] - middle[k];
    std::vector<BodyPoint> points = seen_points(body, -std::atan2(towards[0], towards[2]),
                                                std::atan2(towards[1], std::hypot(towards[0], towards[2])));
    WalkDrawing drawing{name, {}, {}};
    constexpr double half = body_size / 2;
    double reach = half / 2;
    for (const StoredStep& step : walk.steps) {
        std::vector<std::uint32_t> vertices = step.*member;
        if (is_simplex(step)) {  // corners may share a vertex of one body
            std::ranges::sort(vertices);
            vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        }
        for (const std::uint32_t v : vertices)
            reach = std::max({reach, 1.3 * std::abs(points[v].x - half), 1.3 * std::abs(points[v].y - half)});
        drawing.steps.push_back(ring_path(vertices, points));
        const std::string kind = is_simplex(step) ? "simplex on" : kind_of(vertices);
        drawing.said.push_back(
            vertices.empty() ? name : fmt::format("{}: {} {}", name, kind, fmt::join(vertices, ", ")));
    }
    reach = std::min(reach, half);
    // Faces end at the border; those behind it have no area there, and are not drawn.
    for (BodyPoint& point : points)
        point = {std::clamp(point.x, half - reach, half + reach),
                 std::clamp(point.y, half - reach, half + reach)};
    drawing.ground = fmt::format("{}", fmt::join(face_paths(body, points), ""));
    drawing.box = fmt::format("{0:.0f} {0:.0f} {1:.0f} {1:.0f}", half - reach, 2 * reach);
    return drawing;
}

/// A square for each line, as many in a row for every table of this body: the paper's table is about as high
/// as wide. A second table starts below the first, after an empty row.
WalkDrawing table_drawing(const std::string& table, const StoredWalk& walk, std::size_t vertices) {
    constexpr double lines_per_vertex = 11;  // of the paper's table
    const std::size_t columns = static_cast<std::size_t>(
        std::ceil(std::sqrt(lines_per_vertex * static_cast<double>(vertices * walk.tables.size()))));
    const std::size_t of_first = walk.tables.front();
    const std::size_t second_row = (of_first + columns - 1) / columns + 1;
    WalkDrawing drawing{table, {}, {}};
    std::size_t row = 0, all = 0;
    for (const std::size_t lines : walk.tables) {
        const std::size_t rows = lines / columns, rest = lines % columns;
        drawing.ground +=
            fmt::format("M0 {0}h{1}v{2}h-{1}zM0 {3}h{4}v1h-{4}z", row, columns, rows, row + rows, rest);
        drawing.box = fmt::format("0 0 {} {}", columns, row + rows + (rest > 0 ? 1 : 0));
        row = second_row, all += lines;
    }
    std::set<std::uint32_t> known;
    for (const StoredStep& step : walk.steps) {
        std::string path;
        const std::size_t before = known.size();
        for (const std::uint32_t line : step.lines) {
            known.insert(line);
            const std::size_t place = line < of_first ? line : line - of_first + second_row * columns;
            path += fmt::format("M{} {}h.9v.9h-.9z", place % columns, place / columns);
        }
        drawing.steps.push_back(path);
        drawing.said.push_back(fmt::format("{}: {}, {} of them new; {} of {} so far", table,
                                           plural(step.lines.size(), "line"), known.size() - before,
                                           known.size(), all));
    }
    return drawing;
}

}  // namespace

void add_walk(const nlohmann::json& json, const ReportCell& cell, const HeatBody& body,
              std::vector<BodyWalk>& walks) {
    const auto stored = stored_walk(json, body.vertices.size());
    if (!stored) return;
    BodyWalk walk{fmt::format("{}, {}, {}, query {}", algorithm_title(cell.algorithm), cell.scene_label,
                              cell.shape, stored->query),
                  {},
                  {body_drawing("Body A", body, *stored, &StoredStep::a),
                   body_drawing("Body B", body, *stored, &StoredStep::b)},
                  {}};
    for (const StoredStep& step : stored->steps)
        walk.said.push_back(step_text(step, walk.said.size() + 1, stored->steps.size()));
    auto same = std::ranges::find_if(walks, [&](const BodyWalk& other) {
        return other.title == walk.title && other.bodies[0].said == walk.bodies[0].said &&
               other.bodies[1].said == walk.bodies[1].said;
    });
    if (same == walks.end()) same = walks.insert(same, std::move(walk));
    WalkDrawing table = table_drawing(cell.table, *stored, body.vertices.size());
    const auto lines = std::accumulate(stored->tables.begin(), stored->tables.end(), std::size_t{0});
    const bool is_last = same->tables.size() < 2 || lines < same->lines_of_last;
    if (is_last) same->lines_of_last = lines;
    same->tables.insert(same->tables.end() - (is_last ? 0 : 1), std::move(table));
}

std::string walk_figure(const WalkDrawing& drawing, const char* style) {
    std::string past;
    for (std::size_t i = 0; i + 1 < drawing.steps.size(); ++i) past += drawing.steps[i];
    return fmt::format(
        "<figure><svg class=\"{}\" viewBox=\"{}\" aria-hidden=\"true\"><path class=\"ground\" d=\"{}\"/><path "
        "class=\"past\" d=\"{}\"/><path class=\"now\" d=\"{}\"/></svg><figcaption>{}</figcaption></figure>",
        style, drawing.box, drawing.ground, past, drawing.steps.back(), html_text(drawing.said.back()));
}

}  // namespace edgewise::reports
