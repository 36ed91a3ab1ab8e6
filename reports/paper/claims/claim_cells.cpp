// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/claims/claim_cells.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "edgewise/measure/statistics.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

/// Two numbers of a scene are the same place on an axis when they agree to this: they are written as
/// decimals.
constexpr double same_number = 1e-4;

bool same_x(double a, double b) {
    return std::abs(a - b) <= same_number * std::max(std::abs(a), std::abs(b));
}

bool fits(const ReportCell& cell, const CellKey& key) {
    return cell.algorithm == key.algorithm && cell.table == key.table &&
           (key.scene.empty() || cell.scene == key.scene) && (key.shape.empty() || cell.shape == key.shape);
}

/// Null when the cell has no such number.
std::optional<double> cells_place_of(const ReportCell& cell, const std::string& parameter) {
    if (parameter == "vertices") return static_cast<double>(cell.vertices);
    if (has_random_orientation(cell)) return std::nullopt;
    return parameter_of(cell, parameter);
}

std::string no_stored_cell(const CellKey& key) {
    return fmt::format("no cell of {}{}, {} on {} is stored",
                       key.scene.empty() ? "any scene" : "scene " + key.scene,
                       key.shape.empty() ? "" : ", " + key.shape, key.algorithm, key.table);
}

/// A point at each x that both have.
template <class Point, class Join>
std::vector<CurvePoint> joined_at(const std::vector<Point>& a, const std::vector<Point>& b, Join join) {
    std::vector<CurvePoint> curve;
    for (const Point& above : a)
        for (const Point& below : b)
            if (same_x(above.x, below.x)) curve.push_back({above.x, join(above, below)});
    return curve;
}

std::optional<Evidence> ratio_of_rounds(const ReportCell& cell) {
    std::vector<double> ratios;
    for (const measure::Round& round : cell.rounds)
        if (const auto ratio = round.ratio(&measure::Timing::all)) ratios.push_back(*ratio);
    const auto interval = median_interval(ratios);
    if (!interval) return std::nullopt;
    return interval_evidence(*measure::median(ratios), interval->low, interval->high);
}

}  // namespace

CellKey key_of(const std::string& text) {
    std::istringstream words(text);
    CellKey key;
    words >> key.algorithm >> key.scene >> key.shape;
    for (std::string* part : {&key.scene, &key.shape})
        if (*part == "*") part->clear();
    if (std::string table; std::getline(words >> std::ws, table)) key.table = table;
    return key;
}

const ReportCell* find_cell(const ReportData& data, const CellKey& key) {
    const ReportCell* first = nullptr;
    for (const ReportCell* cell : cells_in({&data.from_files, &data.cells})) {
        if (!fits(*cell, key)) continue;
        if (cell->verified()) return cell;
        if (!first) first = cell;
    }
    return first;
}

std::vector<CurveCell> cells_along(const ReportData& data, const CellKey& key, const std::string& parameter) {
    std::vector<CurveCell> found;
    for (const ReportCell* cell : cells_in({&data.from_files, &data.cells})) {
        if (!fits(*cell, key)) continue;
        if (const auto x = cells_place_of(*cell, parameter)) found.push_back({*x, cell});
    }
    std::ranges::stable_sort(found, [](const CurveCell& a, const CurveCell& b) { return a.x < b.x; });
    return found;
}

std::vector<CurveCell> in_range(const std::vector<CurveCell>& cells, const CurveRange& range) {
    std::vector<CurveCell> inside;
    for (const CurveCell& at : cells)
        if ((at.x > range.low || same_x(at.x, range.low)) && (at.x < range.high || same_x(at.x, range.high)))
            inside.push_back(at);
    return inside;
}

measure::Figure stored_figure(const ReportCell& cell, const std::string& name) {
    const std::string probe = name.substr(0, name.find('.')), rest = name.substr(probe.size() + 1);
    if (!store::find_figure(probe, rest)) throw std::out_of_range(name + ": no such figure");
    return cell.figure(probe, rest);
}

Evidence figure_of(const ReportCell& cell, const std::string& name) {
    const measure::Figure figure = stored_figure(cell, name);
    if (!cell.verified())
        return no_evidence(fmt::format("a cell is {}: {}", to_string(cell.status), cell.reason));
    if (figure.value) return exact_evidence(*figure.value);
    return no_evidence(fmt::format("{}: {}", name, figure.reason));
}

Evidence figure_of(const ReportData& data, const CellKey& key, const std::string& name) {
    const ReportCell* cell = find_cell(data, key);
    return cell ? figure_of(*cell, name) : no_evidence(no_stored_cell(key));
}

