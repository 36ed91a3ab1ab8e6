// SPDX-License-Identifier: MIT
//
// Matrices that users write for rotations: which are taken, which are replaced, and what each of the others
// is called.
#include "edgewise/scene/nearest_rotation.hpp"

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>

#include "edgewise/geometry/message.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise {
namespace {

using ::testing::HasSubstr;

/// Another way to the orthogonal polar factor (Higham 1986): the mean with the inverse's transpose, in long
/// double.
Mat3d polar_factor(const Mat3d& given) {
    Mat3<long double> x = given.cast<long double>();
    for (int i = 0; i < 20; ++i) {
        const Mat3<long double> other = x.inverse().transpose();
        x = (x + other) / 2;
    }
    return x.cast<double>();
}

double largest(const Mat3d& m) { return m.cwiseAbs().maxCoeff(); }

Mat3d product(const Mat3d& a, const Mat3d& b) {
    Mat3d result;
    for (int column = 0; column < 3; ++column) {
        const Vec3d axis = b.col(column);
        result.col(column) = multiply(a, axis);
    }
    return result;
}

Mat3d noise(scene::Rng& rng) {
    Mat3d result;
    for (int j = 0; j < 3; ++j) result.col(j) = rng.in_cube(1);
    return result;
}

TEST(NearestRotation, LeavesWhatRoundingLeft) {
    scene::Rng rng(1);
    for (int i = 0; i < 500; ++i) {
        const Mat3d r = i % 2 == 0 ? rng.rotation() : Mat3d(rng.rotation() + 1e-13 * noise(rng));
        const auto found = nearest_rotation(r);
        ASSERT_TRUE(found) << found.error;
        EXPECT_EQ(*found, r);
        EXPECT_EQ(found.warning, "");
    }
}

/// From 1e-12 to 1e-3: single precision, and matrices typed with three digits and more.
TEST(NearestRotation, ReplacesWhatIsNearlyOne) {
    scene::Rng rng(2);
    int replaced = 0;
    double farthest = 0;
    for (int i = 0; i < 3000; ++i) {
        const double off = std::pow(10.0, rng.uniform(-11.5, -3.6));
        const Mat3d r = rng.rotation() + off * noise(rng);
        const auto found = nearest_rotation(r);
        ASSERT_TRUE(found) << found.error;
        if (ortho_error(r) <= written_rotation_rounding) continue;
        ++replaced;
        farthest = std::max(farthest, ortho_error(r));
        EXPECT_LE(ortho_error(*found), rotation_rounding);
        EXPECT_LE(largest(*found - polar_factor(r)), rotation_rounding) << off;
        EXPECT_THAT(found.warning,
                    ::testing::AllOf(::testing::StartsWith("is "), HasSubstr(" from a rotation")));
    }
    EXPECT_GT(replaced, 2900);
    EXPECT_GT(farthest, 3e-4);
}

TEST(NearestRotation, NamesAScale) {
    scene::Rng rng(3);
    for (const double scale :
         {1e-300, 1e-9, 0.001, 0.01, 0.0254, 0.1, 0.5, 0.99, 1.01, 1.5, 2.0, 10.0, 1000.0, 1e150, 1e300}) {
        const auto found = nearest_rotation(scale * rng.rotation());
        ASSERT_FALSE(found) << scale;
        EXPECT_EQ(found.error, "is " + rounded(scale, 6) + " times a rotation: scale the vertices instead");
        EXPECT_THAT(nearest_rotation(-scale * rng.rotation()).error, HasSubstr("times a mirror image"));
    }
}

TEST(NearestRotation, NamesScalesOfSingleAxes) {
    scene::Rng rng(4);
    for (const Vec3d& scales : {Vec3d(1, 1, 2), Vec3d(0.001, 1, 1), Vec3d(1, 1.01, 1), Vec3d(3, 2, 1)}) {
        const auto found = nearest_rotation(product(rng.rotation(), Mat3d(scales.asDiagonal())));
        ASSERT_FALSE(found);
        EXPECT_THAT(found.error,
                    ::testing::StartsWith("scales the body's axes by " + rounded(scales.x(), 6)));
        EXPECT_THAT(found.error, ::testing::Not(HasSubstr("mirrors")));
    }
    EXPECT_THAT(nearest_rotation(Mat3d(Vec3d(1, -2, 1).asDiagonal())).error, HasSubstr("and mirrors it"));
}

TEST(NearestRotation, NamesMirrorImages) {
    scene::Rng rng(5);
    for (int i = 0; i < 100; ++i) {
        Mat3d r = rng.rotation();
        if (i % 3 == 0) r = -r;
        if (i % 3 == 1) r.row(i % 2).swap(r.row(2));
        if (i % 3 == 2) r.col(1) *= -1;
        if (i >= 50) r += 1e-6 * noise(rng);
        const auto found = nearest_rotation(r);
        ASSERT_FALSE(found);
        EXPECT_THAT(found.error, ::testing::StartsWith("is a mirror image"));
    }
}

TEST(NearestRotation, NamesWhatFlattens) {
    scene::Rng rng(6);
    EXPECT_THAT(nearest_rotation(Mat3d::Zero()).error, ::testing::StartsWith("is zero"));
    for (int i = 0; i < 100; ++i) {
        Mat3d r = rng.rotation();
        const int first = i % 3, second = (i + 1) % 3;
        if (i % 4 == 0) r.col(first).setZero();
        if (i % 4 == 1) r.col(first) = 3 * r.col(second);
        if (i % 4 == 2) r.col(first) = r.col(second) + 0.5 * r.col((i + 2) % 3);
        if (i % 4 == 3) r.row(first).setZero();
        if (i >= 50) r *= 1e-100;
        const auto found = nearest_rotation(r);
        ASSERT_FALSE(found);
        EXPECT_THAT(found.error, ::testing::StartsWith("flattens the body")) << r;
    }
}

TEST(NearestRotation, RefusesAllElseWithTheDistance) {
    scene::Rng rng(7);
    for (int i = 0; i < 200; ++i) {
        Mat3d r = rng.rotation();
        r(i % 3, i / 3 % 3) += rng.uniform(0.05, 0.3);
        if (!(ortho_error(r) > sloppiest_written_rotation)) continue;
        const auto found = nearest_rotation(r);
        ASSERT_FALSE(found);
        EXPECT_NE(found.error, "");
    }
    Mat3d shear = Mat3d::Identity();
    shear(0, 1) = 0.25;
    EXPECT_EQ(nearest_rotation(shear).error,
              "is no rotation: R^T R differs from the identity by 0.25, and at most 0.001 is taken");
    for (const double entry : {1e160, 1e200, -1e308}) {
        Mat3d large = Mat3d::Identity();
        large(2, 0) = entry;
        EXPECT_FALSE(nearest_rotation(large)) << entry;
    }
}

}  // namespace
}  // namespace edgewise
