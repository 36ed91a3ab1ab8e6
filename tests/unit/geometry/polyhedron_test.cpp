// SPDX-License-Identifier: MIT
//
// The canonical order, bodies with given faces, and what is refused there.
#include "edgewise/geometry/polyhedron.hpp"

#include <algorithm>
#include <cstdio>

#include "edgewise/geometry/polyhedron_builder.hpp"
#include "geometry_bodies.hpp"

namespace edgewise {
namespace {

using testing::all_violations;
using testing::box_faces;
using testing::box_points;
using testing::Dice;
using testing::Faces;
using testing::placed;
using testing::Points;
using testing::random_rotation;
using testing::sphere_points;

const Points cube_points = box_points(Vec3d(1, 1, 1));

Faces triangulated_box_faces() {
    Faces faces;
    for (const std::vector<Index>& quad : box_faces()) {
        faces.push_back({quad[0], quad[1], quad[2]});
        faces.push_back({quad[0], quad[2], quad[3]});
    }
    return faces;
}

void expect_same_bits(const Polyhedron& a, const Polyhedron& b) {
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.input_index, b.input_index);
    EXPECT_EQ(a.face_offset, b.face_offset);
    EXPECT_EQ(a.face_ring, b.face_ring);
    EXPECT_EQ(a.vertex_offset, b.vertex_offset);
    EXPECT_EQ(a.vertex_ring, b.vertex_ring);
    for (Index f = 0; f < a.face_count(); ++f) {
        EXPECT_EQ(a.face_planes[f].normal, b.face_planes[f].normal);
        EXPECT_EQ(a.face_planes[f].offset, b.face_planes[f].offset);
    }
}

void expect_refused(const Points& points, const Faces& faces, const std::string& expected) {
    const Result<Polyhedron> body = polyhedron_from_faces(points, faces);
    EXPECT_FALSE(body) << expected;
    EXPECT_NE(body.error.find(expected), std::string::npos) << body.error;
    EXPECT_EQ(body.error.find('\n'), std::string::npos);
}

TEST(Polyhedron, CanonicalOrderOfATetrahedron) {
    const Points points = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
    const Result<Polyhedron> body = convex_hull(points);
    ASSERT_TRUE(body) << body.error;
    const std::vector<std::pair<Index, Index>> ends = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    ASSERT_EQ(body->edge_count(), ends.size());
    for (std::size_t e = 0; e < ends.size(); ++e) {
        EXPECT_EQ(body->edges[e].tail, ends[e].first);
        EXPECT_EQ(body->edges[e].head, ends[e].second);
    }
    // By hand: half-edge 2e runs up, 2e + 1 down; bottom 0-2-1, left 0-3-2, front 0-1-3, slant 1-2-3.
    EXPECT_EQ(body->face_ring, (std::vector<HalfEdge>{0, 8, 5, 1, 2, 7, 3, 4, 11, 6, 10, 9}));
    EXPECT_EQ(body->face_offset, (std::vector<Index>{0, 3, 6, 9, 12}));
    EXPECT_EQ(body->face_planes[0].normal, Vec3d(0, -1, 0));
    EXPECT_EQ(body->ring_of_vertex(0)[0], 0u);
    EXPECT_EQ(body->ring_of_vertex(0)[1], 4u);  // counter-clockwise from outside: towards z, not y
    EXPECT_EQ(body->ring_of_vertex(0)[2], 2u);
    EXPECT_DOUBLE_EQ(volume(*body), 1.0 / 6);
}

TEST(Polyhedron, FacesInAnyOrderGiveTheSameBits) {
    Dice dice(21);
    const Points points = placed(cube_points, random_rotation(dice), dice.vector(), 1);
    const Result<Polyhedron> first = polyhedron_from_faces(points, box_faces());
    ASSERT_TRUE(first) << first.error;
    for (int trial = 0; trial < 50; ++trial) {
        Faces faces = box_faces();
        for (std::vector<Index>& face : faces) {
            std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(dice.below(4)), face.end());
        }
        for (std::size_t i = 5; i > 0; --i) std::swap(faces[i], faces[dice.below(i + 1)]);
        const Result<Polyhedron> other = polyhedron_from_faces(points, faces);
        ASSERT_TRUE(other) << other.error;
        expect_same_bits(*first, *other);
    }
    const Result<Polyhedron> hull = convex_hull(points);
    ASSERT_TRUE(hull);
    expect_same_bits(*first, *hull);
}

