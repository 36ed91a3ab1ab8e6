// SPDX-License-Identifier: MIT
//
// The list of scenes, and the checks that every request passes before a scene sees it.
#include "edgewise/scene/scenes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "edgewise/input/known_names.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/scene_file.hpp"

namespace edgewise::scene {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ParameterInfo, name, unit, meaning, standard, low, high, whole)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SceneInfo, name, meaning, warm, places_pairs, parameters)

namespace {

const std::map<std::string_view, MakeScene*> makers = {
    {"static", make_static},   {"cold", make_cold},           {"gap", make_gap},
    {"tumble", make_tumble},   {"proximity", make_proximity}, {"pressure", make_pressure},
    {"resting", make_resting}, {"recorded", make_recorded}};

const SceneInfo* find_scene(std::string_view name) {
    const auto found = std::ranges::find(list_scenes(), name, &SceneInfo::name);
    return found == list_scenes().end() ? nullptr : &*found;
}

template <class Infos>
std::vector<std::string> names_of(const Infos& infos) {
    std::vector<std::string> names;
    for (const auto& info : infos) names.emplace_back(info.name);
    return names;
}

/// Returns an empty text, or says what is wrong with the value.
std::string check_value(std::string_view scene, const ParameterInfo& info, double value) {
    if (!(value >= info.low && value <= info.high)) {
        return fmt::format("scene '{}': {} = {} is out of bounds; choose {} to {} ({})", scene, info.name,
                           value, info.low, info.high, info.unit);
    }
    if (info.whole && value != std::floor(value)) {
        return fmt::format("scene '{}': {} = {} must be a whole number", scene, info.name, value);
    }
    return {};
}

std::string unknown_scene(std::string_view scene) {
    std::vector<std::string> known = names_of(list_scenes());
    for (const std::string& file : names_of(scene_texts())) known.push_back(file);
    return unknown_name("scene", scene, known) + ", or the path of a file that ends in .json";
}

}  // namespace

const std::vector<SceneInfo>& list_scenes() {
    static const auto all = nlohmann::json::parse(kind_texts).get<std::vector<SceneInfo>>();
    return all;
}

Result<SceneParameters> complete_parameters(std::string_view scene, const SceneParameters& given) {
    using Failure = Result<SceneParameters>;
    const SceneInfo* info = find_scene(scene);
    if (!info) return Failure::failure(unknown_scene(scene));
    SceneParameters complete;
    for (const ParameterInfo& parameter : info->parameters) complete[parameter.name] = parameter.standard;
    for (const auto& [name, value] : given) {
        const auto known = std::ranges::find(info->parameters, name, &ParameterInfo::name);
        if (known == info->parameters.end()) {
            return Failure::failure(fmt::format("scene '{}': {}", scene,
                                                unknown_name("parameter", name, names_of(info->parameters))));
        }
        const std::string wrong = check_value(scene, *known, value);
        if (!wrong.empty()) return Failure::failure(wrong);
        complete[name] = value;
    }
    return Failure::success(std::move(complete));
}

Result<Workload> make_scene(std::string_view scene, const Polyhedron& shape, const SceneParameters& given,
                            std::uint64_t seed, std::size_t query_count, const DistanceFunction& distance) {
    using Failure = Result<Workload>;
    const Result<SceneParameters> parameters = complete_parameters(scene, given);
    if (!parameters) return Failure::failure(parameters.error);
    if (query_count == 0) {
        return Failure::failure(fmt::format("scene '{}': no queries asked for; ask for at least one", scene));
    }
    if (shape.vertices.empty() || !(volume(shape) > 0)) {
        return Failure::failure(
            fmt::format("scene '{}': the shape encloses no volume; scenes need solids", scene));
    }
    if (find_scene(scene)->places_pairs && !distance) {
        return Failure::failure(
            fmt::format("scene '{}' places pairs by their distance: give it a distance function", scene));
    }
    return makers.at(scene)({shape, *parameters, seed, query_count, distance});
}

// Parts that several scenes share.

Frame& add_step(std::span<const MovingBody> bodies, double margin, Workload& workload) {
    Frame& frame =
        workload.frames.emplace_back(Frame{workload.queries.size(), workload.frames.empty(), {}, {}, margin});
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Polyhedron& shape = workload.bodies[workload.instances[i]];
        frame.poses.push_back(pose_of(bodies[i], vertex_mean(shape.vertices)));
        frame.boxes.push_back(world_box(shape, frame.poses.back()).enlarged(margin));
    }
    return frame;
}

void ask_pairs(std::span<const BodyPair> pairs, std::span<const Pose> poses, PairSlots& slots,
               Workload& workload) {
    PairSlots now;
    for (const BodyPair& pair : pairs) {
        const auto known = slots.find(pair);
        const std::uint32_t slot = known != slots.end() ? known->second : workload.pair_count++;
        now[pair] = slot;
        workload.queries.push_back({workload.instances[pair.first], workload.instances[pair.second], slot,
                                    poses[pair.first], poses[pair.second], pair.first, pair.second});
    }
    slots = std::move(now);
}

void cut(std::size_t query_count, Workload& workload) {
    workload.queries.resize(query_count);
    std::erase_if(workload.frames, [&](const Frame& frame) { return frame.first_query >= query_count; });
    workload.pair_count = 0;
    for (const Query& query : workload.queries)
        workload.pair_count = std::max(workload.pair_count, query.pair + 1);
}

Vec3d vertex_mean(std::span<const Vec3d> vertices) {
    assert(!vertices.empty());
    Vec3d sum = Vec3d::Zero();
    for (const Vec3d& vertex : vertices) sum += vertex;
    return sum / static_cast<double>(vertices.size());
}

double reach(std::span<const Vec3d> vertices, const Vec3d& from) {
    double most = 0;
    for (const Vec3d& vertex : vertices) most = std::max(most, norm(Vec3d(vertex - from)));
    return most;
}

Aabb world_box(const Polyhedron& body, const Pose& pose) {
    const Vec3d first = pose.apply(body.vertices.front());
    Aabb box{first, first};
    for (const Vec3d& vertex : body.vertices) box.include(pose.apply(vertex));
    return box;
}

double coarse(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);  // exact, as are floor and ldexp
    return std::ldexp(std::floor(mantissa * 0x1p24 + 0.5), exponent - 24);
}

double cube_root(double x) {
    assert(x > 0);
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    const int thirds = exponent >= 0 ? (exponent + 2) / 3 : exponent / 3;
    const double value = std::ldexp(mantissa, exponent - 3 * thirds);  // in [1/8, 1)
    double root = 1;
    for (int i = 0; i < 8; ++i) root = (2 * root + value / (root * root)) / 3;  // from 1: converged by six
    return std::ldexp(root, thirds);
}

double box_half(double total_volume, double occupancy) {
    return coarse(cube_root(total_volume / occupancy)) / 2;
}

}  // namespace edgewise::scene
