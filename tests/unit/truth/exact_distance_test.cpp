// SPDX-License-Identifier: MIT
//
// The exact oracle against answers known in closed form: boxes, every kind of contact, flat bodies, far-off
// and tiny coordinates, bad input.
#include "edgewise/truth/exact_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "edgewise/truth/exact_proof.hpp"
#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

ExactDistance ask(const Points& a, const Points& b, const Pose& pose_a = {}, const Pose& pose_b = {}) {
    const Result<ExactDistance> answer = exact_distance(a, pose_a, b, pose_b);
    EXPECT_TRUE(answer) << answer.error;
    return answer ? *answer : ExactDistance{};
}

struct Contact {
    const char* name;
    Points b;    ///< touches the unit box
    Vec3d away;  ///< moving b along this parts them at once; the other way, they overlap
};

std::vector<Contact> contacts() {
    return {
        {"V-V", box({1, 1, 1}, {2, 2, 2}), {1, 1, 1}},
        {"V-E", {{1, 1, 0.5}, {2, 2, 0}, {2, 2, 1}, {3, 2, 0.5}}, {1, 1, 0}},
        {"V-F", {{1, 0.5, 0.5}, {2, 0, 0}, {2, 1, 0}, {2, 0, 1}}, {1, 0, 0}},
        {"E-E crossing", {{0, 2, 0.5}, {2, 0, 0.5}, {2, 2, 0}, {2, 2, 1}}, {1, 1, 0}},
        {"E-E parallel", box({1, 1, 0.25}, {2, 2, 0.5}), {1, 1, 0}},
        {"E-F", {{1, 0.25, 0.25}, {1, 0.75, 0.75}, {2, 0, 0}, {2, 1, 0}}, {1, 0, 0}},
        {"F-F", box({1, 0.25, 0.25}, {2, 1.25, 1.25}), {1, 0, 0}},
        {"F-F whole faces", box({1, 0, 0}, {2, 1, 1}), {1, 0, 0}},
    };
}

TEST(ExactDistance, boxes_at_dyadic_offsets) {
    for (const double gap : {1.0, 0.25, 0x1p-30, 0x1p-51}) {
        EXPECT_EQ(ask(unit_box, unit_box, {}, moved({1 + gap, 0.5, 0})).distance, gap);
        EXPECT_EQ(ask(unit_box, unit_box, {}, moved({1 + gap, 1 + gap, 0})).distance,
                  std::sqrt(2 * gap * gap));
        const ExactDistance corner = ask(unit_box, unit_box, {}, moved({1 + gap, 1 + gap, 1 + gap}));
        EXPECT_EQ(corner.distance, std::sqrt(3 * gap * gap));
        EXPECT_EQ(corner.separation, Vec3d(-gap, -gap, -gap));
        EXPECT_EQ(corner.verdict, ExactVerdict::separated);
    }
    // R v + t is no double here: only the exact sum sees these gaps.
    const Points beyond = {{1 + 0x1p-52, 0.5, 0.5}};
    EXPECT_EQ(ask(unit_box, beyond, {}, moved({-0x1p-105, 0, 0})).distance, 0x1p-52 - 0x1p-105);
    EXPECT_EQ(ask(unit_box, Points{{1, 0.5, 0.5}}, {}, moved({0x1p-105, 0, 0})).distance, 0x1p-105);
}

TEST(ExactDistance, every_kind_of_contact) {
    Mat3d turned;
    turned << 0, -1, 0, 0, 0, 1, -1, 0, 0;
    for (const Contact& c : contacts()) {
        for (const Mat3d& rotation : {Mat3d(Mat3d::Identity()), turned}) {
            const Pose pose_a{rotation, {3, -5, 0.125}};
            const ExactDistance touch = ask(unit_box, c.b, pose_a, pose_a);
            EXPECT_EQ(touch.verdict, ExactVerdict::touching) << c.name;
            EXPECT_EQ(touch.distance, 0) << c.name;
            EXPECT_EQ(touch.separation, Vec3d(0, 0, 0)) << c.name;
            for (const double step : {0.125, 0x1p-20, 0x1p-48}) {
                Pose pose_b = pose_a;
                pose_b.translation += multiply(rotation, Vec3d(step * c.away));
                const ExactDistance apart = ask(unit_box, c.b, pose_a, pose_b);
                EXPECT_EQ(apart.verdict, ExactVerdict::separated) << c.name;
                EXPECT_EQ(apart.distance, std::sqrt(step * step * squared_norm(c.away))) << c.name;
                pose_b.translation = pose_a.translation - multiply(rotation, Vec3d(step * c.away));
                EXPECT_EQ(ask(unit_box, c.b, pose_a, pose_b).verdict, ExactVerdict::overlapping) << c.name;
            }
        }
    }
}

