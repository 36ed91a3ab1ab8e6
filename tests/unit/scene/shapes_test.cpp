// SPDX-License-Identifier: MIT
//
// Every built-in shape: its counts, its soundness, its exactness in single precision, and the names that
// fail.
#include "edgewise/scene/shapes.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <set>

#include "edgewise/geometry/check_polyhedron.hpp"
#include "edgewise/scene/sphere_points.hpp"

namespace edgewise::scene {
namespace {

struct Counts {
    const char* name;
    std::size_t vertices, edges, faces;
};

/// Small members one by one, then the sizes that sweeps use.
const Counts known_counts[] = {
    {"tetra4", 4, 6, 4},
    {"cube8", 8, 12, 6},
    {"box8", 8, 12, 6},
    {"sphere6", 6, 12, 8},
    {"sphere8", 8, 18, 12},
    {"sphere18", 18, 48, 32},
    {"sphere26", 26, 72, 48},
    {"sphere38", 38, 108, 72},
    {"sphere56", 56, 162, 108},
    {"sphere66", 66, 192, 128},
    {"sphere98", 98, 288, 192},
    {"sphere102", 102, 300, 200},
    {"sphere152", 152, 450, 300},
    {"sphere386", 386, 1152, 768},
    {"uv_sphere386", 386, 1152, 768},
    {"sphere1538", 1538, 4608, 3072},
    {"sphere4902", 4902, 14700, 9800},
    {"sphere6146", 6146, 18432, 12288},
    {"sphere24578", 24578, 73728, 49152},
};

class Shape : public ::testing::TestWithParam<Counts> {};

/// Smallest angle between neighbouring faces: how far the flattest quad is from flat.
double flattest_edge(const Polyhedron& body) {
    double smallest = 4;
    for (const PolyhedronEdge& edge : body.edges) {
        const Vec3d a = body.face_planes[edge.left].normal, b = body.face_planes[edge.right].normal;
        smallest = std::min(smallest, std::atan2(norm(cross(a, b)), dot(a, b)));
    }
    return smallest;
}

TEST_P(Shape, HasItsCountsAndIsSound) {
    const Counts& want = GetParam();
    const Result<Polyhedron> body = make_shape(want.name);
    ASSERT_TRUE(body) << body.error;
    EXPECT_EQ(body->vertex_count(), want.vertices) << "a vertex is not extreme";
    EXPECT_EQ(body->edge_count(), want.edges);
    EXPECT_EQ(body->face_count(), want.faces);
    for (const std::string& violation : check_polyhedron(*body)) ADD_FAILURE() << violation;
    double low = 2, high = 0;
    for (const Vec3d& v : body->vertices) low = std::min(low, norm(v)), high = std::max(high, norm(v));
    std::printf("%-12s radius %.6f .. %.6f, flattest edge %.1e rad\n", want.name, low, high,
                flattest_edge(*body));
    EXPECT_GT(low, 0.85);
    EXPECT_LT(high, 1.13);
    if (want.vertices == 8 && want.faces == 6) return;
    for (Index f = 0; f < body->face_count(); ++f) ASSERT_EQ(body->ring_of_face(f).size(), 3U);
}

TEST_P(Shape, IsExactInSinglePrecisionAtEverySizeClass) {
    const Result<Polyhedron> body = make_shape(GetParam().name);
    ASSERT_TRUE(body) << body.error;
    for (const double factor : {0.75, 1.0, 1.25, 1.5}) {
        for (const Vec3d& v : scaled(*body, factor).vertices) {
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_EQ(static_cast<double>(static_cast<float>(v[axis])), v[axis]);
        }
    }
}

TEST(Shapes, AnEllipsoidIsItsSphereWithUnequalAxes) {
    for (const std::string count : {"38", "386"}) {
        const Result<Polyhedron> body = make_shape("ellipsoid" + count),
                                 sphere = make_shape("sphere" + count);
        ASSERT_TRUE(body) << body.error;
        EXPECT_THAT(check_polyhedron(*body), testing::IsEmpty());
        ASSERT_EQ(body->vertex_count(), sphere->vertex_count());
        std::set<std::array<double, 3>> of_body, of_sphere;
        for (const Vec3d& v : body->vertices) of_body.insert({v.x(), 2 * v.y(), 4 * v.z()});
        for (const Vec3d& v : sphere->vertices) of_sphere.insert({v.x(), v.y(), v.z()});
        EXPECT_EQ(of_body, of_sphere);
    }
    EXPECT_THAT(make_shape("ellipsoid40").error, testing::HasSubstr("ellipsoid38 and ellipsoid56"));
}

INSTANTIATE_TEST_SUITE_P(All, Shape, ::testing::ValuesIn(known_counts),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(Shapes, TheListIsWhatIsMade) {
    std::size_t small = 0;
    std::set<std::string> names;
    std::size_t last = 0;
    for (const ShapeInfo& info : list_shapes()) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name << " twice";
        EXPECT_TRUE(info.vertices > last || info.name.substr(0, 6) != "sphere" || info.name == "sphere6");
        last = info.vertices;
        EXPECT_EQ(info.vertices + info.faces, info.edges + 2) << info.name;
        if (info.vertices > 800) continue;
        const Result<Polyhedron> body = make_shape(info.name);
        ASSERT_TRUE(body) << body.error;
        EXPECT_EQ(body->vertex_count(), info.vertices) << info.name;
        EXPECT_EQ(body->edge_count(), info.edges) << info.name;
        EXPECT_EQ(body->face_count(), info.faces) << info.name;
        EXPECT_TRUE(check_polyhedron(*body).empty()) << info.name;
        ++small;
    }
    std::printf("%zu shapes listed, %zu of them made\n", names.size(), small);
    EXPECT_GT(small, 25U);
    EXPECT_TRUE(names.count("sphere24578"));
}

TEST(Shapes, NoSizeIsInBothFamilies) {
    std::set<std::size_t> sizes;
    for (const SphereSize& size : sphere_sizes()) EXPECT_TRUE(sizes.insert(size.vertices()).second);
}

TEST(Shapes, ScalingKeepsABodySound) {
    const Result<Polyhedron> body = make_shape("sphere386");
    ASSERT_TRUE(body) << body.error;
    const Polyhedron large = scaled(*body, 1.5);
    EXPECT_TRUE(check_polyhedron(large).empty());
    EXPECT_NEAR(volume(large), 3.375 * volume(*body), 1e-12);
    EXPECT_NEAR(volume(*body), 4.1, 0.1);
}

TEST(Shapes, GoldenCoordinates) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const SphereSize size :
         {SphereSize{SphereFamily::octahedral, 3}, SphereSize{SphereFamily::cubic, 8}}) {
        for (const Vec3d& p : sphere_points(size)) {
            for (int axis = 0; axis < 3; ++axis) {
                const auto grid = static_cast<std::int64_t>(p[axis] * 0x1p21);
                ASSERT_EQ(static_cast<double>(grid) * 0x1p-21, p[axis]);
                hash = (hash ^ static_cast<std::uint64_t>(grid)) * 0x100000001b3;
            }
        }
    }
    std::printf("hash of sphere38 and sphere386: %016llx\n", static_cast<unsigned long long>(hash));
    EXPECT_EQ(hash, 0xdb64dd829bf925bfU);
}

void expect_error(const char* name, std::initializer_list<const char*> parts) {
    const Result<Polyhedron> body = make_shape(name);
    ASSERT_FALSE(body) << name;
    for (const char* part : parts) EXPECT_NE(body.error.find(part), std::string::npos) << body.error;
    EXPECT_EQ(body.error.find('\n'), std::string::npos);
}

TEST(Shapes, WrongNamesSayWhatIsRight) {
    expect_error("teapot", {"'teapot'", "tetra4", "cube8", "sphereN"});
    expect_error("", {"tetra4"});
    expect_error("sphere", {"sphereN"});
    expect_error("sphere38x", {"sphereN"});
    expect_error("sphere-38", {"sphereN"});
    expect_error("sphere038", {"sphereN"});
    expect_error("sphere40", {"sphere38 and sphere56"});
    expect_error("sphere1", {"sphere6"});
    expect_error("sphere100001", {"sphere99858"});
    expect_error("sphere99999999999999999999999999", {"sphere99858"});
}

}  // namespace
}  // namespace edgewise::scene
