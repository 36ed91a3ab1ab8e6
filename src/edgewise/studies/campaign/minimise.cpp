// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/minimise.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <vector>

namespace edgewise::studies::campaign {

namespace {

/// Decimal digits that are tried, fewest first; 17 are all.
constexpr int digits_tried[] = {1, 2, 3, 4, 6, 9, 12};

double rounded_to(double x, int digits) {
    return std::strtod(fmt::format("{:.{}e}", x, digits - 1).c_str(), nullptr);
}

std::vector<double*> numbers_of(scene::Case& of) {
    std::vector<double*> numbers;
    for (scene::CaseBody* body : {&of.a, &of.b}) {
        for (Vec3d& v : body->vertices) {
            for (double& x : v) numbers.push_back(&x);
        }
    }
    for (Pose* pose : {&of.pose_a, &of.pose_b}) {
        for (double& x : pose->rotation.reshaped()) numbers.push_back(&x);
        for (double& x : pose->translation) numbers.push_back(&x);
    }
    return numbers;
}

class Minimiser {
  public:
    Minimiser(const scene::Case& given, const Fails& fails, std::size_t budget)
        : best_(given), fails_(fails), budget_(budget) {}

    scene::Case run() {
        // Faces name vertices by number: a case that needs them keeps them all.
        for (scene::CaseBody scene::Case::*body : {&scene::Case::a, &scene::Case::b}) {
            scene::Case without = best_;
            (without.*body).faces.reset();
            take_if_fails(without);
        }
        for (bool changed = true; changed && budget_ > 0;) {
            const bool fewer_of_a = drop_vertices(&scene::Case::a);
            const bool fewer_of_b = drop_vertices(&scene::Case::b);
            const bool plainer = plain_poses();
            changed = fewer_of_a || fewer_of_b || plainer || round_numbers();
        }
        return best_;
    }

  private:
    bool take_if_fails(const scene::Case& tried) {
        if (budget_ == 0) return false;
        --budget_;
        if (!fails_(tried)) return false;
        best_ = tried;
        return true;
    }

    /// Halves, quarters, ... down to single vertices.
    bool drop_vertices(scene::CaseBody scene::Case::*body) {
        bool changed = false;
        if ((best_.*body).faces) return false;
        for (std::size_t run = (best_.*body).vertices.size() / 2; run > 0; run /= 2) {
            for (std::size_t at = 0; at < (best_.*body).vertices.size();) {
                scene::Case tried = best_;
                std::vector<Vec3d>& vertices = (tried.*body).vertices;
                const std::size_t last = std::min(at + run, vertices.size());
                vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(at),
                               vertices.begin() + static_cast<std::ptrdiff_t>(last));
                const bool fewer = !vertices.empty() && take_if_fails(tried);
                changed |= fewer;
                if (!fewer) at += run;
            }
        }
        return changed;
    }

    bool plain_poses() {
        scene::Case relative = best_;
        const Transform<double> a_from_b = relative_pose(best_.pose_a, best_.pose_b);
        relative.pose_a = {};
        relative.pose_b = {a_from_b.rotation, a_from_b.translation};
        bool changed = !is_plain(best_.pose_a) && take_if_fails(relative);
        for (Pose scene::Case::*pose : {&scene::Case::pose_a, &scene::Case::pose_b}) {
            scene::Case upright = best_, at_origin = best_;
            (upright.*pose).rotation.setIdentity();
            if ((upright.*pose).rotation != (best_.*pose).rotation) changed |= take_if_fails(upright);
            at_origin = best_;
            (at_origin.*pose).translation.setZero();
            if ((at_origin.*pose).translation != (best_.*pose).translation)
                changed |= take_if_fails(at_origin);
        }
        return changed;
    }

    static bool is_plain(const Pose& pose) {
        return pose.rotation.isIdentity(0) && pose.translation.isZero(0);
    }

    /// All at once, then one by one.
    bool round_numbers() {
        bool changed = false;
        for (const int digits : digits_tried) {
            scene::Case tried = best_;
            bool rounds = false;
            for (double* x : numbers_of(tried)) rounds |= round(*x, digits);
            if (rounds && take_if_fails(tried)) return true;
        }
        const std::size_t count = numbers_of(best_).size();
        for (std::size_t i = 0; i < count; ++i) changed |= round_number(i);
        return changed;
    }

    bool round_number(std::size_t i) {
        for (const int digits : digits_tried) {
            scene::Case tried = best_;
            if (!round(*numbers_of(tried)[i], digits)) return false;  // has so few digits already
            if (take_if_fails(tried)) return true;
        }
        return false;
    }

    /// False if nothing changes.
    static bool round(double& x, int digits) {
        const double before = x;
        x = rounded_to(x, digits);
        return x != before;
    }

    scene::Case best_;
    const Fails& fails_;
    std::size_t budget_;
};

}  // namespace

scene::Case minimised(const scene::Case& given, const Fails& fails, std::size_t budget) {
    return Minimiser(given, fails, budget).run();
}

}  // namespace edgewise::studies::campaign
