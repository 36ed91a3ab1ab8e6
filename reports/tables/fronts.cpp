// SPDX-License-Identifier: MIT
#include "edgewise/reports/tables/fronts.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "edgewise/reports/tables/pareto_front.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

/// Axes that place tables, and GJK's tolerance, leave the question as it is.
bool asks_another_question(const ReportCell& cell) {
    return cell.axis("needs") || cell.axis("contact_tolerance");
}

/// Why a timed cell has no place beside the others; empty: it has one, and `point` is it.
std::string read_point(const ReportCell& cell, FrontPoint& point) {
    if (cell.is_raw()) return "raw V-Clip is judged, and not for its speed";
    if (asks_another_question(cell)) return "its axis asks another question";
    const measure::Figure time = cell.figure(store::separated_time.ns);
    if (!time.value) return "time: " + time.reason;
    if (!(*time.value > 0)) return "a time of 0 has no place on a logarithmic axis";
    point = {&cell, *time.value, {}, {}};
    for (std::size_t kind = 0; kind < error_kind_count; ++kind)
        point.errors[kind] = cell.figure(error_kinds[kind].figure).value;
    if (std::any_of(point.errors.begin(), point.errors.end(), [](const auto& error) { return bool(error); }))
        return {};
    return "error: " + cell.figure("error.worst_error_given").reason;
}

void find_front(std::vector<FrontPoint>& points, std::size_t kind) {
    std::vector<SpeedError> plane;
    std::vector<FrontPoint*> whose;
    for (FrontPoint& point : points) {
        if (!point.errors[kind]) continue;
        plane.push_back({point.ns, *point.errors[kind]});
        whose.push_back(&point);
    }
    const std::vector<bool> front = pareto_front(plane);
    for (std::size_t i = 0; i < whose.size(); ++i) whose[i]->on_front[kind] = front[i];
}

void finish(FrontPanel& panel) {
    std::stable_sort(panel.points.begin(), panel.points.end(),
                     [](const FrontPoint& a, const FrontPoint& b) { return a.ns < b.ns; });
    for (std::size_t kind = 0; kind < error_kind_count; ++kind) find_front(panel.points, kind);
}

}  // namespace

bool FrontPoint::on_any_front() const {
    return std::any_of(on_front.begin(), on_front.end(), [](bool on) { return on; });
}

bool FrontPanel::has_peers() const {
    return std::any_of(points.begin(), points.end(),
                       [](const FrontPoint& point) { return point.cell->judged(); });
}

std::string gap_tolerance_of(const ReportCell& cell) { return cell.axis("gap_tolerance").value_or(""); }

Fronts fronts_of(const ReportData& data) {
    const std::vector<std::string> scenes = scene_labels(data);
    std::map<std::tuple<std::ptrdiff_t, std::int64_t, std::string>, FrontPanel> panels;
    Fronts fronts;
    for (const auto* from : {&data.cells, &data.from_files, &data.peers}) {
        for (const ReportCell& cell : *from) {
            if (!cell.is_timed()) continue;
            FrontPoint point{};
            std::string why = read_point(cell, point);
            if (!why.empty()) {
                fronts.left_out.emplace_back(&cell, std::move(why));
                continue;
            }
            const auto scene = std::find(scenes.begin(), scenes.end(), cell.scene_label) - scenes.begin();
            FrontPanel& panel = panels[{scene, cell.vertices, cell.shape}];
            panel.scene_label = cell.scene_label, panel.shape = cell.shape, panel.vertices = cell.vertices;
            panel.points.push_back(point);
        }
    }
    for (auto& [key, panel] : panels) {
        finish(panel);
        fronts.panels.push_back(std::move(panel));
    }
    return fronts;
}

}  // namespace edgewise::reports
