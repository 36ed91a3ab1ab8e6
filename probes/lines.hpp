// SPDX-License-Identifier: MIT
//
// Cache lines: how many distinct lines of 64 bytes a query reads of both tables, and what of their bytes it
// asked for, over the first queries of the scene (the first warm ones where pairs are followed). Padding may
// lower the first and raise the table's size: a cache pays for lines.
#pragma once

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class lines final : public bench::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "lines"; }
    [[nodiscard]] std::string_view summary() const override {
        return "distinct cache lines a query touches in both tables, and bytes and reads it asks for";
    }

    [[nodiscard]] bench::Findings measure(const bench::ProbedCell& cell) const override {
        measure::LineCounter counter;
        static_cast<void>(cell.runner.trace(measure::traced_queries, counter));
        return {figures(counter.sums())};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(const measure::LinesTouched& touched) {
        const auto mean = [&](const store::FigureName& name, double sum) {
            if (touched.queries == 0)
                return store::no_figure(name, "no query was traced", "ask for more queries");
            if (touched.reads == 0)
                return store::no_figure(name, "the layout does not tell its loader what it reads",
                                        "read through the loader");
            return store::figure(name, sum / static_cast<double>(touched.queries));
        };
        const auto touched_lines = static_cast<double>(touched.lines);
        return {mean("lines.lines_per_query", touched_lines),
                mean("lines.line_bytes_per_query", touched_lines * static_cast<double>(measure::cache_line)),
                mean("lines.read_bytes_per_query", static_cast<double>(touched.bytes)),
                mean("lines.reads_per_query", static_cast<double>(touched.reads))};
    }
};

}  // namespace edgewise::probes