TEST(ExactDistance, nested_and_identical) {
    EXPECT_EQ(ask(unit_box, unit_box).verdict, ExactVerdict::overlapping);
    const Points inner = box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5});
    EXPECT_EQ(ask(unit_box, inner).verdict, ExactVerdict::overlapping);
    // Nested and leaning against three faces from inside: common interior all the same.
    EXPECT_EQ(ask(unit_box, box({0, 0, 0}, {0.5, 0.5, 0.5})).verdict, ExactVerdict::overlapping);
    RandomBodies random(5);
    const Points sphere = random.on_sphere(200);
    const Pose pose{random.rotation(), random.unit()};
    EXPECT_EQ(ask(sphere, sphere, pose, pose).verdict, ExactVerdict::overlapping);
    Points mirrored;
    for (const Vec3d& v : unit_box) mirrored.push_back(Vec3d(2, 2, 2) - v);
    EXPECT_EQ(ask(unit_box, mirrored).verdict, ExactVerdict::touching);
}

TEST(ExactDistance, flat_bodies) {
    const Points square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const Points line = {{0.5, 0.5, -1}, {0.5, 0.5, 1}};
    // Coplanar and overlapping in their plane: no interior anywhere.
    EXPECT_EQ(ask(square, square, {}, moved({0.5, 0.5, 0})).verdict, ExactVerdict::touching);
    EXPECT_EQ(ask(square, square, {}, moved({0, 0, 0.25})).distance, 0.25);
    EXPECT_EQ(ask(square, square, {}, moved({2, 2, 0})).distance, std::sqrt(2.0));
    // A segment through a square: the difference is solid around the origin.
    EXPECT_EQ(ask(square, line).verdict, ExactVerdict::overlapping);
    EXPECT_EQ(ask(square, line, {}, moved({0, 0, 1})).verdict, ExactVerdict::touching);
    EXPECT_EQ(ask(square, line, {}, moved({0, 0.5, 0})).verdict, ExactVerdict::touching);
    EXPECT_EQ(ask(line, line).verdict, ExactVerdict::touching);
    EXPECT_EQ(ask(line, line, {}, moved({3, 4, 0.5})).distance, 5);
    const Points crossing = {{0, 0.5, 0.25}, {1, 0.5, 0.25}};
    EXPECT_EQ(ask(line, crossing).verdict, ExactVerdict::touching);
    EXPECT_EQ(ask(line, crossing, {}, moved({0, 2, 0})).distance, 2);
    const Points point = {{0.5, 0.5, 0.5}};
    EXPECT_EQ(ask(unit_box, point).verdict, ExactVerdict::overlapping);
    EXPECT_EQ(ask(unit_box, point, {}, moved({0.5, 0, 0})).verdict, ExactVerdict::touching);
    EXPECT_EQ(ask(point, point).verdict, ExactVerdict::touching);
    EXPECT_EQ(ask(point, point, {}, moved({2, 3, 6})).distance, 7);
    const Points collinear = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {1, 1, 1}};
    EXPECT_EQ(ask(collinear, unit_box, moved({2, 0, 0})).distance, 1);
    EXPECT_EQ(ask(collinear, unit_box).verdict, ExactVerdict::overlapping);
    const Points zero = {{0, 0, 0}, {0, 0, 0}};
    EXPECT_EQ(ask(zero, unit_box).verdict, ExactVerdict::touching);
    EXPECT_EQ(ask(unit_box, unit_box, Pose{Mat3d::Zero(), {4, 0.5, 0.5}}).distance, 3);
}

TEST(ExactDistance, far_from_the_origin) {
    const Vec3d far(0x1p40, -3 * 0x1p41, 5 * 0x1p39);
    const double gap = 0x1p-10;
    EXPECT_EQ(ask(unit_box, unit_box, moved(far), moved(far + Vec3d(1 + gap, 0.5, 0))).distance, gap);
    const Points far_box = box(far, far + Vec3d(1, 1, 1));
    EXPECT_EQ(ask(far_box, far_box, {}, moved({1 + gap, 0.5, 0})).distance, gap);
    EXPECT_EQ(ask(far_box, unit_box, {}, moved(far + Vec3d(1 + gap, 0.5, 0))).distance, gap);
    EXPECT_EQ(ask(far_box, far_box, {}, moved({1, 0.5, 0})).verdict, ExactVerdict::touching);
    EXPECT_EQ(ask(unit_box, unit_box, moved({1e12, 1e12, 1e12}), moved({1e12 + 2, 1e12, 1e12})).distance, 1);
    EXPECT_EQ(ask(unit_box, unit_box, {}, moved({0x1p500, 0, 0})).distance, 0x1p500);
}

