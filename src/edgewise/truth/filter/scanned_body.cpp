// SPDX-License-Identifier: MIT
#include "edgewise/truth/filter/scanned_body.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise::truth {

ScannedBody::ScannedBody(std::span<const Vec3d> vertices)
    : vertices_(vertices), chosen_(vertices.size() + 1), extent_(edgewise::extent(vertices)) {
    assert(!vertices.empty());
    const std::size_t fours = (vertices.size() + 3) / 4;
    for (std::vector<Four>* list : {&x_, &y_, &z_, &heights_}) list->resize(fours);
    for (std::size_t i = 0; i < 4 * fours; ++i) {
        const Vec3d& v = vertices[i < vertices.size() ? i : 0];
        x_[i / 4][i % 4] = v.x();
        y_[i / 4][i % 4] = v.y();
        z_[i / 4][i % 4] = v.z();
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
    for (std::size_t i = 0; i < heights_.size(); ++i) {
        const Four height = dx * x_[i] + dy * y_[i] + dz * z_[i];
        heights_[i] = height;
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
        count += heights_[i / 4][i % 4] >= height;
    }
    return std::span<const std::uint32_t>(chosen_).first(count);
}

}  // namespace edgewise::truth
