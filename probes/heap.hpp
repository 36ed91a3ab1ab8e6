// SPDX-License-Identifier: MIT
//
// Heap: what one table, the caches of all pairs and the broad phase's arrays take in jemalloc, each in an
// arena of its own. Slack is what size classes add to what was asked for.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <stdexcept>

#include "edgewise/bench/memory/allocators.hpp"
#include "edgewise/bench/probe.hpp"
#include "edgewise/bench/trace/trace_places.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise::probes {

class heap {
  public:
    static constexpr std::string_view summary =
        "one table, pair caches, broad phase in jemalloc: requested, size classes, slack, resident";

    /// Heap use of one newly built table of the first body, and of blocks with the sizes of the pairs' caches
    /// and of the broad phase's arrays.
    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        const scene::Workload& workload = cell.workload;
        Figures figures;
        try {
            add(figures, "table", [&](bench::TableAllocator& allocator) {
                const TablesIn placed(allocator);
                return cell.type.make_table(cell.runner.stored_bodies()[0], cell.algorithm.parts);
            });
            if (workload.warm)
                add_blocks(figures, "pair_caches", {workload.pair_count * cell.runner.pair_bytes()});
            if (!workload.frames.empty() && !workload.frames.front().boxes.empty())
                add_blocks(figures, "broad_phase", broad_phase_sizes(workload));
        } catch (const std::exception& problem) {
            const char* const remedy = bench::make_jemalloc()
                                           ? "see the reason"
                                           : "install libjemalloc-dev and build again, without sanitizers";
            return {{store::no_figure(store::FigureName("heap.{structure}.requested_bytes").of("table"),
                                      problem.what(), remedy)}};
        }
        return {figures};
    }

  private:
    using Figures = std::vector<measure::Figure>;

    /// Adds the figures of what `build` allocates. Its result is kept until it was measured.
    static void add(Figures& figures, const std::string& structure,
                    const std::function<std::shared_ptr<const void>(bench::TableAllocator&)>& build) {
        const auto allocator = bench::make_allocator(bench::AllocatorKind::jemalloc);
        const std::shared_ptr<const void> kept = build(*allocator);
        const std::size_t classes = allocator->by_its_statistics().value_or(0);
        if (classes != allocator->taken())
            throw std::logic_error(structure + ": jemalloc's statistics are not the sum of its size classes");
        const auto add_bytes = [&](const store::FigureName& name, std::size_t bytes) {
            figures.push_back(store::figure(name.of(structure), bytes));
        };
        add_bytes("heap.{structure}.requested_bytes", allocator->requested());
        add_bytes("heap.{structure}.size_class_bytes", classes);
        add_bytes("heap.{structure}.slack_bytes", classes - allocator->requested());
        // Includes the arena's own bookkeeping.
        add_bytes("heap.{structure}.resident_bytes", allocator->resident().value_or(0));
    }

    /// Adds one block per size in `sizes`. Every byte is written, as the owner of the block would do.
    static void add_blocks(Figures& figures, const std::string& structure,
                           const std::vector<std::size_t>& sizes) {
        add(figures, structure, [&](bench::TableAllocator& allocator) {
            auto owned = std::make_shared<std::vector<std::pmr::vector<std::byte>>>();
            for (const std::size_t size : sizes)
                if (size > 0) owned->emplace_back(size, std::byte{1}, &allocator);
            return owned;
        });
    }

    /// Boxes and orders for every body, pairs for the fullest frame.
    static std::vector<std::size_t> broad_phase_sizes(const scene::Workload& workload) {
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
};

}  // namespace edgewise::probes
