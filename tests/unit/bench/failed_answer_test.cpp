// SPDX-License-Identifier: MIT
//
// A query that fails leaves no simplex and no features: its answer says that it failed, and nothing reads
// them. And what contradicts a certificate.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <set>

#include "edgewise/bench/certificates.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::bench {
namespace {

/// Poses that no query answers.
std::vector<Pose> impossible_poses() {
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    const Vec3d apart(3, 0, 0);
    std::vector<Pose> poses;
    for (const double scale : {0.0, 1e-300, 0.001, 0.1, 0.5, 2.0, 1000.0, 1e200, nan, infinity})
        poses.push_back({Mat3d(scale * Mat3d::Identity()), apart});
    Mat3d flat = Mat3d::Identity(), sheared = flat;
    flat.col(1) = flat.col(0);
    sheared(0, 1) = 0.5;
    poses.push_back({flat, apart});
    poses.push_back({sheared, apart});
    for (const double far : {1e200, nan, infinity}) poses.push_back({Mat3d::Identity(), Vec3d(far, 0, 0)});
    return poses;
}

TEST(FailedAnswer, HasNoFeaturesAndNoMore) {
    const Polyhedron body = *scene::make_shape("tetra4");
    const std::vector<Polyhedron> bodies = {body, body};
    int asked = 0;
    const std::set<std::string> asked_of = {"aos_f64",        "aos_f32",        "lean_f64",
                                            "points_soa_f64", "points_soa_f32", "quantised_f64"};
    for (const TableType& type : table_types()) {  // a build may have some of them alone
        const std::string& name = type.name;
        if (!asked_of.contains(name)) continue;
        for (const std::string& algorithm : type.algorithms) {
            const auto runner = type.make_runner(algorithm);
            runner->configure({.needs = Needs::certificate});
            ASSERT_EQ(runner->load(bodies), "");
            for (const Pose& pose : impossible_poses()) {
                for (const bool first : {true, false}) {
                    const scene::Query query{0, 1, 0, first ? pose : Pose{}, first ? Pose{} : pose};
                    const NamedAnswer answer = runner->answer(query);
                    EXPECT_EQ(answer.distance.status, Status::failed) << name << algorithm << pose.rotation;
                    EXPECT_TRUE(answer.feature_a.vertices.empty() && answer.feature_b.vertices.empty());
                    EXPECT_TRUE(answer.proof_a.empty());
                    EXPECT_FALSE(certificates_of(answer, query, bodies, runner->stored_bodies()));
                    ++asked;
                }
            }
            const scene::Query twice_and_half{0,
                                              1,
                                              0,
                                              {Mat3d(2 * Mat3d::Identity()), Vec3d::Zero()},
                                              {Mat3d(0.5 * Mat3d::Identity()), {3, 0, 0}}};
            EXPECT_EQ(runner->answer(twice_and_half).distance.status, Status::failed);
            EXPECT_NE(runner->answer({0, 1, 0, {}, {Mat3d::Identity(), {30, 0, 0}}}).distance.status,
                      Status::failed);
        }
    }
    EXPECT_GT(asked, 200);
}

TEST(Contradiction, IsADistanceOutsideTheCertificate) {
    const truth::Certificate certificate{2, 2.5};
    for (const double right : {2.0, 2.25, 2.5, 1.9, 2.7})
        EXPECT_EQ(contradiction(right, certificate, 0.125, 0.25), "") << right;
    for (const double wrong : {0.0, 1.8, 2.8, 1e300, std::nan(""), -2.25})
        EXPECT_THAT(contradiction(wrong, certificate, 0.125, 0.25),
                    testing::HasSubstr("contradicts its own certificate [2, 2.5]"))
            << wrong;
}

}  // namespace
}  // namespace edgewise::bench
