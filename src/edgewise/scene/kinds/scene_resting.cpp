// SPDX-License-Identifier: MIT
//
// `resting`: bodies that rest on each other, as in recordings of engines (docs/your_engine.md). Towers of
// bodies stand next to each other on a large fixed cube. Each body lies on one of its faces nearest to its
// centre, a little off the axis of its tower: boxes lie face on face, hulls as in a heap. Bodies are copies
// of the shape at three sizes: several shapes are in use, each shared by some bodies.
//
// Of three bodies, two sink into the body below and one is a gap above it. Depths, gaps and tilts are powers
// of two, each power equally likely: contacts of engines spread over decades.
//
// Every body turns about the vertical through its centre and slides to and fro, so that faces stay parallel
// and contacts last. Its speed is the fastest, halved at random: most bodies are nearly still. Bodies of a
// sleeping tower never move, and pairs of two of them, or of one and the cube, are not asked.
// Pairs come from sweep and prune, step after step, with their caches, as in `tumble`.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::scene {
namespace {

constexpr std::array<double, 3> sizes = {1, 0.75, 1.25};  ///< of the shape's lengths, all exact
constexpr std::size_t tower_height = 5;                   ///< bodies
constexpr double steady = 1.25;  ///< a body lies on faces at most this farther than its nearest one
constexpr double off_axis = 0.1, row_spacing = 2;  ///< sizes of the shape; rows of towers hardly meet
constexpr double way_per_turn = 0.5;               ///< sizes that a body slides at most, per rad of its turn
constexpr std::size_t steps_to_and_fro = 8;        ///< after which it slides back

/// Draws 2^-n for a whole n in [least, most], each equally likely.
double halved(Rng& rng, int least, int most) {
    return std::ldexp(1, -least - static_cast<int>(rng.below(static_cast<std::uint64_t>(most - least + 1))));
}

/// Turns a unit vector straight down.
Quaternion turned_down(const Vec3d& n) {
    const double w = 1 - n.z();
    return w < 0x1p-20 ? Quaternion{0, 1, 0, 0} : normalised({w, -n.y(), n.x(), 0});
}

/// Draws an orientation in which the body rests, tilted a little.
Quaternion resting_orientation(const Polyhedron& body, Rng& rng) {
    const Vec3d centre = vertex_mean(body.vertices);
    const auto height = [&](const Plane<double>& face) { return -face.distance(centre); };
    const double least = height(*std::ranges::min_element(body.face_planes, {}, height));
    std::vector<Vec3d> down;
    for (const Plane<double>& face : body.face_planes)
        if (height(face) <= steady * least) down.push_back(face.normal);
    const Vec3d axis = rng.on_sphere();
    return rotation_about(axis, halved(rng, 10, 24)) * turned_down(down[rng.below(down.size())]);
}

class Resting {
  public:
    Resting(const SceneSetup& setup, Workload& workload)
        : setup_(setup),
          workload_(workload),
          rng_(setup.seed),
          cube_(setup.count("bodies")),
          size_(extent(setup.shape.vertices)),
          bodies_(cube_ + 1),
          rests_(cube_ + 1, true),
          broad_phase_(cube_ + 1) {
        workload.instances.resize(cube_ + 1);
        const std::size_t towers = (cube_ + tower_height - 1) / tower_height;
        const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(towers))));
        const double half = static_cast<double>(side) * row_spacing * size_ / 2;
        add_cube(half);
        for (std::size_t i = 0; i < towers; ++i) {
            if (i % side == 0) edge_ = -half;
            const bool asleep = std::floor(static_cast<double>(i + 1) * setup["asleep"]) >
                                std::floor(static_cast<double>(i) * setup["asleep"]);
            add_tower(i * tower_height, static_cast<double>(i / side) * row_spacing * size_ - half, asleep);
        }
    }

    /// Asks this step's pairs, then turns everything one step on.
    void step() {
        const Frame& frame = add_step(bodies_, setup_["margin"] * size_, workload_);
        std::vector<BodyPair> pairs;
        for (const BodyPair& pair : broad_phase_.update(frame.boxes))
            if (!rests_[pair.first] || !rests_[pair.second]) pairs.push_back(pair);
        ask_pairs(pairs, frame.poses, slots_, workload_);
        for (std::size_t i = 0; i < cube_; ++i) {
            if (rests_[i]) continue;
            advance(bodies_[i], std::numeric_limits<double>::infinity());
            if (workload_.frames.size() % steps_to_and_fro == 0) bodies_[i].velocity *= -1;
        }
    }

  private:
    /// Adds the fixed cube, its top at height 0 and larger than 2 `half` each way. It is the last instance:
    /// figures of one table are of the first.
    void add_cube(double half) {
        const Polyhedron cube = make_shape("cube8").or_throw();
        double factor = 1;
        while (factor * box_of(cube.vertices).sides().x() < 2 * half + size_) factor *= 2;
        workload_.bodies.push_back(scaled(cube, factor));
        workload_.instances[cube_] = sizes.size();
        bodies_[cube_] = {{0, 0, factor * box_of(cube.vertices).low.z()}, Vec3d::Zero(), {}, {}};
    }

    /// Adds the next tower of a row, a gap from the one before.
    void add_tower(std::size_t first, double y, bool asleep) {
        const std::size_t end = std::min(first + tower_height, cube_);
        double low = 0, high = 0;
        for (std::size_t i = first; i < end; ++i) {
            workload_.instances[i] = static_cast<std::uint32_t>(rng_.below(sizes.size()));
            const Vec3d off = rng_.in_cube(off_axis * size_);
            bodies_[i] = {{off.x(), y + off.y(), 0}, Vec3d::Zero(), {}, {}};
            bodies_[i].orientation = resting_orientation(shape_of(i), rng_);
            if (!asleep) set_in_motion(bodies_[i]);
            rests_[i] = asleep;
            const Aabb box = lay_down(i, i == first ? cube_ : i - 1);
            low = std::min(low, box.low.x());
            high = std::max(high, box.high.x());
        }
        const double shift = edge_ + halved(rng_, 4, 12) * size_ - low;
        for (std::size_t i = first; i < end; ++i) bodies_[i].centre.x() += shift;
        edge_ = shift + high;
    }

    /// Moves a body down until it is in contact with the one below. Returns its box.
    Aabb lay_down(std::size_t index, std::size_t below) {
        MovingBody& body = bodies_[index];
        const Polyhedron &shape = shape_of(index), &under = shape_of(below);
        const Pose pose_under = pose_at_rest(below);
        const auto pose = [&](double z) { return body.centre.z() = z, pose_at_rest(index); };
        const double far = world_box(under, pose_under).high.z() - world_box(shape, pose(0)).low.z() + size_;
        const bool apart = rng_.below(3) == 0;
        const double gap = halved(rng_, apart ? 10 : 7, 20) * size_;
        const double place =
            find_offset([&](double z) { return setup_.distance(under, pose_under, shape, pose(z)); },
                        apart ? gap : 0, far, gap_placement_tolerance * size_ / 4);
        return world_box(shape, pose(coarse(apart ? place : place - gap)));
    }

    [[nodiscard]] const Polyhedron& shape_of(std::size_t index) const {
        return workload_.bodies[workload_.instances[index]];
    }
    [[nodiscard]] Pose pose_at_rest(std::size_t index) const {
        return pose_of(bodies_[index], vertex_mean(shape_of(index).vertices));
    }

    /// Its speed is the slower of two draws, so that few bodies are fast.
    void set_in_motion(MovingBody& body) {
        const int most = static_cast<int>(setup_["halvings"]);
        const double one = halved(rng_, 0, most), other = halved(rng_, 0, most);
        const double angle = setup_["fastest_turn"] * std::min(one, other);
        const Vec3d way = rng_.on_sphere() * (angle * way_per_turn * size_);
        body.turn = rotation_about({0, 0, 1}, angle);
        body.velocity = {way.x(), way.y(), 0};
    }

    const SceneSetup& setup_;
    Workload& workload_;
    Rng rng_;
    std::size_t cube_;        ///< its instance
    double size_, edge_ = 0;  ///< of the shape; where the last tower of the row ends
    std::vector<MovingBody> bodies_;
    std::vector<bool> rests_;  ///< fixed, or asleep
    SweepAndPrune broad_phase_;
    PairSlots slots_;
};

}  // namespace

Result<Workload> make_resting(const SceneSetup& setup) {
    Workload workload;
    workload.warm = true;
    workload.table_each = setup.count("own_tables") == 1;
    for (const double size : sizes) workload.bodies.push_back(scaled(setup.shape, size));
    Resting scene(setup, workload);
    while (workload.queries.size() < setup.query_count) scene.step();
    cut(setup.query_count, workload);
    return Result<Workload>::success(std::move(workload));
}

}  // namespace edgewise::scene
