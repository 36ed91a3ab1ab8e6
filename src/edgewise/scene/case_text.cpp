// SPDX-License-Identifier: MIT
#include "edgewise/scene/case_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "edgewise/geometry/aabb.hpp"

namespace edgewise::scene {

namespace {

using LineJson = nlohmann::ordered_json;

LineJson body_json(const CaseBody& body) {
    LineJson vertices = LineJson::array();
    for (const Vec3d& v : body.vertices) vertices.push_back({v.x(), v.y(), v.z()});
    LineJson json = {{"vertices", vertices}};
    if (body.faces) json["faces"] = *body.faces;
    return json;
}

LineJson pose_json(const Pose& pose) {
    const auto rows = pose.rotation.reshaped<Eigen::RowMajor>();
    return {{"R", std::vector<double>(rows.begin(), rows.end())},
            {"t", {pose.translation.x(), pose.translation.y(), pose.translation.z()}}};
}

/// Text of a point, such as "(1, 2, 3)", with few enough digits to be readable.
std::string point_text(const Vec3d& p) {
    return fmt::format("({:.10g}, {:.10g}, {:.10g})", p.x(), p.y(), p.z());
}

bool is_identity(const Pose& pose) { return pose.rotation.isIdentity(0) && pose.translation.isZero(0); }

/// "{name}.matrix() << ..."
std::string fcl_pose(const char* name, const Pose& pose) {
    std::string text =
        fmt::format("    fcl::Transform3d {0} = fcl::Transform3d::Identity();\n    {0}.matrix() <<", name);
    Eigen::Matrix<double, 3, 4> rows;
    rows << pose.rotation, pose.translation;
    return text + fmt::format(" {}, 0, 0, 0, 1;\n", fmt::join(rows.reshaped<Eigen::RowMajor>(), ", "));
}

std::string fcl_body(const char* name, const Polyhedron& body) {
    std::string text =
        fmt::format("    auto {0}_points = std::make_shared<std::vector<fcl::Vector3d>>();\n", name);
    for (const Vec3d& v : body.vertices)
        text += fmt::format("    {}_points->emplace_back({}, {}, {});\n", name, v.x(), v.y(), v.z());
    text += fmt::format("    auto {}_faces = std::make_shared<std::vector<int>>(std::vector<int>{{", name);
    for (std::size_t f = 0; f < body.face_count(); ++f) {
        const auto ring = body.ring_of_face(static_cast<Index>(f));
        text += fmt::format("{}{}", f == 0 ? "" : ", ", ring.size());
        for (const HalfEdge h : ring) text += fmt::format(", {}", body.tail(h));
    }
    return text + fmt::format("}});\n    fcl::Convex<double> {0}({0}_points, {1}, {0}_faces);\n", name,
                              body.face_count());
}

std::string bullet_body(const char* name, const CaseBody& body) {
    std::string text = fmt::format("    btConvexHullShape {};\n", name);
    for (const Vec3d& v : body.vertices)
        text += fmt::format("    {}.addPoint(btVector3({}, {}, {}));\n", name, v.x(), v.y(), v.z());
    return text + fmt::format("    {}.setMargin(0);\n", name);
}

std::string bullet_pose(const char* name, const Pose& pose) {
    return fmt::format(
        "    btTransform {0};\n    {0}.setBasis(btMatrix3x3({1}));\n    {0}.setOrigin(btVector3({2}));\n",
        name, fmt::join(pose.rotation.reshaped<Eigen::RowMajor>(), ", "), fmt::join(pose.translation, ", "));
}

}  // namespace

Turn turn_of(const Mat3d& r) {
    constexpr double degrees_of_pi = 180, least_sine = 1e-4;
    const Vec3d twist(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));  // 2 sin(angle) axis
    const double sine = norm(twist) / 2, cosine = (r(0, 0) + r(1, 1) + r(2, 2) - 1) / 2;
    Turn turn;
    turn.degrees = std::atan2(sine, cosine) * degrees_of_pi / std::numbers::pi;
    if (sine > 0) turn.axis = twist / (2 * sine);
    if (cosine > 0 || sine > least_sine) return turn;
    // Nearly half a turn: (R + R^T) / 2 - cosine I is the axis times itself, times 1 - cosine.
    int longest = 0;
    r.diagonal().maxCoeff(&longest);
    Vec3d axis = (r.col(longest) + r.row(longest).transpose()) / 2;
    axis[longest] -= cosine;
    turn.axis = axis * ((dot(axis, twist) < 0 ? -1 : 1) / norm(axis));
    return turn;
}

