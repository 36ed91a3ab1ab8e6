// SPDX-License-Identifier: MIT
//
// `tumble`: coherent motion. Copies of one body drift and turn in a box (motion.hpp), all of them
// in every step. Sweep and prune follows the pairs with overlapping boxes, enlarged by a margin. Rotation and
// translation per step set the coherence: 0.01 rad is a smooth simulation, 2 pi and half a body size is none.
//
// One slot of the pair cache is one uninterrupted stay of a pair in the broad phase, so a warm start is never
// older than one step; a pair that leaves and returns gets a new slot and starts cold. After `steps` steps
// a new population begins, so that a run sees many arrangements. The margin is chosen so that most followed
// pairs are separated: of spheres about one in six overlaps.
//
// A turn of every body about one axis repeats its orientations where it is a rational multiple of pi (after
// eight steps at 3/4 of it), and then only few orientations are measured. With a precession each body's axis
// turns too, about another axis, by that part of the body's own turn.
//
// At random_orientation a body has a new random orientation in every step: no coherence is left in the
// rotation. A turn by 2 pi per step would not show this, since it is no turn. At random_velocities turns and
// ways are drawn for each body, up to those given. With box_of_bodies the box is that of this many bodies,
// and bodies shrink until the occupancy is right; ways per step stay as long as they were, in metres.
//
// Queries come pair after pair, each pair's in time order, so that a pair finds its tables where it left
// them, and classes of answers come in long stretches to be timed; or, with in_time_order, frame after frame
// as an engine asks them, where the other pairs of a frame come between.
#include <fmt/core.h>

#include <algorithm>

#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::scene {
namespace {

constexpr std::size_t most_barren = 100000;  ///< steps in a row without a pair before giving up

/// One population and the slots of the pairs that are near one another now.
class Population {
  public:
    Population(const SceneSetup& setup, const Polyhedron& shape, double half, Rng& rng)
        : setup_(setup), half_(half), rng_(rng), broad_phase_(setup.count("bodies")) {
        margin_ = setup["margin"] * extent(shape.vertices);
        const bool random = setup.count("random_velocities") == 1;
        for (std::size_t i = 0; i < setup.count("bodies"); ++i) {
            MovingBody body;
            body.centre = rng.in_cube(half);
            body.velocity = rng.on_sphere() * (way_of_a_step() * (random ? rng.uniform() : 1));
            body.orientation = rng.orientation();
            const Vec3d axis = rng.on_sphere();
            const double angle = setup["rotation_step"] * (random ? rng.uniform() : 1);
            body.turn = rotation_about(axis, angle);
            if (setup["precession"] > 0)
                body.axis_turn = rotation_about(rng.on_sphere(), setup["precession"] * angle);
            bodies_.push_back(body);
        }
    }

    /// Asks this step's pairs, then moves everything one step on. Returns how many pairs there were.
    std::size_t step(Workload& workload) {
        Frame& frame = add_step(bodies_, margin_, workload);
        frame.starts_anew = !begun_;
        begun_ = true;
        ask_pairs(broad_phase_.update(frame.boxes), frame.poses, slots_, workload);
        for (MovingBody& body : bodies_) {
            advance(body, half_);
            if (setup_.count("random_orientation") == 1) body.orientation = rng_.orientation();
        }
        return slots_.size();
    }

  private:
    /// Way of one step in metres, for the body as given, whatever its scale.
    [[nodiscard]] double way_of_a_step() const {
        const double of_dimension = setup_["step_in_dimensions"];
        return of_dimension > 0 ? of_dimension * box_of(setup_.shape.vertices).sides().minCoeff()
                                : setup_["translation_step"] * extent(setup_.shape.vertices);
    }

    const SceneSetup& setup_;
    double half_, margin_;
    Rng& rng_;
    std::vector<MovingBody> bodies_;
    SweepAndPrune broad_phase_;
    PairSlots slots_;
    bool begun_ = false;
};

/// Returns true if the workload has the requested number of queries and of steps.
bool is_enough(const SceneSetup& setup, const Workload& workload) {
    return workload.queries.size() >= setup.query_count &&
           workload.frames.size() >= setup.count("least_steps");
}

/// The requested number of queries, or more if the first `least_steps` steps have more.
std::size_t queries_wanted(const SceneSetup& setup, const Workload& workload) {
    const std::size_t steps = setup.count("least_steps");
    const std::size_t end =
        steps < workload.frames.size() ? workload.frames[steps].first_query : workload.queries.size();
    return steps == 0 ? setup.query_count : std::max(setup.query_count, end);
}

}  // namespace

Result<Workload> make_tumble(const SceneSetup& setup) {
    Workload workload;
    workload.warm = true;
    workload.table_each = setup.count("own_tables") == 1;
    const double box = setup["box_of_bodies"];
    const double scale = box == 0 ? 1 : coarse(cube_root(box / setup["bodies"]));  // of their lengths
    workload.bodies.push_back(scale == 1 ? setup.shape : scaled(setup.shape, scale));
    const Polyhedron shape = workload.bodies.front();
    workload.instances.assign(setup.count("bodies"), 0);
    const double total = static_cast<double>(setup.count("bodies")) * volume(shape);
    const double half = box_half(total, setup["occupancy"]);
    Rng rng(setup.seed + setup.count("population"));
    for (std::size_t barren = 0; !is_enough(setup, workload);) {
        Population population(setup, shape, half, rng);
        for (std::size_t i = 0; i < setup.count("steps") && !is_enough(setup, workload); ++i) {
            barren = population.step(workload) == 0 ? barren + 1 : 0;
            if (barren == most_barren) {
                return Result<Workload>::failure(
                    fmt::format("scene 'tumble': no near pair in {} steps; raise occupancy, margin or bodies",
                                most_barren));
            }
        }
    }
    cut(queries_wanted(setup, workload), workload);
    if (setup.count("in_time_order") == 0) {  // pair after pair
        workload.frames.clear();
        std::ranges::stable_sort(workload.queries, {}, &Query::pair);
    }
    return Result<Workload>::success(std::move(workload));
}

}  // namespace edgewise::scene
