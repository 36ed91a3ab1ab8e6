// SPDX-License-Identifier: MIT
#include "edgewise/bench/peers/peer_runner.hpp"

#include <malloc.h>

#include <string_view>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::bench {

namespace {

/// Bytes in use of glibc's allocator, which gives libraries their memory; headers and size classes
/// included.
std::size_t heap_in_use() {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

bool computes_in_single(const peers::PeerInfo& info) { return std::string_view(info.precision) == "f32"; }
bool stores_single(const peers::PeerInfo& info) { return std::string_view(info.precision) != "f64"; }

/// In A's frame, where Edgewise answers.
Distance distance_of(const peers::PeerAnswer& answer, const Pose& pose_a) {
    Distance result;
    if (!answer.answered) return result;
    result.status = answer.separated ? Status::separated : Status::touching;
    if (!answer.separated) return result;
    result.distance = answer.distance;
    result.point_a = multiply_transposed(pose_a.rotation, Vec3d(answer.point_a - pose_a.translation));
    result.point_b = multiply_transposed(pose_a.rotation, Vec3d(answer.point_b - pose_a.translation));
    const Vec3d offset = result.point_b - result.point_a;
    if (const double length = norm(offset); length > 0) result.normal = offset / length;
    return result;
}

}  // namespace

PeerRunner::PeerRunner(const peers::PeerInfo& info)
    : Runner(computes_in_single(info)), info_(info), bench_(info.make()) {}

NamedAnswer PeerRunner::answer(const scene::Query& given) const {
    const scene::Query query = prepared().prepared(given);
    NamedAnswer result;
    if (!in_range(query)) return result;
    const peers::PeerQuery asked = query_of(query);
    bench_->prepare(std::span(&asked, 1), 0);
    peers::PeerAnswer found;
    bench_->run(0, 1, &found);
    result.distance = to_world(distance_of(found, query.pose_a), query.pose_a);
    return prepared().scale().back(std::move(result));
}

Runner::RangePass PeerRunner::prepared_range() const {
    const scene::Workload& workload = prepared().workload();
    std::vector<peers::PeerQuery> asked;
    for (const scene::Query& query : workload.queries) asked.push_back(query_of(query));
    bench_->prepare(asked, workload.warm ? workload.pair_count : 0);
    return [this, &workload](std::size_t first, std::size_t last, Distance* answers) {
        if (first == 0) bench_->set_back();
        if (!answers) return bench_->run(first, last, nullptr);
        std::vector<peers::PeerAnswer> found(workload.queries.size());
        const double sum = bench_->run(first, last, found.data());
        for (std::size_t i = first; i < last; ++i)
            answers[i] = distance_of(found[i], workload.queries[i].pose_a);
        return sum;
    };
}

PassSum PeerRunner::trace(const TraceExtent&, measure::TraceListener&, Distance*) const { return {}; }

Ledger PeerRunner::ledger() const {
    // So many that what the allocator had kept for reuse, and counted as in use, is of no weight.
    constexpr std::size_t copies = 256;
    const std::vector<const Polyhedron*> bodies(copies, prepared().bodies().data());
    const std::unique_ptr<peers::PeerBench> bench(info_.make());
    const std::size_t before = heap_in_use();
    bench->make_shapes(bodies);
    const std::size_t each = (heap_in_use() - before) / copies;
    const std::size_t object = object_bytes() + sizeof(void*);  // and the bench's pointer to it
    Ledger ledger;
    ledger[Component::vertex_coordinates] = each > object ? each - object : 0;
    return ledger;
}

BuildTimes PeerRunner::build_times(int repetitions) const {
    const std::unique_ptr<peers::PeerBench> bench(info_.make());
    const Polyhedron* body = prepared().bodies().data();
    BuildTimes times;
    for (int i = 0; i < repetitions; ++i) {
        const measure::Stopwatch watch;
        bench->make_shapes(std::span(&body, 1));
        times.build_ns.push_back(watch.elapsed_ns());
    }
    return times;
}

Result<Polyhedron> PeerRunner::store(const Polyhedron& body) const {
    return stores_single(info_) ? round_to_single(body) : Result<Polyhedron>::success(body);
}

void PeerRunner::build_tables(const std::vector<const Polyhedron*>& bodies) {
    bench_->make_shapes(bodies);
    shapes_ = bodies.size();
}

peers::PeerQuery PeerRunner::query_of(const scene::Query& query) const {
    return {static_cast<std::uint32_t>(table_a(query)), static_cast<std::uint32_t>(table_b(query)),
            query.pair, query.pose_a, query.pose_b};
}

}  // namespace edgewise::bench
