// SPDX-License-Identifier: MIT
#include "edgewise/studies/table_memory_cost.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <stdexcept>

#include "edgewise/bench/memory/allocators.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise::studies {
namespace {

/// Sizes of spheres between the widths' limits: ring offsets count to 6 V - 12, neighbours to V.
struct WidthRange {
    int offset_bits, neighbour_bits;
    std::array<std::size_t, 3> vertices;
};
constexpr WidthRange width_ranges[] = {{8, 8, {8, 18, 38}},
                                       {16, 8, {56, 102, 218}},
                                       {16, 16, {386, 1538, 6146}},
                                       {32, 16, {24578, 38402, 60002}},
                                       {32, 32, {66152, 86402, 99848}}};

/// Built once: the largest take a second.
const Polyhedron& sphere(std::size_t vertices) {
    static std::map<std::size_t, Polyhedron> known;
    const auto found = known.find(vertices);
    if (found != known.end()) return found->second;
    return known.emplace(vertices, scene::make_shape(fmt::format("sphere{}", vertices)).or_throw())
        .first->second;
}

}  // namespace

std::vector<AllocatorCost> allocator_costs(const bench::TableType& type, const Polyhedron& body,
                                           Parts parts) {
    std::vector<AllocatorCost> costs;
    for (const bench::AllocatorInfo& info : bench::allocators_known()) {
        const auto kind = bench::allocator_from(info.name);
        if (kind == bench::AllocatorKind::file || kind == bench::AllocatorKind::memfd)
            continue;  // takes what the arena takes
        AllocatorCost& cost = costs.emplace_back();
        cost.allocator = info.name;
        try {
            const auto allocator = bench::make_allocator(*bench::allocator_from(info.name));
            const TablesIn placed(*allocator);
            const auto table = type.make_table(body, parts);
            cost.taken = allocator->taken();
            cost.by_statistics = allocator->by_its_statistics();
            cost.resident = allocator->resident();
        } catch (const std::runtime_error& missing) {
            cost.reason = missing.what();
        }
    }
    return costs;
}

Result<measure::LinesTouched> lines_in_tumble(const bench::TableType& type, const std::string& algorithm,
                                              const Polyhedron& body) {
    using Answer = Result<measure::LinesTouched>;
    const auto parameters = scene::complete_parameters("tumble", {{"rotation_step", 0.1}}).or_throw();
    const auto workload = scene::make_scene("tumble", body, parameters, 1, 4 * measure::traced_queries, {});
    if (!workload) return Answer::failure(workload.error);
    const auto runner = type.make_runner(algorithm);
    if (const std::string error = runner->load(*workload); !error.empty()) return Answer::failure(error);
    measure::LineCounter lines;
    runner->trace(measure::traced_queries, lines);
    const measure::LinesTouched& touched = lines.sums().warm;
    if (touched.queries == 0 || touched.reads == 0)
        return Answer::failure("no read was traced: the layout does not read through its loader");
    return Answer::success(touched);
}

std::vector<WidthSlope> slopes_by_width(const bench::TableType& type, Parts parts) {
    std::vector<WidthSlope> slopes;
    for (const WidthRange& range : width_ranges) {
        WidthSlope& slope = slopes.emplace_back(WidthSlope{
            range.offset_bits, range.neighbour_bits, range.vertices.front(), range.vertices.back(), {}, {}});
        std::vector<double> edges, bytes;
        for (const std::size_t vertices : range.vertices) {
            const auto stored = type.stored_body(sphere(vertices));
            if (!stored) {
                slope.reason = stored.error;
                continue;
            }
            edges.push_back(static_cast<double>(stored->edge_count()));
            bytes.push_back(static_cast<double>(type.ledger(*stored, parts).total()));
        }
        if (slope.reason.empty())  // three sizes make a line
            slope.bytes_per_edge = measure::least_squares(edges, bytes).value().slope;
    }
    return slopes;
}

}  // namespace edgewise::studies
