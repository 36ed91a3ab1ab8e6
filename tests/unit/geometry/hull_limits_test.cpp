// SPDX-License-Identifier: MIT
//
// What has no hull says so in one line that names the cause; what is just inside the limits works.
#include "edgewise/geometry/hull.hpp"

#include <limits>

#include "geometry_bodies.hpp"

namespace edgewise {
namespace {

using testing::all_violations;
using testing::box_points;
using testing::Dice;
using testing::grid_points;
using testing::placed;
using testing::Points;
using testing::random_rotation;

struct RefusedCase {
    const char* name;
    Points points;
    const char* expected;
};

TEST(Hull, RefusesWhatHasNoSolidHull) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    Points not_a_number = box_points(Vec3d(1, 1, 1));
    not_a_number[5].y() = nan;
    Points infinite = box_points(Vec3d(1, 1, 1));
    infinite[2].z() = -inf;
    Points too_large = box_points(Vec3d(1, 1, 1));
    too_large[7].x() = 2e60;
    Dice dice(16);
    const Points tilted = placed(grid_points(3, Vec3d(1, 1, 0)), random_rotation(dice), Vec3d(1, 2, 3), 1);
    const Points line = placed(grid_points(4, Vec3d(1, 0, 0)), random_rotation(dice), Vec3d(1, 2, 3), 1);
    const std::vector<RefusedCase> cases = {
        {"none", {}, "no vertices"},
        {"point", {Vec3d(1, 2, 3)}, "single point"},
        {"duplicates", Points(5, Vec3d(1, 2, 3)), "all 5 vertices are the same point"},
        {"segment", {Vec3d(0, 0, 0), Vec3d(1, 0, 0)}, "2 distinct vertices"},
        {"triangle", {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 1, 0)}, "3 distinct vertices"},
        {"line", line, "on one line"},
        {"plane", tilted, "in one plane"},
        {"square", box_points(Vec3d(1, 1, 0)), "in one plane"},
        {"paper", box_points(Vec3d(1, 1, 1e-14)), "in one plane"},
        {"not a number", not_a_number, "vertex 5: y = nan"},
        {"infinite", infinite, "vertex 2: z = -inf"},
        {"too large", too_large, "vertex 7: x = 2e+60 is beyond 1e+60"},
        {"too small", box_points(Vec3d(1e-61, 1e-61, 1e-61)), "below 1e-60"},
    };
    for (const RefusedCase& refused : cases) {
        const Result<Polyhedron> hull = convex_hull(refused.points);
        EXPECT_FALSE(hull) << refused.name;
        EXPECT_NE(hull.error.find(refused.expected), std::string::npos) << refused.name << ": " << hull.error;
        EXPECT_EQ(hull.error.find('\n'), std::string::npos) << refused.name;
    }
}

TEST(Hull, WorksUpToTheEdgesOfItsRange) {
    for (const double size : {1e-59, 1e-30, 1e30, 0.9e60}) {
        const Result<Polyhedron> cube = convex_hull(box_points(Vec3d(size, size, size)));
        ASSERT_TRUE(cube) << size << ": " << cube.error;
        EXPECT_EQ(cube->face_count(), 6u);
        EXPECT_EQ(all_violations(*cube), "");
    }
}

}  // namespace
}  // namespace edgewise
