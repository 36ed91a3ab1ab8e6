// SPDX-License-Identifier: MIT
//
// What `tumble` varies for the paper's tests: random turns, random velocities, ways in smallest dimensions, a
// box of fixed size, tables of one's own.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "made_scene.hpp"

namespace edgewise::scene {
namespace {

Workload tumble(SceneParameters given, std::size_t queries = 2000) {
    given["in_time_order"] = 1;
    return made_scene("tumble", *make_shape("cube8"), queries, given);
}

/// Calls `use` with each body's poses before and after each step within a population.
template <class Use>
void each_move(const Workload& w, Use use) {
    for (std::size_t i = 1; i < w.frames.size(); ++i) {
        if (w.frames[i].starts_anew) continue;
        for (std::size_t body = 0; body < w.frames[i].poses.size(); ++body)
            use(w.frames[i - 1].poses[body], w.frames[i].poses[body], body);
    }
}

double turned_by(const Pose& before, const Pose& after) {
    return angle_between(before.rotation, after.rotation);
}

TEST(Tumble, AtRandomOrientationIsIncoherent) {
    double sum = 0;
    std::size_t count = 0;
    each_move(tumble({{"random_orientation", 1}, {"rotation_step", 0}}),
              [&](const Pose& before, const Pose& after, std::size_t) {
                  sum += turned_by(before, after);
                  ++count;
              });
    const double mean = sum / static_cast<double>(count);
    std::printf("mean turn of %zu random steps: %.3f rad\n", count, mean);
    EXPECT_NEAR(mean, M_PI / 2 + 2 / M_PI, 0.05) << "of rotations drawn uniformly";
}

TEST(Tumble, DrawsVelocitiesUpToThoseGiven) {
    double least = 10, most = 0;
    each_move(tumble({{"random_velocities", 1}, {"rotation_step", 0.5}, {"bodies", 60}}),
              [&](const Pose& before, const Pose& after, std::size_t) {
                  least = std::min(least, turned_by(before, after));
                  most = std::max(most, turned_by(before, after));
              });
    EXPECT_LT(least, 0.05);
    EXPECT_GT(most, 0.45);
    EXPECT_LT(most, 0.5 + 1e-9);
}

TEST(Tumble, StepsInSmallestDimensions) {
    EXPECT_EQ(box_of(make_shape("cube8")->vertices).sides().minCoeff(), 1.125);
    double most = 0;
    each_move(tumble({{"step_in_dimensions", 0.2}, {"rotation_step", 0}}),
              [&](const Pose& before, const Pose& after, std::size_t) {
                  most = std::max(most, norm(Vec3d(after.translation - before.translation)));
              });
    EXPECT_NEAR(most, 0.2 * 1.125, 1e-12) << "shorter only where a wall throws a body back";
}

/// Eight times the bodies in the same box: half as long, at the same way a step in metres.
TEST(Tumble, ShrinksBodiesInABoxOfFixedSize) {
    const SceneParameters fixed = {{"box_of_bodies", 10}, {"rotation_step", 0}};
    SceneParameters many = fixed;
    many["bodies"] = 80;
    many["box_of_bodies"] = 10;
    const Workload w = tumble(many);
    const double scale = extent(w.bodies[0].vertices) / extent(make_shape("cube8")->vertices);
    EXPECT_NEAR(scale, 0.5, 1e-6);
    const double half = box_half(10 * volume(*make_shape("cube8")), 0.1);
    double farthest = 0;
    for (const Frame& frame : w.frames) {
        for (const Pose& pose : frame.poses) farthest = std::max(farthest, max_abs(pose.translation));
    }
    EXPECT_LE(farthest, half * (1 + 1e-6));
    EXPECT_GT(farthest, 0.9 * half);
    double way = 0;
    each_move(w, [&](const Pose& before, const Pose& after, std::size_t) {
        way = std::max(way, norm(Vec3d(after.translation - before.translation)));
    });
    EXPECT_NEAR(way, 0.001 * extent(make_shape("cube8")->vertices), 1e-12);
}

/// Frames hold poses, and the boxes of the bodies at these poses.
TEST(Tumble, FramesHoldPosesAndTheirBoxes) {
    const Workload w = tumble({{"own_tables", 1}, {"margin", 0.1}});
    EXPECT_TRUE(w.table_each);
    for (const Frame& frame : w.frames) {
        ASSERT_EQ(frame.poses.size(), frame.boxes.size());
        for (std::size_t i = 0; i < frame.boxes.size(); ++i) {
            const Aabb box = world_box(w.bodies[0], frame.poses[i]).enlarged(frame.margin);
            ASSERT_EQ(box.low, frame.boxes[i].low);
            ASSERT_EQ(box.high, frame.boxes[i].high);
        }
    }
}

/// The smallest turn between any two orientations that a body has in one population.
double nearest_return(const SceneParameters& parameters) {
    const Workload w = tumble(parameters, 1);
    double least = 10;
    for (std::size_t i = 0; i < w.frames.size(); ++i) {
        for (std::size_t j = i + 1; j < w.frames.size() && !w.frames[j].starts_anew; ++j) {
            for (std::size_t body = 0; body < w.frames[i].poses.size(); ++body)
                least = std::min(least, turned_by(w.frames[i].poses[body], w.frames[j].poses[body]));
        }
    }
    return least;
}

/// A turn by 3/4 pi comes back after eight steps. None of the paper's scenes that turn by more than 1 rad per
/// step comes back within a population, all its hundred steps.
TEST(Tumble, ComesBackToNoOrientationInThePapersScenes) {
    const SceneParameters returning = {{"rotation_step", 2.3561945}, {"least_steps", 100}, {"bodies", 8}};
    EXPECT_LT(nearest_return(returning), 1e-5);
    SceneParameters precessing = returning;
    precessing["precession"] = 0.236068;
    EXPECT_GT(nearest_return(precessing), 1e-3);
    std::size_t fast = 0;
    for (const char* name : {"paper_angular_8", "paper_thrash_38"}) {
        const auto file = find_scene_file(name);
        ASSERT_TRUE(file && *file);
        for (const ScenePoint& point : (*file)->points) {
            if (point.parameters.at("rotation_step") <= 1) continue;
            SceneParameters parameters = point.parameters;
            parameters["bodies"] = 8;
            parameters["least_steps"] = 100;
            EXPECT_GT(nearest_return(parameters), 1e-3) << name << " " << parameters["rotation_step"];
            ++fast;
        }
    }
    EXPECT_EQ(fast, 8U);
}

/// The axis turns, the angle of a step stays.
TEST(Tumble, PrecessesAtTheSameAngle) {
    const auto axis_of = [](const Pose& before, const Pose& after) {
        const Mat3d turn = after.rotation * before.rotation.transpose();
        return Vec3d(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
    };
    const Workload w = tumble({{"rotation_step", 0.5}, {"precession", 0.2}, {"bodies", 6}});
    double most = 0;
    for (std::size_t i = 2; i < w.frames.size(); ++i) {
        if (w.frames[i].starts_anew || w.frames[i - 1].starts_anew) continue;
        for (std::size_t body = 0; body < 6; ++body) {
            const Pose &a = w.frames[i - 2].poses[body], &b = w.frames[i - 1].poses[body],
                       &c = w.frames[i].poses[body];
            EXPECT_NEAR(turned_by(b, c), 0.5, 1e-6);
            const Vec3d before = axis_of(a, b), after = axis_of(b, c);
            most = std::max(
                most, std::acos(std::clamp(dot(before, after) / norm(before) / norm(after), -1.0, 1.0)));
        }
    }
    EXPECT_GT(most, 0.05);
    EXPECT_LE(most, 0.2 * 0.5 + 1e-6) << "less where the axes are near each other";
}

/// The scene has at least the steps asked for, whole ones, with the same queries as a longer scene.
TEST(Tumble, TakesTheLeastSteps) {
    const Workload w = tumble({{"bodies", 20}, {"least_steps", 120}}, 10),
                   longer = tumble({{"bodies", 20}, {"least_steps", 2}}, 20000);
    EXPECT_EQ(w.frames.size(), 120U);
    EXPECT_GT(w.queries.size(), w.frames.back().first_query) << "the last step is whole";
    ASSERT_GT(longer.frames.size(), 120U);
    EXPECT_EQ(w.queries.size(), longer.frames[120].first_query);
    EXPECT_EQ(longer.queries.size(), 20000U);
    std::uint32_t pairs = 0;
    for (const Query& query : w.queries) pairs = std::max(pairs, query.pair + 1);
    EXPECT_EQ(w.pair_count, pairs);
}

Workload pressure(std::size_t bodies, std::size_t queries) {
    return made_scene("pressure", *make_shape("sphere38"), queries, {{"bodies", double(bodies)}});
}

TEST(Pressure, AsksEveryPairOfNeighboursOnceAStep) {
    const std::size_t bodies = 30;
    const Workload w = pressure(bodies, 3 * (bodies - 1));
    EXPECT_TRUE(w.warm && w.table_each);
    EXPECT_EQ(w.instances.size(), bodies);
    EXPECT_EQ(w.pair_count, bodies - 1);
    for (std::size_t step = 0; step < 3; ++step) {
        std::set<std::uint32_t> pairs;
        for (std::size_t i = 0; i < bodies - 1; ++i) {
            const Query& q = w.queries[step * (bodies - 1) + i];
            EXPECT_TRUE(pairs.insert(q.pair).second);
            EXPECT_EQ(q.instance_b, q.instance_a + 1);
            EXPECT_EQ(q.instance_a, q.pair);
        }
    }
    EXPECT_NE(w.queries[0].pair + 1, w.queries[1].pair) << "an order that memory does not know";
    EXPECT_EQ(w.queries[0].pair, w.queries[bodies - 1].pair) << "the same order every step";
}

/// On the lattice all neighbours are equally far apart, and whatever way they turn they do not meet.
TEST(Pressure, PairsAreNearAndApart) {
    const Workload w = pressure(70, 138);
    double least = 1e9, most = 0;
    const double spacing = norm(Vec3d(w.queries[0].pose_a.translation - w.queries[0].pose_b.translation));
    for (const Query& q : w.queries) {
        const double d = distance_of(w, q);
        least = std::min(least, d);
        most = std::max(most, d);
        EXPECT_NEAR(norm(Vec3d(q.pose_a.translation - q.pose_b.translation)), spacing, 0.1);
    }
    EXPECT_GT(least, 0);
    EXPECT_LT(most, 0.5);
}

TEST(Pressure, TakesTheLeastSteps) {
    const Workload w = made_scene("pressure", *make_shape("cube8"), 7, {{"bodies", 30}, {"least_steps", 5}});
    EXPECT_EQ(w.frames.size(), 5U);
    EXPECT_EQ(w.queries.size(), 5 * 29U);
}

}  // namespace

}  // namespace edgewise::scene
