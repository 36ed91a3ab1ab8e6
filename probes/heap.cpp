// SPDX-License-Identifier: MIT
#include "edgewise/probes/heap.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "edgewise/bench/memory/allocators.hpp"
#include "edgewise/bench/trace/trace_places.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise::probes {

namespace {

/// What `build` allocates; what it returns is kept until it was measured.
HeapStructure measured(const std::string& name,
                       const std::function<std::shared_ptr<const void>(bench::TableAllocator&)>& build) {
    const auto allocator = bench::make_allocator(bench::AllocatorKind::jemalloc);
    const std::shared_ptr<const void> kept = build(*allocator);
    const std::size_t classes = allocator->by_its_statistics().value_or(0);
    if (classes != allocator->taken())
        throw std::logic_error(name + ": jemalloc's statistics are not the sum of its size classes");
    return {name, allocator->requested(), classes, allocator->resident().value_or(0)};
}

/// Blocks of such sizes, written to as their owner would.
HeapStructure blocks(const std::string& name, const std::vector<std::size_t>& sizes) {
    return measured(name, [&](bench::TableAllocator& allocator) {
        auto owned = std::make_shared<std::vector<std::pmr::vector<std::byte>>>();
        for (const std::size_t size : sizes)
            if (size > 0) owned->emplace_back(size, std::byte{1}, &allocator);
        return owned;
    });
}

/// Boxes and orders for every body, pairs for the fullest frame.
std::vector<std::size_t> broad_phase_sizes(const scene::Workload& workload) {
    std::vector<std::size_t> sizes;
    for (const std::uint32_t element : bench::TracePlaces::element_bytes)
        sizes.push_back(element * workload.instances.size());
    std::size_t most_pairs = 0;
    for (std::size_t i = 0; i < workload.frames.size(); ++i) {
        const bool last = i + 1 == workload.frames.size();
        const std::size_t end = last ? workload.queries.size() : workload.frames[i + 1].first_query;
        most_pairs = std::max(most_pairs, end - workload.frames[i].first_query);
    }
    sizes.back() = bench::TracePlaces::element_bytes.back() * most_pairs;
    return sizes;
}

}  // namespace

HeapUse heap_of(const bench::ProbedCell& cell) {
    const scene::Workload& workload = cell.workload;
    HeapUse use;
    try {
        use.structures.push_back(measured("table", [&](bench::TableAllocator& allocator) {
            const TablesIn placed(allocator);
            return cell.type.make_table(cell.runner.stored_bodies()[0], cell.algorithm.parts);
        }));
        if (workload.warm)
            use.structures.push_back(blocks("pair_caches", {workload.pair_count * cell.runner.pair_bytes()}));
        if (!workload.frames.empty() && !workload.frames.front().boxes.empty())
            use.structures.push_back(blocks("broad_phase", broad_phase_sizes(workload)));
    } catch (const std::exception& problem) {
        use.structures.clear();
        use.reason = problem.what();
        use.remedy = bench::make_jemalloc() ? "see the reason"
                                            : "install libjemalloc-dev and build again, without sanitizers";
    }
    return use;
}

}  // namespace edgewise::probes
