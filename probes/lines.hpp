// SPDX-License-Identifier: MIT
//
// Cache lines: the number of distinct lines of 64 bytes that a query reads of both tables, and the bytes of
// all its reads; cold and warm starts apart. Over the first queries of the scene. In a scene
// in time order, over the same number of pairs, followed through fifty steps or more. Padding may lower the
// first and raise the table's size: a cache pays for lines.
#pragma once

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class lines {
  public:
    static constexpr std::string_view summary =
        "distinct cache lines a query touches in both tables, and bytes and reads it asks for";

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        measure::LineCounter counter;
        static_cast<void>(
            cell.runner.trace(bench::sampled_extent(cell.workload, measure::traced_queries), counter));
        return {figures(counter.sums(), cell.counts.told > 0)};
    }

    /// `may_be_none`: some queries were answered without a look at the tables, so that these may be all.
    [[nodiscard]] static std::vector<measure::Figure> figures(
        const measure::ByStart<measure::LinesTouched>& touched, bool may_be_none = false) {
        using store::StartNames;
        constexpr StartNames bytes{"lines.line_bytes_per_query", "lines.line_bytes_per_query.{start}"},
            read{"lines.read_bytes_per_query", "lines.read_bytes_per_query.{start}"},
            reads{"lines.reads_per_query", "lines.reads_per_query.{start}"};
        const auto each = [&](const auto& of) {
            return measure::ByStart<std::uint64_t>{of(touched.all), of(touched.cold), of(touched.warm)};
        };
        using Sums = const measure::LinesTouched&;
        const auto queries = each([](Sums sums) { return sums.queries; });
        std::vector<measure::Figure> all;
        store::add_means(store::lines_read, each([](Sums sums) { return sums.lines; }), queries, all);
        store::add_means(bytes, each([](Sums sums) { return sums.lines * measure::cache_line; }), queries,
                         all);
        store::add_means(read, each([](Sums sums) { return sums.bytes; }), queries, all);
        store::add_means(reads, each([](Sums sums) { return sums.reads; }), queries, all);
        if (touched.all.queries == 0 || touched.all.reads > 0 || may_be_none) return all;
        for (measure::Figure& figure : all) {
            figure.value.reset();
            figure.reason = "the layout reads past its loader, which counts reads";
            figure.remedy = "read through the loader";
        }
        return all;
    }
};

}  // namespace edgewise::probes
