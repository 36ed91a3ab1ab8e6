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

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

/// A part of a table and what it takes.
struct ComponentBytes {
    std::string name;
    double bytes;
};

/// The bytes of one body's table, by component; sizes of a family are how slopes are measured.
struct TableBytes {
    std::uint64_t vertices = 0, edges = 0;
    std::vector<ComponentBytes> components;
    double paper_subtotal = 0;  ///< 0: this table stores no Voronoi planes
    double total = 0;
};

[[nodiscard]] TableBytes table_bytes(const Ledger& ledger, const Polyhedron& body);

/// Over a family of growing triangulated spheres: tables are really built, once for each table type and
/// parts.
[[nodiscard]] std::span<const TableBytes> size_family(const bench::TableType& type, Parts parts);

class bytes final : public bench::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "bytes"; }
    [[nodiscard]] std::string_view summary() const override {
        return "bytes per edge by component, total, and slopes per additional edge";
    }

    [[nodiscard]] bench::Findings measure(const bench::ProbedCell& cell) const override {
        return {figures(table_bytes(cell.runner.ledger(), cell.runner.stored_bodies()[0]),
                        size_family(cell.type, cell.algorithm.parts))};
    }

    /// sizes: the same table type over a family of triangulated bodies, growing.
    [[nodiscard]] static std::vector<measure::Figure> figures(const TableBytes& table,
                                                              std::span<const TableBytes> sizes) {
        const double edges = static_cast<double>(table.edges);
        std::vector<measure::Figure> result;
        for (const ComponentBytes& component : table.components) {
            result.push_back({component.name, component.bytes / edges, "B/edge"});
        }
        result.push_back(paper_slope(table, sizes));
        result.push_back(store::figure("bytes.total_bytes_per_edge", table.total / edges));
        result.push_back(slope("bytes.slope_bytes_per_edge", table, sizes, &TableBytes::total));
        result.push_back(store::figure("bytes.table_bytes", table.total));
        return result;
    }

  private:
    /// Which widths the rings of a triangulated body need: 6 V - 12 entries, of V vertices, in 8, 16 or 32
    /// bits each.
    static int widths_of(std::uint64_t vertices) {
        constexpr std::uint64_t limits[] = {44, 256, 10924, 65536};
        return static_cast<int>(std::lower_bound(std::begin(limits), std::end(limits), vertices) -
                                std::begin(limits));
    }
    static int widest(std::span<const TableBytes> sizes) {
        int most = 0;
        for (const TableBytes& of_size : sizes) most = std::max(most, widths_of(of_size.vertices));
        return most;
    }

    static measure::Figure paper_slope(const TableBytes& table, std::span<const TableBytes> sizes) {
        if (table.paper_subtotal > 0) {
            return slope("bytes.paper_bytes_per_edge", table, sizes, &TableBytes::paper_subtotal);
        }
        return store::no_figure("bytes.paper_bytes_per_edge", "this table stores no Voronoi planes",
                                "choose a layout and an algorithm that store them, such as aos with vclip");
    }

    static measure::Figure slope(const store::FigureName& name, const TableBytes& table,
                                 std::span<const TableBytes> sizes, double TableBytes::*quantity) {
        std::vector<double> edges, bytes;
        const int wanted = std::min(widths_of(table.vertices), widest(sizes));
        for (const TableBytes& of_size : sizes) {
            if (widths_of(of_size.vertices) != wanted) continue;
            edges.push_back(static_cast<double>(of_size.edges));
            bytes.push_back(of_size.*quantity);
        }
        const auto line = measure::least_squares(edges, bytes);
        if (line) return store::figure(name, line->slope);
        return store::no_figure(name, "no family of bodies to fit a slope over", "");
    }
};

}  // namespace edgewise::probes
