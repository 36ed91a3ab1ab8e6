// SPDX-License-Identifier: MIT
#include "edgewise/truth/filter/scanned_body.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <limits>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise::truth {

namespace {

/// Four numbers of four vertices: the compiler makes of it what the machine has. Its alignment depends on the
/// machine that is compiled for, so it is of this file alone.
typedef double Four __attribute__((vector_size(32)));
typedef std::int64_t FourPlaces __attribute__((vector_size(32)));

Four four_from(const double* numbers) {
    Four four;
    std::memcpy(&four, numbers, sizeof four);
    return four;
}

}  // namespace

ScannedBody::ScannedBody(std::span<const Vec3d> vertices)
    : vertices_(vertices), chosen_(vertices.size() + 1), extent_(edgewise::extent(vertices)) {
    assert(!vertices.empty());
    for (std::vector<double>* list : {&x_, &y_, &z_, &heights_}) list->resize((vertices.size() + 3) / 4 * 4);
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const Vec3d& v = vertices[i < vertices.size() ? i : 0];
        x_[i] = v.x();
        y_[i] = v.y();
        z_[i] = v.z();
    }
    for (const Vec3d& v : vertices) {
        reach_ = std::max(reach_, norm(v));
        centre_ += v / static_cast<double>(vertices.size());
    }
}

Highest ScannedBody::highest(const Vec3d& along) {
    const Four dx = along.x() - Four{}, dy = along.y() - Four{}, dz = along.z() - Four{};
    constexpr double none = -std::numeric_limits<double>::infinity();
    Four best = none - Four{};
    FourPlaces place{}, here{};  // per lane: where its first highest is
    for (std::size_t i = 0; i < heights_.size(); i += 4) {
        const Four height = dx * four_from(&x_[i]) + dy * four_from(&y_[i]) + dz * four_from(&z_[i]);
        std::memcpy(&heights_[i], &height, sizeof height);
        const FourPlaces higher = height > best;
        place = higher ? here : place;
        best = higher ? height : best;
        here += 1;
    }
    std::uint32_t first = 0;
    double height = none;
    for (std::size_t lane = 0; lane < 4; ++lane) {
        const auto vertex = static_cast<std::uint32_t>(4 * place[lane]) + static_cast<std::uint32_t>(lane);
        if (best[lane] > height || (best[lane] == height && vertex < first)) first = vertex;
        height = std::max(height, best[lane]);
    }
    if (height == none) return {0, std::numeric_limits<double>::quiet_NaN()};  // the direction was not finite
    return {first, height};
}

std::span<const std::uint32_t> ScannedBody::as_high_as(double height) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        chosen_[count] = static_cast<std::uint32_t>(i);
        count += heights_[i] >= height;
    }
    return std::span<const std::uint32_t>(chosen_).first(count);
}

}  // namespace edgewise::truth
