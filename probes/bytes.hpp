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

#include "edgewise/measure/probe.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class bytes final : public measure::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "bytes"; }
    [[nodiscard]] std::string_view summary() const override {
        return "bytes per edge by component, total, and slopes per additional edge";
    }

    [[nodiscard]] std::vector<measure::Figure> figures(const measure::Subject& subject) const override {
        const measure::TableBytes& table = subject.table;
        const double edges = static_cast<double>(table.edges);
        std::vector<measure::Figure> result;
        for (const measure::ComponentBytes& component : table.components) {
            result.push_back({component.name, component.bytes / edges, "B/edge"});
        }
        result.push_back(paper_slope(subject));
        result.push_back(store::figure("bytes.total_bytes_per_edge", table.total / edges));
        result.push_back(slope("bytes.slope_bytes_per_edge", subject, &measure::TableBytes::total));
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
    static int widest(const measure::Subject& subject) {
        int most = 0;
        for (const measure::TableBytes& table : subject.sizes)
            most = std::max(most, widths_of(table.vertices));
        return most;
    }

    static measure::Figure paper_slope(const measure::Subject& subject) {
        if (subject.table.paper_subtotal > 0) {
            return slope("bytes.paper_bytes_per_edge", subject, &measure::TableBytes::paper_subtotal);
        }
        return store::no_figure("bytes.paper_bytes_per_edge", "this table stores no Voronoi planes",
                                "choose a layout and an algorithm that store them, such as aos with vclip");
    }

    static measure::Figure slope(const store::FigureName& name, const measure::Subject& subject,
                                 double measure::TableBytes::*quantity) {
        std::vector<double> edges, sizes;
        const int wanted = std::min(widths_of(subject.table.vertices), widest(subject));
        for (const measure::TableBytes& table : subject.sizes) {
            if (widths_of(table.vertices) != wanted) continue;
            edges.push_back(static_cast<double>(table.edges));
            sizes.push_back(table.*quantity);
        }
        const auto line = measure::least_squares(edges, sizes);
        if (line) return store::figure(name, line->slope);
        return store::no_figure(name, "no family of bodies to fit a slope over", "");
    }
};

}  // namespace edgewise::probes
