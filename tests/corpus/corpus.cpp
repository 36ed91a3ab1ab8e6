// SPDX-License-Identifier: MIT
#include "corpus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <utility>

#include "corpus_paths.hpp"

namespace edgewise {
namespace {

std::vector<scene::Case> read_all() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(corpus_folder)) {
        if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<scene::Case> cases;
    for (const auto& file : files) {
        std::ifstream stream(file);
        scene::CaseReader reader(stream, file.filename().string());
        while (auto line = reader.next()) {
            EXPECT_TRUE(*line) << line->error;
            if (*line) cases.push_back(**line);
        }
    }
    return cases;
}

void reverse(scene::CaseBody& body) {
    std::reverse(body.vertices.begin(), body.vertices.end());
    if (!body.faces) return;
    for (std::vector<Index>& face : *body.faces) {
        for (Index& v : face) v = static_cast<Index>(body.vertices.size()) - 1 - v;
    }
}

void scale(scene::CaseBody& body, Pose& pose, double factor) {
    for (Vec3d& v : body.vertices) v *= factor;
    pose.translation *= factor;
}

/// Rotation number `turn`: the first column is any axis with either sign, the second any other axis, and the
/// third completes a right-handed frame.
Mat3d quarter_turn(int turn) {
    const int first = turn / 8, second = (first + 1 + turn / 4 % 2) % 3;
    Mat3d result = Mat3d::Zero();
    result(first, 0) = turn % 2 == 0 ? 1 : -1;
    result(second, 1) = turn / 2 % 2 == 0 ? 1 : -1;
    const Vec3d x = result.col(0), y = result.col(1);
    result.col(2) = cross(x, y);
    return result;
}

Pose turned(const Pose& pose, const Mat3d& turn) {
    return {Mat3d(turn * pose.rotation), Vec3d(turn * pose.translation)};
}

/// Returns true if a + b is not rounded, by Knuth's error of a sum, which is itself exact.
bool is_exact_sum(double a, double b) {
    const double sum = a + b, of_b = sum - a;
    return (a - (sum - of_b)) + (b - of_b) == 0;
}

/// Longest power of two near the size, with either sign, that can be added to both coordinates without
/// rounding; 0 if there is none.
double exact_shift(double a, double b, double size) {
    for (int places = 30; places >= -8; --places) {
        const double shift = std::ldexp(1.0, std::ilogb(size) + places);
        for (const double s : {shift, -shift}) {
            if (is_exact_sum(a, s) && is_exact_sum(b, s)) return s;
        }
    }
    return 0;
}

}  // namespace

const std::vector<scene::Case>& corpus() {
    static const std::vector<scene::Case> all = read_all();
    return all;
}

scene::Case swapped(const scene::Case& given) {
    scene::Case result = given;
    std::swap(result.a, result.b);
    std::swap(result.pose_a, result.pose_b);
    return result;
}

scene::Case reversed(const scene::Case& given) {
    scene::Case result = given;
    reverse(result.a);
    reverse(result.b);
    return result;
}

scene::Case scaled_by_power(const scene::Case& given, int exponent) {
    scene::Case result = given;
    scale(result.a, result.pose_a, std::ldexp(1.0, exponent));
    scale(result.b, result.pose_b, std::ldexp(1.0, exponent));
    return result;
}

scene::Case turned(const scene::Case& given, int turn) {
    const Mat3d rotation = quarter_turn(turn);
    scene::Case result = given;
    result.pose_a = turned(given.pose_a, rotation);
    result.pose_b = turned(given.pose_b, rotation);
    return result;
}

std::optional<scene::Case> moved_exactly(const scene::Case& given) {
    scene::Case result = given;
    Vec3d &a = result.pose_a.translation, &b = result.pose_b.translation;
    const double largest = std::max(max_abs(a), max_abs(b)), size = largest > 0 ? largest : 1;
    Vec3d shift;
    for (int i = 0; i < 3; ++i) shift[i] = exact_shift(a[i], b[i], size);
    if (shift.isZero(0)) return std::nullopt;
    a += shift;
    b += shift;
    return result;
}

}  // namespace edgewise