TEST(Polyhedron, ExtentAndVolumeFarFromTheOrigin) {
    Dice dice(22);
    double worst = 0;
    for (int trial = 0; trial < 50; ++trial) {
        const Vec3d shift = dice.vector() * 1e6;
        const Points box = placed(box_points(Vec3d(1, 2, 3)), random_rotation(dice), shift, 1);
        const Result<Polyhedron> body = convex_hull(box);
        ASSERT_TRUE(body) << body.error;
        worst = std::max(worst, std::abs(volume(*body) - 48));
    }
    std::printf("worst volume error of a box of 48 at 1e6: %.2g\n", worst);
    EXPECT_LE(worst, 1e-7);  // corners are rounded to 1e-10
    EXPECT_EQ(extent(box_points(Vec3d(1, 2, 2))), 6);
    EXPECT_EQ(extent(Points{}), 0);
    EXPECT_EQ(extent(Points{Vec3d(7, 8, 9)}), 0);
}

TEST(Polyhedron, VolumeOfANeedle) {
    Dice dice(23);
    const Points needle = placed(box_points(Vec3d(1, 1e-7, 1e-7)), random_rotation(dice), Vec3d::Zero(), 1);
    const Result<Polyhedron> body = convex_hull(needle);
    ASSERT_TRUE(body) << body.error;
    EXPECT_NEAR(volume(*body) / 8e-14, 1, 1e-7);
}

TEST(Polyhedron, PlanesFitSliversAndFarFaces) {
    Dice dice(24);
    double worst = 0;
    for (int trial = 0; trial < 50; ++trial) {
        Points points = sphere_points(dice, 20, Vec3d(1, 1, 1e-6));
        points.push_back(points[0] + dice.vector() * 1e-9);
        const Vec3d shift = dice.vector() * (trial % 2 == 0 ? 0 : 1e3);
        const Result<Polyhedron> body = convex_hull(placed(points, random_rotation(dice), shift, 1));
        ASSERT_TRUE(body) << body.error;
        for (Index f = 0; f < body->face_count(); ++f) {
            for (const HalfEdge h : body->ring_of_face(f)) {
                const double off = body->face_planes[f].distance(body->vertices[body->tail(h)]);
                worst = std::max(worst, std::abs(off) / (1 + norm(shift)));
            }
        }
    }
    std::printf("worst corner off its plane: %.2g of the body and its offset\n", worst);
    EXPECT_LE(worst, 1e-15);
}

TEST(FromFaces, CoplanarNeighboursStayApart) {
    const Result<Polyhedron> body = polyhedron_from_faces(cube_points, triangulated_box_faces());
    ASSERT_TRUE(body) << body.error;
    EXPECT_EQ(body->face_count(), 12u);
    EXPECT_EQ(body->edge_count(), 18u);
    EXPECT_EQ(all_violations(*body), "");
    EXPECT_EQ(volume(*body), 8);
}

TEST(FromFaces, InwardFacesAreTurnedRound) {
    Faces inward = box_faces();
    for (std::vector<Index>& face : inward) std::reverse(face.begin(), face.end());
    const Result<Polyhedron> turned = polyhedron_from_faces(cube_points, inward);
    ASSERT_TRUE(turned) << turned.error;
    const Result<Polyhedron> outward = polyhedron_from_faces(cube_points, box_faces());
    ASSERT_TRUE(outward);
    expect_same_bits(*turned, *outward);
}

