// SPDX-License-Identifier: MIT
//
// Bytes per edge: every byte of the table by component, over the shape's edges; and the two slopes, per
// additional edge, fitted over a family of triangulated bodies: of the paper's subtotal (Voronoi planes,
// direction and length, vertex coordinates: 168 bytes in double precision, 84 in single) and of the whole
// table. Where indices are as narrow as the body allows, an edge of a larger body costs more: the slope is
// fitted over bodies that need the same widths as the shape does.
#pragma once

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

/// The bytes of one body's table; sizes of a family are how slopes are measured.
struct TableBytes {
    std::uint64_t vertices = 0, edges = 0;
    Ledger ledger;
    std::uint64_t object = 0, pair = 0;  ///< the table's object, and a pair's cache: the same for all sizes
};

/// Returns the bytes of tables of a family of growing triangulated spheres. Builds the tables, once for each
/// table type and parts.
[[nodiscard]] inline std::span<const TableBytes> size_family(const bench::TableType& type, Parts parts) {
    static const std::vector<Polyhedron> bodies = [] {
        std::vector<Polyhedron> spheres;
        for (const char* name : {"sphere8", "sphere18", "sphere38", "sphere66", "sphere102", "sphere218",
                                 "sphere386", "sphere1538"})
            spheres.push_back(scene::make_shape(name).or_throw());
        return spheres;
    }();
    static std::map<std::pair<std::string, Parts>, std::vector<TableBytes>> known;
    auto [place, is_new] = known.try_emplace({type.name, parts});
    if (is_new) {
        for (const Polyhedron& body : bodies) {
            const auto stored = type.stored_body(body);
            if (!stored) continue;  // too large for the layout
            place->second.push_back(
                {stored->vertex_count(), stored->edge_count(), type.ledger(*stored, parts)});
        }
    }
    return place->second;
}

class bytes {
  public:
    static constexpr std::string_view summary =
        "bytes per edge by component, total, and slopes per additional edge";

    static constexpr bool of_peers = true;

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        const Polyhedron& body = cell.runner.stored_bodies()[0];
        if (cell.type.is_peer) return {of_peer(body.edge_count(), cell.runner)};
        return {figures({body.vertex_count(), body.edge_count(), cell.runner.ledger(),
                         cell.runner.object_bytes(), cell.runner.pair_bytes()},
                        size_family(cell.type, cell.algorithm.parts))};
    }

    /// sizes: the same table type over a family of triangulated bodies, growing.
    [[nodiscard]] static std::vector<measure::Figure> figures(const TableBytes& table,
                                                              std::span<const TableBytes> sizes) {
        std::vector<measure::Figure> result = {
            paper_slope(table, sizes),
            store::mean_figure("bytes.total_bytes_per_edge", table.ledger.total(), table.edges),
            slope("bytes.slope_bytes_per_edge", table, sizes, &Ledger::total),
            store::figure("bytes.table_bytes", table.ledger.total()),
            store::figure("bytes.object_bytes", table.object),
            constant(table, sizes),
            store::figure("bytes.pair_bytes", table.pair)};
        for (std::size_t i = 0; i < component_names.size(); ++i) {
            const double bytes = static_cast<double>(table.ledger.bytes[i]);
            result.push_back(
                {std::string(component_names[i]), bytes / static_cast<double>(table.edges), "B/edge"});
        }
        return result;
    }

    /// Bytes of another library: a shape's allocations, its object, a pair's cache. It does not say what for.
    [[nodiscard]] static std::vector<measure::Figure> of_peer(std::size_t edges,
                                                              const bench::Runner& runner) {
        const std::uint64_t allocated = runner.ledger().total();
        return {store::mean_figure("bytes.total_bytes_per_edge", allocated, edges),
                store::figure("bytes.table_bytes", allocated),
                store::figure("bytes.object_bytes", runner.object_bytes()),
                store::figure("bytes.pair_bytes", runner.pair_bytes())};
    }

  private:
    /// Which widths the rings of a triangulated body need: 6 V - 12 entries, of V vertices, in 8, 16 or 32
    /// bits each.
    static int widths_of(std::uint64_t vertices) {
        constexpr std::uint64_t limits[] = {44, 256, 10924, 65536};
        return static_cast<int>(std::lower_bound(std::begin(limits), std::end(limits), vertices) -
                                std::begin(limits));
    }

    static measure::Figure paper_slope(const TableBytes& table, std::span<const TableBytes> sizes) {
        if (table.ledger.paper_subtotal() > 0)
            return slope("bytes.paper_bytes_per_edge", table, sizes, &Ledger::paper_subtotal);
        return store::no_figure("bytes.paper_bytes_per_edge", "this table stores no Voronoi planes",
                                "choose a layout and an algorithm that store them, such as aos with vclip");
    }

    static constexpr const char* no_family = "no family of bodies to fit a slope over";

    static measure::Figure slope(const store::FigureName& name, const TableBytes& table,
                                 std::span<const TableBytes> sizes, std::size_t (Ledger::*quantity)() const) {
        const auto line = fitted(table, sizes, quantity);
        return line ? store::figure(name, line->slope) : store::no_figure(name, no_family, "");
    }

    static measure::Figure constant(const TableBytes& table, std::span<const TableBytes> sizes) {
        const auto line = fitted(table, sizes, &Ledger::total);
        if (!line) return store::no_figure("bytes.constant_bytes", no_family, "");
        return store::figure("bytes.constant_bytes", line->intercept + static_cast<double>(table.object));
    }

    static std::optional<measure::Line> fitted(const TableBytes& table, std::span<const TableBytes> sizes,
                                               std::size_t (Ledger::*quantity)() const) {
        std::vector<double> edges, bytes;
        int widest = 0;
        for (const TableBytes& of_size : sizes) widest = std::max(widest, widths_of(of_size.vertices));
        const int wanted = std::min(widths_of(table.vertices), widest);
        for (const TableBytes& of_size : sizes) {
            if (widths_of(of_size.vertices) != wanted) continue;
            edges.push_back(static_cast<double>(of_size.edges));
            bytes.push_back(static_cast<double>((of_size.ledger.*quantity)()));
        }
        return measure::least_squares(edges, bytes);
    }
};

}  // namespace edgewise::probes
