// SPDX-License-Identifier: MIT
//
// `static`: the static test of "New Metrics for Evaluation of Collision Detection Techniques" (section 2): a
// box of fixed dimensions, populated at random with bodies of varying volume up to an occupancy of 10 %;
// repeated with new populations until there are enough pairs. Pairs come from sweep and prune on world boxes,
// each is asked once and cold.
//
// Boxes are those of the bodies; with a margin they are larger, and pairs farther apart are asked too.
//
// Volumes vary over four sizes of the shape: 3/4, 1, 5/4 and 3/2 of its lengths (0.42 to 3.4 of its volume),
// in turn, so that every population fills the box equally. Bodies may overlap: about half of the pairs of
// spheres do.
#include <fmt/core.h>

#include <array>

#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::scene {
namespace {

constexpr std::array<double, 4> size_classes = {0.75, 1, 1.25, 1.5};
constexpr std::size_t most_barren = 1000;  ///< populations in a row without a pair before giving up

struct Placement {
    std::vector<Pose> poses;
    std::vector<Aabb> boxes;
};

/// margin: by which boxes are larger than bodies, on all sides.
Placement populate(const std::vector<Polyhedron>& bodies, const Vec3d& centre, std::size_t count, double half,
                   double margin, Rng& rng) {
    Placement placement;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t size = i % size_classes.size();
        const Mat3d rotation = rng.rotation();
        const Vec3d place = rng.in_cube(half);
        placement.poses.push_back(pose_at(rotation, centre * size_classes[size], place));
        placement.boxes.push_back(world_box(bodies[size], placement.poses.back()).enlarged(margin));
    }
    return placement;
}

}  // namespace

Result<Workload> make_static(const SceneSetup& setup) {
    Workload workload;
    for (const double factor : size_classes) workload.bodies.push_back(scaled(setup.shape, factor));
    const std::size_t count = setup.count("bodies");
    double total = 0;
    for (std::size_t i = 0; i < count; ++i) {
        workload.instances.push_back(static_cast<std::uint32_t>(i % size_classes.size()));
        const double factor = size_classes[i % size_classes.size()];
        total += factor * factor * factor * volume(setup.shape);
    }
    const double half = box_half(total, setup["occupancy"]);
    const Vec3d centre = vertex_mean(setup.shape.vertices);
    const double margin = setup["margin"] * extent(setup.shape.vertices);
    Rng rng(setup.seed);
    for (std::size_t barren = 0; workload.queries.size() < setup.query_count;) {
        const Placement placement = populate(workload.bodies, centre, count, half, margin, rng);
        SweepAndPrune broad_phase(count);
        const std::span<const BodyPair> pairs = broad_phase.update(placement.boxes);
        PairSlots fresh;
        ask_pairs(pairs, placement.poses, fresh, workload);
        barren = pairs.empty() ? barren + 1 : 0;
        if (barren == most_barren) {
            return Result<Workload>::failure(fmt::format(
                "scene 'static': {} populations in a row had no near pair; raise occupancy or bodies",
                most_barren));
        }
    }
    cut(setup.query_count, workload);
    return Result<Workload>::success(std::move(workload));
}

}  // namespace edgewise::scene