TEST(FromFaces, DuplicatesAreWeldedAndUnusedVerticesLeftOut) {
    Points points = cube_points;
    points.push_back(cube_points[3]);
    points.push_back(Vec3d(9, 9, 9));
    Faces faces = box_faces();
    std::replace(faces[1].begin(), faces[1].end(), Index{3}, Index{8});
    const Result<Polyhedron> body = polyhedron_from_faces(points, faces);
    ASSERT_TRUE(body) << body.error;
    EXPECT_EQ(body->input_index, (std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(body.warning, "1 vertices are in no face and were left out, the first is vertex 9");
}

TEST(FromFaces, RefusesBrokenSurfaces) {
    Faces open = box_faces();
    open.pop_back();
    expect_refused(cube_points, open, "not closed: edge ");

    Faces mixed = box_faces();
    std::reverse(mixed[2].begin(), mixed[2].end());
    expect_refused(cube_points, mixed, "in the same direction");

    Faces doubled = box_faces();
    doubled.push_back(doubled[0]);
    expect_refused(cube_points, doubled, "lies in 3 faces");

    Faces unknown = box_faces();
    unknown[4][1] = 8;
    expect_refused(cube_points, unknown, "face 4 names vertex 8, but there are only 8 (0 to 7)");

    Faces short_face = box_faces();
    short_face[3] = {2, 6};
    expect_refused(cube_points, short_face, "face 3 has 2 corners");

    Faces repeated = box_faces();
    repeated[3] = {2, 6, 7, 6};
    expect_refused(cube_points, repeated, "face 3 passes vertex 6 twice");

    expect_refused(cube_points, {}, "0 faces");
    EXPECT_EQ(build_polyhedron({}).error, "there are no faces");
    const FaceRings loose{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 1, 2, 3}, {{0, 1, 2}, {0, 2, 1}}};
    EXPECT_TRUE(build_polyhedron(loose).error.starts_with("vertex 3 has only 0 faces around it"));
    expect_refused(box_points(Vec3d(1, 1, 0)), box_faces(), "flat");
}

TEST(FromFaces, RefusesWhatIsNotConvex) {
    Points dented = cube_points;
    dented.push_back(Vec3d(0, 0, 0.5));
    Faces roof = box_faces();
    roof.pop_back();
    for (const auto& [a, b] : {std::pair<Index, Index>{4, 5}, {5, 7}, {7, 6}, {6, 4}})
        roof.push_back({a, b, 8});
    expect_refused(dented, roof, "not convex: vertex ");
    dented.back().z() = 1.5;
    const Result<Polyhedron> gable = polyhedron_from_faces(dented, roof);
    EXPECT_TRUE(gable) << gable.error;

    Points bent = cube_points;
    bent[7].z() += 1e-4;
    expect_refused(bent, box_faces(), "is not planar");
    bent[7].z() = cube_points[7].z() + 0x1p-24;  // as single precision bends a face
    const Result<Polyhedron> hull = polyhedron_from_faces(bent, box_faces());
    ASSERT_TRUE(hull) << hull.error;
    EXPECT_NE(hull.warning.find("hull"), std::string::npos) << hull.warning;
    EXPECT_GT(hull->face_count(), 6U);

    Points middle = cube_points;  // vertex 8 in the middle of edge 4-5
    middle.push_back(Vec3d(0, -1, 1));
    Faces split = box_faces();
    split[2] = {0, 1, 5, 8, 4};
    split[5] = {4, 8, 5, 7, 6};
    expect_refused(middle, split, "vertex 8 has only 2 faces around it");

    Faces sliver = box_faces();
    sliver[5] = {4, 8, 7, 6};
    sliver.push_back({8, 5, 7});
    sliver.push_back({4, 5, 8});
    expect_refused(middle, sliver, "no area");
}

TEST(Polyhedron, RefusesMoreEdgesThanAPairCanName) {
    for (const std::size_t count : {most_edges, most_edges + 1}) {
        FaceRings polygon;
        for (std::size_t i = 0; i < count; ++i) {
            const double x = static_cast<double>(i) / static_cast<double>(count);
            polygon.vertices.emplace_back(x, x * x, 0);
            polygon.input_index.push_back(static_cast<Index>(i));
        }
        polygon.rings.push_back(polygon.input_index);
        polygon.rings.emplace_back(polygon.input_index.rbegin(), polygon.input_index.rend());
        const Result<Polyhedron> body = build_polyhedron(polygon);
        EXPECT_EQ(static_cast<bool>(body), count <= most_edges) << body.error;
        EXPECT_EQ(body.error.find("2097151 are the most") != std::string::npos, count > most_edges)
            << body.error;
    }
}

}  // namespace
}  // namespace edgewise
