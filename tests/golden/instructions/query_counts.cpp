// SPDX-License-Identifier: MIT
//
// Runs under Callgrind: asks each table type the same queries and dumps their counts, one dump per row, named
// "ALGORITHM TABLE SCENE BODY QUERIES". Callgrind counts while queries run and nothing else.
#include <valgrind/callgrind.h>

#include <string>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/points_soa.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/sphere_points.hpp"

namespace edgewise {
namespace {

constexpr std::size_t queries = 100;
volatile double sink;

using Poses = std::vector<Transform<double>>;

/// Poses of a body relative to another body of the same shape. A followed pair is asked at each pose in turn,
/// 0.01 rad apart.
struct Scene {
    std::string name;
    bool followed = false;
    Poses poses = {};
};

template <class Algorithm, class Table>
using PairOf = typename Algorithm::template Pair<Table, Table>;

Scene cold_scene() {
    scene::Rng rng(20010168);
    Scene scene{"cold"};
    for (std::size_t i = 0; i < queries; ++i) {
        const Mat3d rotation = rng.rotation();
        scene.poses.push_back({rotation, 2.5 * rng.on_sphere()});
    }
    return scene;
}

/// Has one pose more than it counts: the first query starts cold.
Scene followed_scene(const std::string& name) {
    scene::Rng rng(20010168);
    const Vec3d axis = rng.on_sphere();
    const scene::Quaternion step =
        scene::normalised({1, 0.005 * axis.x(), 0.005 * axis.y(), 0.005 * axis.z()});
    scene::Quaternion orientation = rng.orientation();
    Scene scene{name, true};
    for (std::size_t i = 0; i <= queries; ++i) {
        scene.poses.push_back({scene::rotation_matrix(orientation), {2.3, 0.1, 0.3}});
        orientation = scene::normalised(step * orientation);
    }
    return scene;
}

/// The followed scene with a gap of 0.001 between the bodies.
Scene near_scene(const Polyhedron& body) {
    Scene scene = followed_scene("near");
    const aos<f64> table(body, Parts::features);
    for (Transform<double>& pose : scene.poses) {
        PairOf<VClip, aos<f64>> pair(table, table);
        const Distance apart = VClip::query(table, table, pose, pair);
        pose.translation -= (apart.distance - 1e-3) * apart.normal;
    }
    return scene;
}

/// Asks the counted poses of a scene in which pairs are followed.
template <class Algorithm, class Table>
void ask_followed(const Table& table, const Poses& poses, PairOf<Algorithm, Table>& pair) {
    double sum = 0;
    for (std::size_t i = 1; i < poses.size(); ++i)
        sum += Algorithm::query(table, table, poses[i], pair).distance;
    sink = sum;
}

template <class Algorithm, class Table>
void ask_cold(const Table& table, const Poses& poses) {
    double sum = 0;
    for (const Transform<double>& pose : poses) {
        PairOf<Algorithm, Table> pair(table, table);
        sum += Algorithm::query(table, table, pose, pair).distance;
    }
    sink = sum;
}

template <class Algorithm, class Table>
void count(const std::string& cell, const Scene& scene, const std::string& shape, const Table& table) {
    PairOf<Algorithm, Table> pair(table, table);
    if (scene.followed) sink = Algorithm::query(table, table, scene.poses[0], pair).distance;
    CALLGRIND_START_INSTRUMENTATION;
    if (scene.followed)
        ask_followed<Algorithm>(table, scene.poses, pair);
    else
        ask_cold<Algorithm>(table, scene.poses);
    CALLGRIND_STOP_INSTRUMENTATION;
    const std::string name = cell + " " + scene.name + " " + shape + " " + std::to_string(queries);
    CALLGRIND_DUMP_STATS_AT(name.c_str());
}

void count_all(const std::string& shape, const std::vector<Vec3d>& points) {
    const Polyhedron body = convex_hull(points).or_throw();
    const aos<f64> plain(body, Parts::features);
    const lean<f64> lean_table(body, Parts::features);
    const points_soa<f32> points_table(round_to_single(body).or_throw(), Parts::support);
    for (const Scene& scene : {cold_scene(), followed_scene("warm"), near_scene(body)}) {
        count<VClip>("vclip aos_f64", scene, shape, plain);
        count<VClip>("vclip lean_f64", scene, shape, lean_table);
        count<Gjk>("gjk aos_f64", scene, shape, plain);
        count<Gjk>("gjk lean_f64", scene, shape, lean_table);
        count<Gjk>("gjk points_soa_f32", scene, shape, points_table);
    }
}

}  // namespace
}  // namespace edgewise

int main() {
    using namespace edgewise;
    std::vector<Vec3d> cube;
    for (int i = 0; i < 8; ++i) cube.emplace_back(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    count_all("cube8", cube);
    count_all("sphere38", scene::sphere_points({scene::SphereFamily::octahedral, 3}));
    count_all("sphere386", scene::sphere_points({scene::SphereFamily::cubic, 8}));
    return 0;
}
