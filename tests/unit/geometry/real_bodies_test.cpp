// SPDX-License-Identifier: MIT
//
// Bodies from public bug reports of collision libraries, copied here: prisms written with six digits, thin
// boxes, a snub cube with twelve digits, a twelve-sided rod with its faces, and flat ones.
#include "edgewise/geometry/hull.hpp"
#include "geometry_bodies.hpp"

namespace edgewise {
namespace {

using testing::all_violations;
using testing::box_points;
using testing::Faces;
using testing::Points;

struct RealBody {
    const char* source;
    Points points;
    std::size_t vertices, edges, faces;
};

Points heptagon_prism() {
    Points points;
    const double ring[7][2] = {{1.0, 0.0},
                               {0.62349, -0.781831},
                               {-0.222521, -0.974928},
                               {-0.900969, -0.433884},
                               {-0.900969, 0.433884},
                               {-0.222521, 0.974928},
                               {0.62349, 0.781831}};
    for (const auto& corner : ring) {
        for (const double x : {0.5, -0.5}) points.push_back(Vec3d(x, corner[0], corner[1]));
    }
    return points;
}

/// All sign and cyclic arrangements of (a, a, b): a truncated cube.
Points truncated_cube() {
    const double a = 0.414213562373;
    const double b = 0.171572875254;
    Points points;
    for (int small = 0; small < 3; ++small) {
        Vec3d corner(a, a, a);
        corner[small] = b;
        for (int signs = 0; signs < 8; ++signs) {
            const Vec3d sign((signs & 1) ? -1 : 1, (signs & 2) ? -1 : 1, (signs & 4) ? -1 : 1);
            points.push_back(corner.cwiseProduct(sign));
        }
    }
    return points;
}

/// Twelve corners at each end, as a program printed them: not exactly symmetric.
Points rod() {
    const double ring[12][2] = {{0.85, 0.0},
                                {0.7361215932167728, 0.42499999999999993},
                                {0.4250000000000001, 0.7361215932167728},
                                {5.204748896376251e-17, 0.85},
                                {-0.4249999999999998, 0.7361215932167728},
                                {-0.7361215932167728, 0.42499999999999993},
                                {-0.85, 1.0409497792752501e-16},
                                {-0.736121593216773, -0.42499999999999977},
                                {-0.4250000000000004, -0.7361215932167727},
                                {-1.5614246689128752e-16, -0.85},
                                {0.4250000000000001, -0.7361215932167728},
                                {0.7361215932167726, -0.4250000000000004}};
    Points points;
    for (const double z : {5.0, -5.0}) {
        for (const auto& corner : ring) points.push_back(Vec3d(corner[0], corner[1], z));
    }
    return points;
}

Faces rod_faces() {
    Faces faces(2);
    for (Index k = 0; k < 12; ++k) {
        const Index next = (k + 1) % 12;
        faces.push_back({12 + k, 12 + next, next, k});
        faces[0].push_back(k);
        faces[1].insert(faces[1].begin(), 12 + k);
    }
    return faces;
}

TEST(RealBodies, AreSound) {
    const Points hexahedron = {Vec3d(1.9408982677575293, 1.7555630101186028, 0.18558370457138618),
                               Vec3d(0.8325772811802072, 0.07348739881751665, 1.7363835855830982),
                               Vec3d(0.4647979626331866, 0.7802364656205514, 0.7683352436509485),
                               Vec3d(1.8147849498111688, 0.1710650007346617, 1.802196858095821),
                               Vec3d(0.05742372721610556, 1.6599005060005285, 0.014474511746654706),
                               Vec3d(1.5270861966500002, 0.4945624540164677, 0.7162419894551117)};
    const Points away = {Vec3d(14.835101, 13.06041, -0.5),  Vec3d(13.785037, 12.890524, -0.5),
                         Vec3d(14.767995, 13.150248, -0.5), Vec3d(14.835101, 13.06041, 0.5),
                         Vec3d(14.767995, 13.150248, 0.5),  Vec3d(13.785037, 12.890524, 0.5)};
    const std::vector<RealBody> bodies = {
        {"drake 21673, seven-sided prism", heptagon_prism(), 14, 21, 9},
        {"drake 21673, triangular prism", away, 6, 9, 5},
        {"openGJK 54, truncated cube", truncated_cube(), 24, 36, 14},
        {"V-Clip test list, rod", rod(), 24, 36, 14},
        {"distance3d 27, six random points", hexahedron, 6, 12, 8},
        {"MuJoCo, thin box", box_points(Vec3d(0.047, 0.032, 0.00035)), 8, 12, 6},
        {"FCL 293, thin box", box_points(Vec3d(1.375, 3, 0.025)), 8, 12, 6},
        {"python-fcl 28, long box", box_points(Vec3d(10, 2.5, 500)), 8, 12, 6},
    };
    for (const RealBody& real : bodies) {
        const Result<Polyhedron> hull = convex_hull(real.points);
        ASSERT_TRUE(hull) << real.source << ": " << hull.error;
        EXPECT_EQ(all_violations(*hull), "") << real.source;
        EXPECT_EQ(hull->vertex_count(), real.vertices) << real.source;
        EXPECT_EQ(hull->edge_count(), real.edges) << real.source;
        EXPECT_EQ(hull->face_count(), real.faces) << real.source;
    }
}

TEST(RealBodies, RodWithItsOwnFaces) {
    const Result<Polyhedron> given = polyhedron_from_faces(rod(), rod_faces());
    ASSERT_TRUE(given) << given.error;
    const Result<Polyhedron> hull = convex_hull(rod());
    ASSERT_TRUE(hull);
    EXPECT_EQ(given->face_ring, hull->face_ring);
    EXPECT_EQ(given->vertex_ring, hull->vertex_ring);
}

TEST(RealBodies, FlatOnesSaySo) {
    const std::vector<Points> flats = {
        {Vec3d(14.831459045410156, 8.190550804138184, -4.308250427246094)},
        {Vec3d(14.553621292114258, 10.597372055053711, -0.006000518798828125),
         Vec3d(14.553621292114258, 10.596931457519531, -3.1863813400268555),
         Vec3d(14.553621292114258, 10.596931457519531, -5.18637228012085)},
        {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 1, 0), Vec3d(0, 1, 0)},
    };
    for (const Points& points : flats) {
        const Result<Polyhedron> hull = convex_hull(points);
        EXPECT_FALSE(hull);
        EXPECT_EQ(hull.error.rfind("flat", 0), 0u) << hull.error;
    }
}

}  // namespace
}  // namespace edgewise
