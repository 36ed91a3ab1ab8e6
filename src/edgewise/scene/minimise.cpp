// SPDX-License-Identifier: MIT
#include "edgewise/scene/minimise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <vector>

namespace edgewise::scene {

namespace {

/// The number rounded to that many significant decimal digits.
double with_digits(double value, int digits) {
    return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
}

/// Number of significant digits of the shortest text that reads back the same.
std::size_t significant_digits(double value) {
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific).ptr;
    std::size_t digits = 0;
    for (const char* c = text; c != end && *c != 'e'; ++c) digits += *c >= '0' && *c <= '9';
    return value == 0 ? 0 : digits;
}

/// The numbers that may be rounded. Rotations are left out: a rounded one is no rotation any more.
std::vector<double*> numbers_of(Case& pair) {
    std::vector<double*> numbers;
    const auto add = [&](Vec3d& v) { numbers.insert(numbers.end(), {&v[0], &v[1], &v[2]}); };
    for (CaseBody* body : {&pair.a, &pair.b}) std::ranges::for_each(body->vertices, add);
    for (Pose* pose : {&pair.pose_a, &pair.pose_b}) add(pose->translation);
    return numbers;
}

class Search {
  public:
    Search(Case best, const StillFails& still_fails, std::size_t most)
        : best_(std::move(best)), still_fails_(still_fails), most_(most) {}

    Minimised run() {
        for (bool simpler = true; simpler && !at_limit();) {
            simpler = without_faces();
            simpler = simpler_poses() || simpler;
            simpler = fewer_vertices(&Case::a) || simpler;
            simpler = fewer_vertices(&Case::b) || simpler;
            simpler = rounder_numbers() || simpler;
        }
        return {best_, tried_, at_limit()};
    }

  private:
    [[nodiscard]] bool at_limit() const { return tried_ >= most_; }

    bool take_if_failing(Case candidate) {
        if (at_limit()) return false;
        ++tried_;
        if (!still_fails_(candidate)) return false;
        best_ = std::move(candidate);
        return true;
    }

    /// Tries hulls instead of the given faces, because faces name vertices that are to be removed.
    bool without_faces() {
        if (!best_.a.faces && !best_.b.faces) return false;
        Case candidate = best_;
        candidate.a.faces.reset();
        candidate.b.faces.reset();
        return take_if_failing(std::move(candidate));
    }

    /// Tries the pair as seen from A, then the identity for parts of each pose.
    bool simpler_poses() {
        bool simpler = seen_from_a();
        for (Pose Case::*pose : {&Case::pose_a, &Case::pose_b}) {
            Case candidate = best_;
            if (!(best_.*pose).rotation.isIdentity(0)) {
                (candidate.*pose).rotation.setIdentity();
                simpler = take_if_failing(candidate) || simpler;
            }
            candidate = best_;
            if (!(best_.*pose).translation.isZero(0)) {
                (candidate.*pose).translation.setZero();
                simpler = take_if_failing(candidate) || simpler;
            }
        }
        Case candidate = best_;
        candidate.pose_b.translation -= candidate.pose_a.translation;
        candidate.pose_a.translation.setZero();
        if (!best_.pose_a.translation.isZero(0)) simpler = take_if_failing(std::move(candidate)) || simpler;
        return simpler;
    }

    bool seen_from_a() {
        if (best_.pose_a.rotation.isIdentity(0) && best_.pose_a.translation.isZero(0)) return false;
        const Transform<double> b_in_a = relative_pose(best_.pose_a, best_.pose_b);
        Case candidate = best_;
        candidate.pose_a = {};
        candidate.pose_b = {b_in_a.rotation, b_in_a.translation};
        return take_if_failing(std::move(candidate));
    }

    /// ddmin: leaves out ever smaller runs of vertices. Not for a body with faces, which name vertices.
    bool fewer_vertices(CaseBody Case::*body) {
        if ((best_.*body).faces) return false;
        bool fewer = false;
        for (std::size_t run = (best_.*body).vertices.size() / 2; run > 0; run /= 2) {
            for (std::size_t first = 0; first < (best_.*body).vertices.size() && !at_limit();) {
                Case candidate = best_;
                std::vector<Vec3d>& vertices = (candidate.*body).vertices;
                if (vertices.size() <= 1) return fewer;
                const std::size_t last = std::min(first + run, vertices.size());
                if (last - first == vertices.size()) break;
                vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(first),
                               vertices.begin() + static_cast<std::ptrdiff_t>(last));
                if (take_if_failing(std::move(candidate))) {
                    fewer = true;
                } else {
                    first += run;
                }
            }
        }
        return fewer;
    }

    /// Rounds all numbers to fewer digits at once, then each by itself; the fewest digits are tried first.
    bool rounder_numbers() {
        bool rounder = false;
        for (int digits = 1; digits <= 12 && !rounder; ++digits) {
            Case candidate = best_;
            for (double* value : numbers_of(candidate)) *value = with_digits(*value, digits);
            if (size_of(candidate).digits < size_of(best_).digits)
                rounder = take_if_failing(std::move(candidate));
        }
        const std::size_t count = numbers_of(best_).size();
        for (std::size_t number = 0; number < count && !at_limit(); ++number)
            rounder = rounder_number(number) || rounder;
        return rounder;
    }

    bool rounder_number(std::size_t number) {
        const double value = *numbers_of(best_)[number];
        const std::size_t had = significant_digits(value);
        for (int digits = 0; digits < static_cast<int>(had); ++digits) {
            const double simpler = digits == 0 ? 0 : with_digits(value, digits);
            if (significant_digits(simpler) >= had) continue;
            Case candidate = best_;
            *numbers_of(candidate)[number] = simpler;
            if (take_if_failing(std::move(candidate))) return true;
        }
        return false;
    }

    Case best_;
    const StillFails& still_fails_;
    std::size_t most_, tried_ = 0;
};

}  // namespace

Minimised minimise(const Case& failing, const StillFails& still_fails, std::size_t most_tries) {
    return Search(failing, still_fails, most_tries).run();
}

CaseSize size_of(const Case& pair) {
    CaseSize size{pair.a.vertices.size() + pair.b.vertices.size(), 0};
    Case copy = pair;
    for (const double* value : numbers_of(copy)) size.digits += significant_digits(*value);
    return size;
}

}  // namespace edgewise::scene
