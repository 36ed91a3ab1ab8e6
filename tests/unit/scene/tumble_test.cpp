// SPDX-License-Identifier: MIT
//
// What `tumble` varies for the paper's tests: random turns, random velocities, ways in smallest dimensions, a
// box of fixed size, tables of one's own.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::scene {
namespace {

Workload tumble(SceneParameters given, std::size_t queries = 2000) {
    given["in_time_order"] = 1;
    auto workload = make_scene("tumble", *make_shape("cube8"), given, 1, queries, {});
    EXPECT_TRUE(workload) << workload.error;
    return std::move(*workload);
}

/// Of each body from step to step within a population.
template <class Use>
void each_move(const Workload& w, Use use) {
    for (std::size_t i = 1; i < w.frames.size(); ++i) {
        if (w.frames[i].starts_anew) continue;
        for (std::size_t body = 0; body < w.frames[i].poses.size(); ++body)
            use(w.frames[i - 1].poses[body], w.frames[i].poses[body], body);
    }
}

double turned_by(const Pose& before, const Pose& after) {
    const Mat3d turn = after.rotation * before.rotation.transpose();
    return std::acos(std::clamp((turn.trace() - 1) / 2, -1.0, 1.0));
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
    EXPECT_EQ(smallest_dimension(make_shape("cube8")->vertices), 1.125);
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

/// Frames tell the poses whose boxes they hold.
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

}  // namespace
}  // namespace edgewise::scene
