// SPDX-License-Identifier: MIT
#include "edgewise/reports/body/body_heat.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
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

std::optional<BodyHeat> heat_of_cell(const ReportCell& cell, const HeatJson& json, const HeatBody& body) {
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
        const HeatJson json = input::json_or_null(*data.meta_value(store::heat_key + cell->hash));
        auto heat = heat_of_cell(*cell, json, body->second);
        if (!heat) continue;
        found.heats.push_back(std::move(*heat));
        add_walk(json.value("walk", HeatJson()), *cell, body->second, found.walks);
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

std::array<double, 3> middle_of(const HeatBody& body) {
    std::array<double, 3> middle = {};
    for (const auto& v : body.vertices)
        for (std::size_t k = 0; k < 3; ++k) middle[k] += v[k] / static_cast<double>(body.vertices.size());
    return middle;
}

std::vector<BodyPoint> seen_points(const HeatBody& body, double yaw, double pitch) {
    constexpr double margin = 12;
    const std::array<double, 3> middle = middle_of(body);
    double radius = 1e-300;
    for (const auto& v : body.vertices)
        radius = std::max(radius, std::hypot(v[0] - middle[0], v[1] - middle[1], v[2] - middle[2]));
    const double scale = (body_size / 2 - margin) / radius;
    std::vector<BodyPoint> points;
    for (const auto& v : body.vertices) {
        const double x = v[0] - middle[0], y = v[1] - middle[1], z = v[2] - middle[2];
        const double turned_x = std::cos(yaw) * x + std::sin(yaw) * z,
                     turned_z = -std::sin(yaw) * x + std::cos(yaw) * z,
                     turned_y = std::cos(pitch) * y - std::sin(pitch) * turned_z;
        points.push_back({body_size / 2 + scale * turned_x, body_size / 2 - scale * turned_y});
    }
    return points;
}

std::string ring_path(const std::vector<std::uint32_t>& ring, const std::vector<BodyPoint>& points) {
    std::string path;
    for (const std::uint32_t v : ring)
        path += fmt::format("{}{:.0f} {:.0f}", path.empty() ? "M" : "L", points[v].x, points[v].y);
    return path.empty() ? path : path + "z";
}

namespace {

/// Returns true if a ring runs counter-clockwise in the picture, that is clockwise with y downwards.
bool faces_us(const std::vector<std::uint32_t>& ring, const std::vector<BodyPoint>& points) {
    double area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const BodyPoint &a = points[ring[i]], &b = points[ring[(i + 1) % ring.size()]];
        area += a.x * b.y - b.x * a.y;
    }
    return area < 0;
}

/// Visible edges and vertices: those of the rings of visible faces.
struct Sight {
    std::vector<bool> vertices;
    std::set<std::array<std::uint32_t, 2>> edges;  ///< the smaller end first

    Sight(const HeatBody& body, const std::vector<BodyPoint>& points) : vertices(body.vertices.size()) {
        for (const auto& ring : body.faces) {
            if (!faces_us(ring, points)) continue;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                vertices[ring[i]] = true;
                edges.insert(in_order(ring[i], ring[(i + 1) % ring.size()]));
            }
        }
    }
    static std::array<std::uint32_t, 2> in_order(std::uint32_t a, std::uint32_t b) {
        return {std::min(a, b), std::max(a, b)};
    }
};

/// Returns a path for each level, of one kind of feature; `paths`: one per feature, empty if it is hidden.
std::string level_paths(const std::vector<std::string>& paths, const FeatureReads& reads, const char* kind) {
    std::array<std::string, heat_levels> levels;
    const double most = reads && !reads->empty() ? std::ranges::max(*reads) : 0;
    for (std::size_t i = 0; i < paths.size(); ++i)
        levels[reads ? heat_level((*reads)[i], most) : 0] += paths[i];
    std::string svg;
    for (std::size_t level = 0; level < heat_levels; ++level)
        svg += fmt::format("<path class=\"{} h{}\" d=\"{}\"/>", kind, reads ? std::to_string(level) : "x",
                           levels[level]);
    return svg;
}

template <class Number>
nlohmann::ordered_json rounded_list(const std::vector<Number>& numbers) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const double number : numbers) list.push_back(std::stod(fmt::format("{:.5g}", number)));
    return list;
}

nlohmann::ordered_json reads_json(const FeatureReads& reads) {
    return reads ? rounded_list(*reads) : nlohmann::ordered_json();
}

}  // namespace

std::vector<std::string> face_paths(const HeatBody& body, const std::vector<BodyPoint>& points) {
    std::vector<std::string> paths;
    for (const auto& ring : body.faces)
        paths.push_back(faces_us(ring, points) ? ring_path(ring, points) : "");
    return paths;
}

std::string body_svg(const HeatBody& body, const BodyHeat& heat) {
    const std::vector<BodyPoint> points = seen_points(body, body_yaw, body_pitch);
    const Sight sight(body, points);
    const std::vector<std::string> faces = face_paths(body, points);
    std::vector<std::string> edges, vertices;
    for (const auto& [tail, head] : body.edges)
        edges.push_back(sight.edges.contains(Sight::in_order(tail, head))
                            ? fmt::format("M{:.0f} {:.0f}L{:.0f} {:.0f}", points[tail].x, points[tail].y,
                                          points[head].x, points[head].y)
                            : "");
    for (std::size_t i = 0; i < points.size(); ++i)
        vertices.push_back(sight.vertices[i] ? fmt::format("M{:.0f} {:.0f}h0", points[i].x, points[i].y)
                                             : "");
    return fmt::format(
        "<svg id=\"body-picture\" class=\"body\" viewBox=\"0 0 {0} {0}\" role=\"img\" aria-label=\"{1}\">{2}{3}{4}"
        "</svg>",
        body_size, html_text(heat.title() + ": " + heat.sentence()), level_paths(faces, heat.faces, "face"),
        level_paths(edges, heat.edges, "edge"), level_paths(vertices, heat.vertices, "vertex"));
}

std::string bodies_data(const HeatOnBodies& heat) {
    nlohmann::ordered_json bodies = nlohmann::ordered_json::object(), heats = nlohmann::ordered_json::array();
    for (const auto& [shape, body] : heat.bodies) {
        nlohmann::ordered_json vertices = nlohmann::ordered_json::array();
        for (const auto& vertex : body.vertices)
            vertices.push_back(rounded_list(std::vector<double>(vertex.begin(), vertex.end())));
        bodies[shape] = {{"vertices", vertices}, {"edges", body.edges}, {"faces", body.faces}};
    }
    for (const BodyHeat& one : heat.heats)
        heats.push_back({{"title", one.title()},
                         {"said", one.sentence()},
                         {"shape", one.cell->shape},
                         {"scene", one.cell->scene_label},
                         {"algorithm", one.cell->algorithm},
                         {"precision", one.cell->precision},
                         {"vertices", reads_json(one.vertices)},
                         {"edges", reads_json(one.edges)},
                         {"faces", reads_json(one.faces)}});
    return input::json_text(
        nlohmann::ordered_json{{"bodies", bodies}, {"heats", heats}, {"walks", HeatJson(heat.walks)}});
}

}  // namespace edgewise::reports
