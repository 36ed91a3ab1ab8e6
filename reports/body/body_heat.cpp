// SPDX-License-Identifier: MIT
#include "edgewise/reports/body/body_heat.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

using HeatJson = nlohmann::json;

/// Returns all members of a list as numbers; null if a member is not a number.
template <class Number>
std::optional<std::vector<Number>> numbers_of(const HeatJson& list) {
    if (!list.is_array()) return std::nullopt;
    std::vector<Number> numbers;
    for (const HeatJson& one : list) {
        if (!(std::is_floating_point_v<Number> ? one.is_number() : one.is_number_unsigned()))
            return std::nullopt;
        numbers.push_back(one.get<Number>());
    }
    return numbers;
}

bool are_below(const std::vector<std::uint32_t>& indices, std::size_t count) {
    return std::ranges::all_of(indices, [&](std::uint32_t index) { return index < count; });
}

std::optional<HeatBody> heat_body(const std::string& text) {
    const HeatJson json = input::json_or_null(text);
    if (!json.is_object()) return std::nullopt;
    const auto coordinates = numbers_of<double>(json.value("vertices", HeatJson()));
    const auto ends = numbers_of<std::uint32_t>(json.value("edges", HeatJson()));
    const HeatJson faces = json.value("faces", HeatJson());
    if (!coordinates || coordinates->size() % 3 != 0 || !ends || ends->size() % 2 != 0 || !faces.is_array())
        return std::nullopt;
    HeatBody body;
    for (std::size_t i = 0; i < coordinates->size(); i += 3)
        body.vertices.push_back({(*coordinates)[i], (*coordinates)[i + 1], (*coordinates)[i + 2]});
    if (!are_below(*ends, body.vertices.size())) return std::nullopt;
    for (std::size_t i = 0; i < ends->size(); i += 2) body.edges.push_back({(*ends)[i], (*ends)[i + 1]});
    for (const HeatJson& face : faces) {
        const auto ring = numbers_of<std::uint32_t>(face);
        if (!ring || ring->size() < 3 || !are_below(*ring, body.vertices.size())) return std::nullopt;
        body.faces.push_back(*ring);
    }
    return body;
}

/// Sets the reads of `count` features per query; false if the store has something else.
bool take_reads(const HeatJson& json, const char* kind, double queries, std::size_t count, FeatureReads& to) {
    const HeatJson list = json.value(kind, HeatJson());
    if (list.is_null()) return true;
    to = numbers_of<double>(list);
    if (!to || to->size() != count) return false;
    for (double& reads : *to) reads /= queries;
    return true;
}

std::optional<BodyHeat> heat_of_cell(const ReportCell& cell, const std::string& text, const HeatBody& body) {
    const HeatJson json = input::json_or_null(text);
    if (!json.is_object() || !json.contains("queries") || !json["queries"].is_number()) return std::nullopt;
    const double queries = json["queries"].get<double>();
    BodyHeat heat;
    heat.cell = &cell;
    const bool fits = queries > 0 &&
                      take_reads(json, "vertices", queries, body.vertices.size(), heat.vertices) &&
                      take_reads(json, "edges", queries, body.edges.size(), heat.edges) &&
                      take_reads(json, "faces", queries, body.faces.size(), heat.faces);
    if (!fits || !(heat.vertices || heat.edges || heat.faces)) return std::nullopt;
    return heat;
}

std::string reads_text(const char* one, const char* many, const FeatureReads& reads) {
    if (!reads) return fmt::format("nothing is stored of {} alone", many);
    const auto read = static_cast<std::size_t>(std::ranges::count_if(*reads, [](double r) { return r > 0; }));
    const auto most = std::ranges::max_element(*reads);
    if (read == 0) return fmt::format("none of {} was read", plural(reads->size(), one, many));
    return fmt::format("{} of {} were read, number {} the most, {} times per query", read,
                       plural(reads->size(), one, many), most - reads->begin(), number_text(*most));
}

/// Returns cells with stored reads, the reference shape's baseline first.
std::vector<const ReportCell*> cells_with_heat(const ReportData& data) {
    const std::string reference = reference_shape(data);
    const Baseline baseline = baseline_of(data);
    std::vector<const ReportCell*> cells;
    for (const ReportCell* cell : data.swept())
        if (data.meta_value(store::heat_key + cell->hash) && data.meta_value(store::body_key + cell->shape))
            cells.push_back(cell);
    std::ranges::stable_sort(cells, {}, [&](const ReportCell* cell) {
        return std::make_tuple(cell->shape != reference, cell->table != baseline.table,
                               cell->algorithm != baseline.algorithm);
    });
    return cells;
}

}  // namespace

std::string BodyHeat::title() const {
    return fmt::format("{} on {}, {}, {}", algorithm_title(cell->algorithm), cell->table, cell->scene_label,
                       cell->shape);
}

std::string BodyHeat::sentence() const {
    return fmt::format("{}; {}; {}.", reads_text("vertex", "vertices", vertices),
                       reads_text("edge", "edges", edges), reads_text("face", "faces", faces));
}

HeatOnBodies heat_on_bodies(const ReportData& data) {
    HeatOnBodies found;
    for (const ReportCell* cell : cells_with_heat(data)) {
        if (found.heats.size() == most_heats) break;
        if (!found.bodies.contains(cell->shape))
            if (auto body = heat_body(*data.meta_value(store::body_key + cell->shape)))
                found.bodies.emplace(cell->shape, std::move(*body));
        const auto body = found.bodies.find(cell->shape);
        if (body == found.bodies.end()) continue;
        auto heat = heat_of_cell(*cell, *data.meta_value(store::heat_key + cell->hash), body->second);
        if (heat) found.heats.push_back(std::move(*heat));
    }
    return found;
}

std::size_t heat_level(double reads, double most) {
    if (!(reads > 0)) return 0;
    // A hundredth of the hottest and less is the first level.
    constexpr double range = 100;
    const double part = 1 + std::log(reads / most) / std::log(range);
    return 1 + static_cast<std::size_t>(std::clamp(part, 0.0, 0.999) * (heat_levels - 1));
}

}  // namespace edgewise::reports
