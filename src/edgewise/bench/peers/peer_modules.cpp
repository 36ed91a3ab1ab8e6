// SPDX-License-Identifier: MIT
#include "edgewise/bench/peers/peer_modules.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::bench {

namespace {

constexpr std::string_view module_ending = ".so";

/// For good: what it says of itself lies in it. Its symbols, and those of its library, stay its own.
const peers::PeerInfo* open_module(const std::filesystem::path& file) {
    void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* symbol = module ? dlsym(module, peers::peer_symbol) : nullptr;
    if (!symbol) throw std::runtime_error(fmt::format("peer {}: {}", file.string(), dlerror()));
    return reinterpret_cast<peers::PeerFunction>(symbol)();
}

std::vector<const peers::PeerInfo*> open_all(const std::filesystem::path& folder) {
    std::vector<const peers::PeerInfo*> found;
    if (!std::filesystem::is_directory(folder)) return found;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == module_ending) found.push_back(open_module(entry.path()));
    }
    const auto key = [](const peers::PeerInfo* info) {
        return std::pair<std::string_view, std::string_view>(info->name, info->precision);
    };
    std::sort(found.begin(), found.end(), [&](auto* a, auto* b) { return key(a) < key(b); });
    return found;
}

TableType type_of(const peers::PeerInfo& info) {
    TableType type;
    type.is_peer = true;
    type.verdict_only = info.verdict_only;
    type.layout = info.name;
    type.precision = info.precision;
    type.name = type.layout + "_" + type.precision;
    type.stores = std::string(info.library) + ": " + info.summary;
    type.derives = fmt::format("a pair keeps {}; adapter compiled with {}", info.cache, info.flags);
    type.algorithms = {info.name};
    type.single_storage = type.precision != "f64";
    type.storage = type.single_storage ? "single" : "double";
    type.eps = type.precision == "f32" ? Tolerance<float>::eps : Tolerance<double>::eps;
    type.stored_body = [single = type.single_storage](const Polyhedron& body) {
        return single ? round_to_single(body) : Result<Polyhedron>::success(body);
    };
    type.make_runner = [&info](std::string_view) { return std::make_unique<PeerRunner>(info); };
    return type;
}

/// Bytes in use of glibc's allocator, which gives libraries their memory; headers and size classes
/// included.
std::size_t heap_in_use() {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

bool computes_in_single(const peers::PeerInfo& info) { return std::string_view(info.precision) == "f32"; }

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

std::filesystem::path folder_of_program() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

std::filesystem::path peers_folder() { return folder_of_program() / peers_folder_name(); }

/// Descriptions that the modules give, by name and precision.
std::span<const peers::PeerInfo* const> peers_found() {
    static const std::vector<const peers::PeerInfo*> found = open_all(peers_folder());
    return found;
}

std::filesystem::path default_build_file(const TableType& type, std::string_view algorithm) {
    return folder_of_program() / "default_builds" /
           fmt::format("{}_{}{}", algorithm, type.name, module_ending);
}

}  // namespace

bool has_default_build(const TableType& type, std::string_view algorithm) {
    return std::filesystem::exists(default_build_file(type, algorithm));
}

std::unique_ptr<Runner> make_default_build(const TableType& type, std::string_view algorithm) {
    return std::make_unique<PeerRunner>(*open_module(default_build_file(type, algorithm)));
}

std::span<const TableType> peer_types() {
    static const std::vector<TableType> types = [] {
        std::vector<TableType> result;
        for (const peers::PeerInfo* info : peers_found()) result.push_back(type_of(*info));
        return result;
    }();
    return types;
}

std::span<const AlgorithmInfo> peer_algorithms() {
    static const std::vector<AlgorithmInfo> algorithms = [] {
        std::vector<AlgorithmInfo> result;
        for (const peers::PeerInfo* info : peers_found()) {
            if (result.empty() || result.back().name != info->name)
                result.push_back(
                    {info->name, std::string(info->library) + ": " + info->summary, Parts::support});
        }
        return result;
    }();
    return algorithms;
}

std::vector<const TableType*> select_peer_types(std::span<const std::string> names) {
    if (names.empty()) return {};
    if (peer_types().empty()) {
        throw std::invalid_argument(fmt::format(
            "no peers are built: {} has no module; run layouts/sweep --peers", peers_folder().string()));
    }
    return select_types(peer_types(), names, "peer");
}

PeerRunner::PeerRunner(const peers::PeerInfo& info)
    : Runner(computes_in_single(info)), info_(info), bench_(info.make()) {}

NamedAnswer PeerRunner::answer(const scene::Query& given) const {
    const scene::Query query = prepared().prepared(given);
    NamedAnswer result;
    if (!in_range(query)) return result;
    const peers::PeerQuery asked = query_of(query);
    bench_->prepare(std::span(&asked, 1), 0, false);
    peers::PeerAnswer found;
    bench_->run(0, 1, &found);
    result.distance = to_world(distance_of(found, query.pose_a), query.pose_a);
    return prepared().scale().back(std::move(result));
}

Runner::RangePass PeerRunner::prepared_range() const {
    const scene::Workload& workload = prepared().workload();
    std::vector<peers::PeerQuery> asked;
    for (const scene::Query& query : workload.queries) asked.push_back(query_of(query));
    bench_->prepare(asked, workload.warm ? workload.pair_count : 0, options().needs == Needs::verdict);
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
    const double clock = measure::calibrate();
    BuildTimes times;
    for (int i = 0; i < repetitions; ++i) {
        bench->make_shapes({});  // the end of the last one is not timed
        const measure::Stopwatch watch;
        bench->make_shapes(std::span(&body, 1));
        times.build_ns.push_back(std::max(0.0, watch.elapsed_ns() - clock));
    }
    return times;
}

Result<Polyhedron> PeerRunner::store(const Polyhedron& body) const {
    const bool stores_double = std::string_view(info_.precision) == "f64";
    return stores_double ? Result<Polyhedron>::success(body) : round_to_single(body);
}

void PeerRunner::build_tables(const std::vector<const Polyhedron*>& bodies) {
    bench_->make_shapes(bodies);
    shapes_ = bodies.size();
}

peers::PeerQuery PeerRunner::query_of(const scene::Query& query) const {
    peers::PeerQuery result = {static_cast<std::uint32_t>(table_a(query)),
                               static_cast<std::uint32_t>(table_b(query)), query.pair, query.pose_a,
                               query.pose_b};
    if (!radii().empty()) {
        result.radius_a = radii()[query.instance_a];
        result.radius_b = radii()[query.instance_b];
    }
    return result;
}

}  // namespace edgewise::bench
