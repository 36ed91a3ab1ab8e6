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

struct lines {
    static constexpr std::string_view summary =
        "distinct cache lines a query touches in both tables, and bytes and reads it asks for";

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        measure::LineCounter counter;
        static_cast<void>(cell.runner.trace(measure::traced_queries, counter));
        return {figures(counter.sums(), cell.counts.told > 0)};
    }

    /// `may_be_none`: some queries were answered without a look at the tables, so that these may be all.
    [[nodiscard]] static std::vector<measure::Figure> figures(const measure::LinesTouched& touched,
                                                              bool may_be_none = false) {
        const auto mean = [&](const store::FigureName& name, std::uint64_t sum) {
            if (touched.queries == 0)
                return store::no_figure(name, "no query was traced", "ask for more queries");
            if (touched.reads == 0 && !may_be_none)
                return store::no_figure(name, "the layout does not tell its loader what it reads",
                                        "read through the loader");
            return store::mean_figure(name, sum, touched.queries);
        };
        return {mean("lines.lines_per_query", touched.lines),
                mean("lines.line_bytes_per_query", touched.lines * measure::cache_line),
                mean("lines.read_bytes_per_query", touched.bytes),
                mean("lines.reads_per_query", touched.reads)};
    }
};

}  // namespace edgewise::probes