Evidence time_of(const ReportCell& cell) {
    const Evidence middle = figure_of(cell, "time.all_ns"), low = figure_of(cell, "time.all_ns_low"),
                   high = figure_of(cell, "time.all_ns_high");
    for (const Evidence* part : {&middle, &low, &high})
        if (!part->value) return *part;
    return interval_evidence(*middle.value, *low.value, *high.value);
}

Evidence time_of(const ReportData& data, const CellKey& key) {
    const ReportCell* cell = find_cell(data, key);
    return cell ? time_of(*cell) : no_evidence(no_stored_cell(key));
}

Evidence time_ratio(const ReportCell& cell, const ReportCell& baseline) {
    if (cell.verified() && baseline.verified())
        if (const auto paired = ratio_of_rounds(cell)) return *paired;
    return quotient(time_of(cell), time_of(baseline));
}

Evidence time_ratio(const ReportData& data, const CellKey& key, const CellKey& baseline) {
    const ReportCell *above = find_cell(data, key), *below = find_cell(data, baseline);
    if (!above) return no_evidence(no_stored_cell(key));
    if (!below) return no_evidence(no_stored_cell(baseline));
    return time_ratio(*above, *below);
}

std::vector<CurvePoint> ratio_curve(const std::vector<CurveCell>& cells,
                                    const std::vector<CurveCell>& baselines) {
    return joined_at(cells, baselines, [](const CurveCell& above, const CurveCell& below) {
        return time_ratio(*above.cell, *below.cell);
    });
}

std::vector<CurvePoint> joined_curve(const std::vector<CurvePoint>& a, const std::vector<CurvePoint>& b,
                                     Evidence (*join)(const Evidence&, const Evidence&)) {
    return joined_at(
        a, b, [&](const CurvePoint& above, const CurvePoint& below) { return join(above.y, below.y); });
}

std::string paper_shape(int vertices) {
    return vertices == 4 ? "tetra4" : vertices == 8 ? "cube8" : "sphere" + std::to_string(vertices);
}

namespace {

constexpr std::size_t fewest_points = 3;

/// Null when all can be fitted.
std::optional<Evidence> unfit(const std::vector<CurvePoint>& curve) {
    for (const CurvePoint& point : curve) {
        if (!point.y.value) return point.y;
        if (!(point.x > 0) || !(point.y.low > 0)) return no_evidence("a value of 0 has no logarithm");
    }
    if (curve.size() < fewest_points || curve.front().x == curve.back().x)
        return no_evidence(
            fmt::format("{} sizes are stored, a growth needs {}", curve.size(), fewest_points));
    return std::nullopt;
}

double root_mean_square(const std::vector<double>& all) {
    double squares = 0;
    for (const double one : all) squares += one * one;
    return std::sqrt(squares / static_cast<double>(all.size()));
}

}  // namespace

Evidence growth_exponent(const std::vector<CurvePoint>& curve) {
    if (const auto why = unfit(curve)) return *why;
    double middle = 0, squares = 0;
    for (const CurvePoint& point : curve) middle += std::log(point.x) / static_cast<double>(curve.size());
    for (const CurvePoint& point : curve) squares += std::pow(std::log(point.x) - middle, 2);
    double slope = 0, low = 0, high = 0;
    for (const CurvePoint& point : curve) {
        const double weight = (std::log(point.x) - middle) / squares;
        slope += weight * std::log(*point.y.value);
        low += weight * std::log(weight > 0 ? point.y.low : point.y.high);
        high += weight * std::log(weight > 0 ? point.y.high : point.y.low);
    }
    // A curve without intervals has none either; sums in another order would differ in their last bit.
    const auto timed = [](const CurvePoint& point) { return point.y.has_interval(); };
    if (std::ranges::none_of(curve, timed)) return exact_evidence(slope);
    return interval_evidence(slope, low, high);
}

LogOrPower log_or_power(const std::vector<CurvePoint>& curve) {
    if (const auto why = unfit(curve)) return {*why, *why};
    std::vector<double> t, y, log_y, relative;
    for (const CurvePoint& point : curve) {
        t.push_back(std::log(point.x));
        y.push_back(*point.y.value);
        log_y.push_back(std::log(y.back()));
        relative.push_back(1 / (y.back() * y.back()));
    }
    const auto logarithm = measure::least_squares(t, y, relative).value();
    const auto power = measure::least_squares(t, log_y).value();
    std::vector<double> of_logarithm, of_power;
    for (std::size_t i = 0; i < t.size(); ++i) {
        of_logarithm.push_back((logarithm.intercept + logarithm.slope * t[i]) / y[i] - 1);
        of_power.push_back(std::exp(power.intercept + power.slope * t[i]) / y[i] - 1);
    }
    return {exact_evidence(root_mean_square(of_logarithm)), exact_evidence(root_mean_square(of_power))};
}

}  // namespace edgewise::reports
