// SPDX-License-Identifier: MIT
//
// Certificates in closed form: bounds, common points, widening, bad input; and roots rounded
// outward.
#include "edgewise/truth/certificate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "edgewise/truth/dyadic.hpp"
#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Certificate, boxes_in_closed_form) {
    const std::vector<std::uint32_t> right = {1, 3, 5, 7}, left = {0, 2, 4, 6}, corner = {7}, other = {0};
    for (const double gap : {0.25, 0x1p-40}) {
        const Pose pose = moved({1 + gap, 0.5, 0});
        const auto faces = certify(unit_box, {}, unit_box, pose, right, left);
        EXPECT_EQ(faces->lower, gap);
        EXPECT_EQ(faces->upper, gap);
        for (const double along : {1.0, -1e300, 5e-324}) {
            const auto given = certify(unit_box, {}, unit_box, pose, corner, other, {along, 0, 0});
            EXPECT_EQ(given->lower, gap);
            EXPECT_GT(given->upper, 1);
        }
        // An irrational distance lies strictly between two doubles.
        const auto apart = certify(unit_box, {}, unit_box, moved({1 + gap, 1 + gap, 1}), corner, other);
        EXPECT_LT(apart->lower, apart->upper);
        EXPECT_EQ(apart->upper, std::nextafter(apart->lower, infinity));
        EXPECT_NEAR(apart->upper, std::sqrt(2 * gap * gap), 4e-16 * gap);
    }
}

TEST(Certificate, takes_the_vertices_that_the_body_has) {
    const Points segment = {{0, 0, 0}, {4, 0, 0}}, point = {{3, 4, 0}};
    const std::vector<std::uint32_t> both = {0, 1}, one = {0}, beyond = {9, 1, 0}, none;
    for (const auto& vertices : {both, beyond}) {
        const auto found = certify(segment, {}, point, {}, vertices, one, {0, nan, 0});
        EXPECT_EQ(found->upper, 4);
        EXPECT_EQ(found->lower, 4);
    }
    EXPECT_EQ(certify(segment, {}, point, {}, none, none)->upper, 5);
    EXPECT_EQ(certify(segment, {}, point, {}, one, one, {0, -2, 0})->lower, 4);
}

TEST(Certificate, proves_a_common_point) {
    const std::vector<std::uint32_t> all = {0, 1, 2, 3, 4, 5, 6, 7}, far = {0};
    const auto common = certify(unit_box, {}, unit_box, moved({0.3, 0.4, 0.5}), all, all);
    EXPECT_EQ(common->lower, 0);
    EXPECT_EQ(common->upper, 0);
    const auto unproved = certify(unit_box, {}, unit_box, moved({0.5, 0, 0}), far, far, {1, 2, 3});
    EXPECT_EQ(unproved->lower, 0);
    EXPECT_EQ(unproved->upper, 0.5);
}

TEST(Certificate, says_what_is_wrong) {
    const std::vector<std::uint32_t> first = {0};
    EXPECT_NE(certify({}, {}, unit_box, {}, first, first).error.find("body A: no vertices"),
              std::string::npos);
    EXPECT_NE(certify(unit_box, {}, unit_box, moved({nan, 0, 0}), first, first).error.find("body B"),
              std::string::npos);
}

TEST(Certificate, widen_rounds_outward) {
    RandomBodies random(34);
    for (int i = 0; i < 2000; ++i) {
        // Errors from far below the bounds up to the lower one, where the difference cancels.
        const double lower = 1 + std::abs(random.number());
        const double size = std::ldexp(lower, -(i % 20));
        const double error_a = size * std::abs(random.number());
        const double error_b = i % 3 == 0 ? 0 : size - error_a;
        const Certificate wide = widen({lower, 2 * lower}, error_a, error_b);
        const mpq_class error = mpq_class(error_a) + mpq_class(error_b);
        EXPECT_LE(mpq_class(wide.lower), std::max(mpq_class(0), mpq_class(mpq_class(lower) - error)));
        EXPECT_GE(mpq_class(wide.upper), 2 * mpq_class(lower) + error);
        EXPECT_NEAR(wide.lower, lower - error_a - error_b, 1e-15);
        EXPECT_NEAR(wide.upper, 2 * lower + error_a + error_b, 3e-15);
    }
    EXPECT_EQ(widen({1, 2}, 0, 0).lower, 1);
    EXPECT_EQ(widen({1, 2}, 0, 0).upper, 2);
    EXPECT_EQ(widen({1, 2}, 0, 3).lower, 0);
    for (const double error : {nan, infinity, -1.0}) {
        EXPECT_EQ(widen({1, 2}, error, 0).lower, 0);
        EXPECT_EQ(widen({1, 2}, 0, error).upper, infinity);
    }
}

TEST(Certificate, representation_error_is_the_farthest_move) {
    const Points given = {{0, 0, 0}, {1, 1, 1}};
    const Points kept = {{0, 0, 0}, {1, 1 + 3e-3, 1 - 4e-3}};
    Mat3d stretched = Mat3d::Identity() * 2;
    const double error = representation_error(given, kept, stretched);
    EXPECT_NEAR(error, 0.01, 1e-15);
    EXPECT_EQ(representation_error(given, given, stretched), 0);
    stretched(0, 0) = nan;
    EXPECT_EQ(representation_error(given, kept, stretched), infinity);
}

/// Against the processor's square root, which rounds to nearest.
TEST(Dyadic, roots_rounded_outward_enclose) {
    RandomBodies random(33);
    int exact = 0;
    for (int i = 0; i < 20000; ++i) {
        const mpz_class n = static_cast<unsigned long>(random.bits()() >> (11 + i % 50));
        const mpz_class square = i % 3 == 0 ? mpz_class(n * n) : n;
        const mpq_class value(square);
        const double down = root_rounded_down(square, 1, 0);
        const double up = root_rounded_up(square, 1, 0);
        EXPECT_LE(mpq_class(down) * mpq_class(down), value);
        EXPECT_GE(mpq_class(up) * mpq_class(up), value);
        if (down == up) {
            ++exact;
            EXPECT_EQ(mpq_class(down) * mpq_class(down), value);
        } else {
            EXPECT_EQ(std::nextafter(down, infinity), up);
        }
    }
    EXPECT_GT(exact, 5000);
    EXPECT_EQ(root_rounded_down(1, 1, 5000), std::numeric_limits<double>::max());
    EXPECT_EQ(root_rounded_up(1, 1, 5000), infinity);
    EXPECT_EQ(root_rounded_down(1, 1, -5000), 0);
    EXPECT_EQ(root_rounded_up(1, 1, -5000), std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(root_rounded_up(0, 1, -5000), 0);
}

}  // namespace
}  // namespace edgewise::truth
