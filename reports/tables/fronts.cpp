// SPDX-License-Identifier: MIT

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

std::vector<bool> pareto_front(std::span<const SpeedError> points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!std::isnan(points[i].ns) && !std::isnan(points[i].error)) order.push_back(i);
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return std::tie(points[a].error, points[a].ns) < std::tie(points[b].error, points[b].ns);
    });
    std::vector<bool> on_front(points.size());
    std::optional<SpeedError> last;
    for (const std::size_t i : order) {
        const SpeedError& point = points[i];
        const bool equal = last && point.ns == last->ns && point.error == last->error;
        if (last && !equal && point.ns >= last->ns) continue;
        on_front[i] = true;
        last = point;
    }
    return on_front;
}

namespace {

/// Returns why a timed cell has no place among the points; if it has one, sets `point` and returns an empty
/// text.
std::string read_point(const ReportCell& cell, FrontPoint& point) {
    if (cell.is_raw()) return "raw V-Clip is judged, and not for its speed";
    // Axes that place tables, and GJK's tolerance, leave the question as it is.
    if (cell.axis("needs") || cell.axis("contact_tolerance") || cell.axis("radius"))
        return "its axis asks another question";
    const measure::Figure time = cell.figure(store::separated_time.ns);
    if (!time.value) return "time: " + time.reason;
    if (!(*time.value > 0)) return "a time of 0 has no place on a logarithmic axis";
    point = {&cell, *time.value, {}, {}};
    for (std::size_t kind = 0; kind < error_kind_count; ++kind)
        point.errors[kind] = cell.figure(error_kinds[kind].figure).value;
    if (std::ranges::any_of(point.errors, [](const auto& error) { return bool(error); })) return {};
    return "error: " + cell.figure("error.worst_error_given").reason;
}

void find_front(std::vector<FrontPoint>& points, std::size_t kind) {
    std::vector<SpeedError> plane;
    for (const FrontPoint& point : points)
        plane.push_back({point.ns, point.errors[kind].value_or(on_no_front)});
    const std::vector<bool> front = pareto_front(plane);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].on_front[kind] = front[i];
}

}  // namespace

bool FrontPoint::on_any_front() const {
    return std::ranges::any_of(on_front, [](bool on) { return on; });
}

Fronts fronts_of(const ReportData& data) {
    const std::vector<std::string> scenes = scene_labels(data);
    std::map<std::tuple<std::ptrdiff_t, std::int64_t, std::string>, FrontPanel> panels;
    Fronts fronts;
    for (const ReportCell* cell : cells_in({&data.cells, &data.from_files, &data.peers})) {
        if (!cell->is_timed()) continue;
        FrontPoint point{};
        std::string why = read_point(*cell, point);
        if (!why.empty()) {
            fronts.left_out.emplace_back(cell, std::move(why));
            continue;
        }
        const auto scene = std::ranges::find(scenes, cell->scene_label) - scenes.begin();
        FrontPanel& panel = panels[{scene, cell->vertices, cell->shape}];
        panel.scene_label = cell->scene_label, panel.shape = cell->shape, panel.vertices = cell->vertices;
        panel.points.push_back(point);
    }
    for (auto& [key, panel] : panels) {
        std::ranges::stable_sort(panel.points, {}, &FrontPoint::ns);
        for (std::size_t kind = 0; kind < error_kind_count; ++kind) find_front(panel.points, kind);
        fronts.panels.push_back(std::move(panel));
    }
    return fronts;
}

namespace {

const std::string& front_name(const ReportCell& cell) { return cell.judged() ? cell.layout : cell.algorithm; }

const std::string& front_table(const ReportCell& cell) { return cell.judged() ? cell.precision : cell.table; }

/// Errors with which the point is on the front: "p50, worst".
std::string fronts_it_is_on(const FrontPoint& point) {
    std::string list;
    for (std::size_t kind = 0; kind < error_kind_count; ++kind)
        if (point.on_front[kind]) append(list, std::string(error_kinds[kind].title));
    return list;
}

}  // namespace

TextGrid front_grid(const ReportData& data, const std::string& shape) {
    TextGrid grid{"On a front of time and error: by scene and shape, fastest first",
                  columns_of("scene|shape|#vertices|algorithm or library|table type or precision|"
                             "#ns per query|#p50 error|#p99.9 error|#worst error|on the front of|"
                             "#wrong verdicts|#checked|#cells compared")};
    for (const FrontPanel& panel : fronts_of(data).panels) {
        if (!shape.empty() && panel.shape != shape) continue;
        for (const FrontPoint& point : panel.points) {
            if (!point.on_any_front()) continue;
            const ReportCell& cell = *point.cell;
            grid.add(panel.scene_label, panel.shape, panel.vertices, front_name(cell), front_table(cell),
                     cell.figure(store::separated_time.ns), cell.figure(error_kinds[0].figure),
                     cell.figure(error_kinds[1].figure), cell.figure(error_kinds[2].figure),
                     fronts_it_is_on(point), cell.figure("error.wrong_verdicts"),
                     cell.figure("error.checked"), panel.points.size());
        }
    }
    return grid;
}

TextGrid left_out_grid(const ReportData& data) {
    std::map<std::tuple<std::string, std::string, std::string>, std::size_t> cells;
    for (const auto& [cell, why] : fronts_of(data).left_out)
        ++cells[{front_name(*cell), front_table(*cell), why}];
    TextGrid grid{"Timed and among no points",
                  columns_of("algorithm or library|table type or precision|#cells|why")};
    for (const auto& [key, count] : cells)
        grid.add(std::get<0>(key), std::get<1>(key), count, std::get<2>(key));
    return grid;
}

}  // namespace edgewise::reports
