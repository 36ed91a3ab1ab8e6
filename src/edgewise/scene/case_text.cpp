// SPDX-License-Identifier: MIT
#include "edgewise/scene/case_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
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

/// A line for each point, with its coordinates in this call.
std::string lines_of(const std::vector<Vec3d>& points, const char* call) {
    std::string text;
    for (const Vec3d& v : points)
        text += fmt::format(fmt::runtime(call), fmt::format("{}, {}, {}", v.x(), v.y(), v.z()));
    return text;
}

/// The corners of each face, behind their number.
std::string faces_text(const Polyhedron& body) {
    std::string text;
    for (std::size_t f = 0; f < body.face_count(); ++f) {
        const auto ring = body.ring_of_face(static_cast<Index>(f));
        text += fmt::format("{}{}", f == 0 ? "" : ", ", ring.size());
        for (const HalfEdge h : ring) text += fmt::format(", {}", body.tail(h));
    }
    return text;
}

std::string rows_text(const Pose& pose) {
    Eigen::Matrix<double, 3, 4> rows;
    rows << pose.rotation, pose.translation;
    return fmt::format("{}", fmt::join(rows.reshaped<Eigen::RowMajor>(), ", "));
}

}  // namespace

Turn turn_of(const Mat3d& rotation) {
    const Eigen::AngleAxisd turn(rotation);
    return {turn.axis(), turn.angle() * 180 / std::numbers::pi};
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
    return Text::success(
        fmt::format(fmt::runtime(fcl_test_text),
                    fmt::arg("points_a", lines_of(a->vertices, "    a_points->emplace_back({});\n")),
                    fmt::arg("points_b", lines_of(b->vertices, "    b_points->emplace_back({});\n")),
                    fmt::arg("faces_a", faces_text(*a)), fmt::arg("faces_b", faces_text(*b)),
                    fmt::arg("count_a", a->face_count()), fmt::arg("count_b", b->face_count()),
                    fmt::arg("pose_a", rows_text(pair.pose_a)), fmt::arg("pose_b", rows_text(pair.pose_b)),
                    fmt::arg("wanted", expected.depth ? -*expected.depth : expected.distance)));
}

std::string bullet_test(const Case& pair, const ExpectedAnswer& expected) {
    const auto rotation = [](const Pose& pose) {
        return fmt::format("{}", fmt::join(pose.rotation.reshaped<Eigen::RowMajor>(), ", "));
    };
    const auto origin = [](const Pose& pose) { return fmt::format("{}", fmt::join(pose.translation, ", ")); };
    return fmt::format(
        fmt::runtime(bullet_test_text),
        fmt::arg("points_a", lines_of(pair.a.vertices, "    a.addPoint(btVector3({}));\n")),
        fmt::arg("points_b", lines_of(pair.b.vertices, "    b.addPoint(btVector3({}));\n")),
        fmt::arg("rotation_a", rotation(pair.pose_a)), fmt::arg("rotation_b", rotation(pair.pose_b)),
        fmt::arg("origin_a", origin(pair.pose_a)), fmt::arg("origin_b", origin(pair.pose_b)),
        fmt::arg(
            "expected",
            expected.distance > 0
                ? fmt::format("ASSERT_TRUE(found.m_hasResult);\n    EXPECT_NEAR(found.m_distance, {}, 1e-6)",
                              expected.distance)
                : "EXPECT_FALSE(found.m_hasResult && found.m_distance > 1e-6)"));
}

}  // namespace edgewise::scene
