// SPDX-License-Identifier: MIT
#include "edgewise/bench/prepared_workload.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/geometry/vertex_order.hpp"

namespace edgewise::bench {

std::vector<std::uint8_t> cold_starts(const scene::Workload& workload) {
    std::vector<std::uint8_t> cold(workload.queries.size(), 0), met(workload.pair_count, 0);
    for (std::size_t i = 0; workload.warm && i < cold.size(); ++i) {
        std::uint8_t& known = met[workload.queries[i].pair];
        cold[i] = !known;
        known = 1;
    }
    return cold;
}

namespace {

/// Behind the queries from `first` on among which no pair comes again.
std::size_t end_of_different_pairs(const scene::Workload& workload, std::size_t first,
                                   std::vector<std::size_t>& asked_after) {
    std::size_t end = first;
    for (; end < workload.queries.size(); ++end) {
        std::size_t& asked = asked_after[workload.queries[end].pair];
        if (workload.warm && asked > first) break;
        asked = end + 1;
    }
    return end;
}

}  // namespace

ClassByClass::ClassByClass(const scene::Workload& given, std::span<const std::uint8_t> in_contact_as_given) {
    std::vector<std::size_t> order(given.queries.size()), asked_after(given.pair_count, 0);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t first = 0; first < order.size();) {
        const std::size_t end = end_of_different_pairs(given, first, asked_after);
        const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
        std::stable_partition(at(first), at(end), [&](std::size_t i) { return in_contact_as_given[i] == 0; });
        first = end;
    }
    workload.instances = given.instances;
    workload.pair_count = given.pair_count;
    workload.warm = given.warm;
    workload.table_each = given.table_each;
    for (const std::size_t i : order) {
        workload.queries.push_back(given.queries[i]);
        in_contact.push_back(in_contact_as_given[i]);
    }
}

std::string PreparedWorkload::take_bodies(std::span<const Polyhedron> bodies, VertexOrder order,
                                          const std::function<Result<Polyhedron>(const Polyhedron&)>& store) {
    bodies_.clear();
    unscaled_.clear();
    copy_ = {};
    given_ = nullptr;
    scale_ = LengthScale(bodies);
    for (const Polyhedron& body : bodies) {
        auto stored = store(scale_.into(body));
        if (stored) stored = reordered(*stored, order);
        if (!stored) return stored.error;
        if (!scale_.is_one()) unscaled_.push_back(scale_.back(*stored));
        bodies_.push_back(std::move(*stored));
    }
    return {};
}

void PreparedWorkload::take_queries(const scene::Workload& workload) {
    copy_ = {};
    given_ = &workload;
    const auto is_ready = [](const scene::Query& query) {
        return is_orthonormalised(query.pose_a) && is_orthonormalised(query.pose_b);
    };
    if (scale_.is_one() && std::all_of(workload.queries.begin(), workload.queries.end(), is_ready)) return;
    copy_.pair_count = workload.pair_count;
    copy_.warm = workload.warm;
    copy_.instances = workload.instances;
    copy_.frames = workload.frames;
    for (const scene::Query& query : workload.queries) copy_.queries.push_back(prepared(query));
    given_ = nullptr;
}

namespace {

/// A matrix that is no rotation becomes zero, with which every query fails: orthonormalised, it would be
/// another pose, and two scales may cancel each other out.
Pose ready(const Pose& pose, const Vec3d& about) {
    if (!(ortho_error(pose.rotation) <= sloppiest_rotation)) return {Mat3d::Zero(), pose.translation};
    return orthonormalised(pose, about);
}

}  // namespace

scene::Query PreparedWorkload::prepared(const scene::Query& given) const {
    scene::Query query = scale_.into(given);
    query.pose_a = ready(query.pose_a, bodies_[query.body_a].vertices[0]);
    query.pose_b = ready(query.pose_b, bodies_[query.body_b].vertices[0]);
    return query;
}

bool PreparedWorkload::in_range(const scene::Query& query, bool in_single) const {
    const double offset = max_abs(relative_pose(query.pose_a, query.pose_b).translation);
    const double size = std::max(offset, scale_.reach());
    return offset <= (in_single ? largest_coordinate_single : largest_coordinate) &&
           (size == 0 || size >= (in_single ? smallest_extent_single : smallest_extent));
}

}  // namespace edgewise::bench