std::string text_of(const CaseBody& body) {
    const Aabb box = box_of(body.vertices);
    const Vec3d sides = box.sides();
    return fmt::format("{} {} from {} to {}, extent {:.10g} x {:.10g} x {:.10g}{}", body.vertices.size(),
                       body.vertices.size() == 1 ? "vertex" : "vertices", point_text(box.low),
                       point_text(box.high), sides.x(), sides.y(), sides.z(),
                       body.faces ? fmt::format(", {} faces as given", body.faces->size()) : "");
}

std::string text_of(const Pose& pose) {
    if (is_identity(pose)) return "at the identity";
    const std::string place = "at " + point_text(pose.translation);
    if (pose.rotation.isIdentity(0)) return place + ", not turned";
    const Turn turn = turn_of(pose.rotation);
    return fmt::format("{}, turned by {:.10g} degrees about {}", place, turn.degrees, point_text(turn.axis));
}

std::string case_line(const Case& pair, const std::string& source,
                      const std::optional<ExpectedAnswer>& expected) {
    LineJson json = {{"id", pair.id}, {"source", source}, {"a", body_json(pair.a)}, {"b", body_json(pair.b)}};
    if (!is_identity(pair.pose_a)) json["pose_a"] = pose_json(pair.pose_a);
    if (!is_identity(pair.pose_b)) json["pose_b"] = pose_json(pair.pose_b);
    if (expected) json["expect"] = {{"distance", expected->distance}};
    if (expected && expected->depth) json["expect"]["depth"] = *expected->depth;
    return json.dump(-1, ' ', false, LineJson::error_handler_t::replace);
}

Result<std::string> fcl_test(const Case& pair, const ExpectedAnswer& expected) {
    using Text = Result<std::string>;
    const auto a = body_from_case(pair.a), b = body_from_case(pair.b);
    if (!a || !b) return Text::failure(!a ? a.error : b.error);
    if (a->face_count() < 4 || b->face_count() < 4)
        return Text::failure("a body is flat, and an fcl::Convex is a solid");
    std::string text = "#include <fcl/fcl.h>\n#include <gtest/gtest.h>\n\nTEST(Pair, HasItsDistance) {\n";
    text +=
        fcl_body("a", *a) + fcl_body("b", *b) + fcl_pose("X_WA", pair.pose_a) + fcl_pose("X_WB", pair.pose_b);
    text +=
        "    fcl::DistanceRequestd request;\n    request.enable_signed_distance = true;\n"
        "    fcl::DistanceResultd result;\n    fcl::distance(&a, X_WA, &b, X_WB, request, result);\n";
    const double wanted = expected.depth ? -*expected.depth : expected.distance;
    text +=
        fmt::format("    EXPECT_NEAR(result.min_distance, {}, request.distance_tolerance);\n}}\n", wanted);
    return Text::success(std::move(text));
}

std::string bullet_test(const Case& pair, const ExpectedAnswer& expected) {
    std::string text =
        "#include <BulletCollision/CollisionShapes/btConvexHullShape.h>\n"
        "#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>\n"
        "#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>\n"
        "#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>\n"
        "#include <gtest/gtest.h>\n\nTEST(Pair, HasItsDistance) {\n";
    text += bullet_body("a", pair.a) + bullet_body("b", pair.b);
    text += "    btGjkPairDetector::ClosestPointInput input;\n";
    text += bullet_pose("pose_a", pair.pose_a) + bullet_pose("pose_b", pair.pose_b);
    text +=
        "    input.m_transformA = pose_a;\n    input.m_transformB = pose_b;\n"
        "    btVoronoiSimplexSolver simplex;\n    btGjkPairDetector detector(&a, &b, &simplex, nullptr);\n"
        "    btPointCollector found;\n    detector.getClosestPoints(input, found, nullptr);\n";
    if (expected.distance > 0) {
        text += fmt::format(
            "    ASSERT_TRUE(found.m_hasResult);\n    EXPECT_NEAR(found.m_distance, {}, 1e-6);\n}}\n",
            expected.distance);
    } else {
        text += "    EXPECT_FALSE(found.m_hasResult && found.m_distance > 1e-6);\n}\n";
    }
    return text;
}

}  // namespace edgewise::scene