TEST(ExactDistance, smallest_and_largest_numbers) {
    const double tiny = std::numeric_limits<double>::denorm_min();
    const Points a = box({0, 0, 0}, {4 * tiny, 4 * tiny, 4 * tiny});
    EXPECT_EQ(ask(a, a, {}, moved({7 * tiny, tiny, 0})).distance, 3 * tiny);
    // sqrt(3) denormal steps round to 2.
    EXPECT_EQ(ask(a, a, {}, moved({5 * tiny, 5 * tiny, 5 * tiny})).distance, 2 * tiny);
    EXPECT_EQ(ask(a, a, {}, moved({4 * tiny, tiny, 0})).verdict, ExactVerdict::touching);
    EXPECT_EQ(ask(a, a, {}, moved({3 * tiny, tiny, 0})).verdict, ExactVerdict::overlapping);
    EXPECT_EQ(ask(a, unit_box, {}, moved({tiny, 0, 0})).verdict, ExactVerdict::overlapping);
    EXPECT_EQ(ask(a, unit_box, {}, moved({5 * tiny, 0, 0})).distance, tiny);

    const double huge = std::numeric_limits<double>::max();
    const Points wide = box({-huge, -huge, -huge}, {huge, huge, huge});
    EXPECT_EQ(ask(wide, unit_box).verdict, ExactVerdict::overlapping);
    EXPECT_EQ(ask(wide, unit_box, {}, moved({huge, 0, 0})).verdict, ExactVerdict::touching);
    EXPECT_EQ(ask({{huge, 0, 0}}, {{-huge, 0, 0}}).distance, std::numeric_limits<double>::infinity());
    EXPECT_EQ(ask({{huge, 0, 0}, {-huge, tiny, 0}}, {{0, 0, 1}}).verdict, ExactVerdict::separated);
}

TEST(ExactDistance, bad_input_says_what_and_where) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    Pose bad_rotation, bad_translation;
    bad_rotation.rotation(1, 2) = nan;
    bad_translation.translation.z() = -infinite;
    const auto error = [](const Points& a, const Pose& pose_a, const Points& b, const Pose& pose_b) {
        return exact_distance(a, pose_a, b, pose_b).error;
    };
    EXPECT_EQ(error({}, {}, unit_box, {}), "body A: no vertices; give at least one point");
    EXPECT_EQ(error(unit_box, {}, {{0, 0, 0}, {0, nan, 0}}, {}),
              "body B: vertex 1 is not finite; give finite coordinates");
    EXPECT_EQ(error({{infinite, 0, 0}}, {}, unit_box, {}),
              "body A: vertex 0 is not finite; give finite coordinates");
    EXPECT_EQ(error(unit_box, {}, unit_box, bad_rotation),
              "body B: rotation is not finite; give nine finite numbers");
    EXPECT_EQ(error(unit_box, bad_translation, unit_box, {}),
              "body A: translation is not finite; give three finite numbers");
}

TEST(ExactDistance, proof_refuses_wrong_simplices) {
    const Pose beyond = moved({3, 0.5, 0.5});
    ExactPair bodies(unit_box, {}, unit_box, beyond);
    MinimumSimplex<IntegerVec> simplex;
    // Vertex 0 against vertex 0: in the difference, but others are nearer.
    ASSERT_TRUE(add_point(simplex, bodies.difference({0, 0}), VertexPair{0, 0}));
    EXPECT_THROW(require_optimal(bodies, simplex), std::logic_error);
    // A point that is not what its vertices say.
    MinimumSimplex<IntegerVec> elsewhere = simplex;
    elsewhere.point[0].x += 1;
    EXPECT_THROW(require_optimal(bodies, elsewhere), std::logic_error);
    // An edge and a direction that does not lead to a point of it.
    MinimumSimplex<IntegerVec> edge = simplex;
    edge.size = 2;
    edge.pair[1] = {1, 0};
    edge.point[1] = bodies.difference({1, 0});
    EXPECT_THROW(require_optimal(bodies, edge), std::logic_error);
    // The foot on an edge's line, beyond its ends; no vertex is nearer along it.
    const Points segment = {{1, 1, 0}, {1, 2, 0}}, origin = {{0, 0, 0}};
    ExactPair lines(segment, {}, origin, {});
    MinimumSimplex<IntegerVec> beyond_end;
    beyond_end.size = 2;
    beyond_end.pair = {VertexPair{0, 0}, VertexPair{1, 0}};
    for (int i = 0; i < 2; ++i) beyond_end.point[i] = lines.difference(beyond_end.pair[i]);
    beyond_end.direction = {1, 0, 0};
    beyond_end.height = beyond_end.point[0].x;
    EXPECT_THROW(require_optimal(lines, beyond_end), std::logic_error);
}

}  // namespace
}  // namespace edgewise::truth
