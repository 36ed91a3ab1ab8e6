// SPDX-License-Identifier: MIT
//
// Exact reuse distances: how many misses a query has in a fully associative LRU cache of any size, at lines
// of 64 bytes and at pages of 4 KiB, in the steady pass; the knee, below which the scene thrashes
// (measure/cache/reuse_distance.hpp has the rule), of queries that start cold and warm apart: a warm one's
// use of what a cold one brought in is its own; and the working sets.
#pragma once

#include <optional>
#include <string>

#include "edgewise/bench/probe.hpp"
#include "edgewise/bench/trace/trace_scene.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class reuse {
  public:
    static constexpr std::string_view summary =
        "lines and pages: touched, working sets, misses in caches of every size, and the knee";
    static constexpr bool beside_others = true;

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        return {figures(bench::scene_trace(cell))};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(const measure::SceneTrace& trace) {
        if (!trace.traced()) return {store::no_figure("reuse.line_knee_bytes", trace.reason, trace.remedy)};
        std::vector<measure::Figure> all;
        add_unit(trace, trace.lines, store::reuse_names[0], 10, 26, all);
        add_unit(trace, trace.pages, store::reuse_names[1], 14, 30, all);
        return all;
    }

  private:
    /// Caches of 2^least to 2^most bytes.
    static void add_unit(const measure::SceneTrace& trace, const measure::ReuseOf& unit,
                         const store::ReuseNames& names, int least, int most,
                         std::vector<measure::Figure>& all) {
        store::add_means(names.per_query, unit.touched, trace.queries, all);
        all.push_back(store::figure(names.of_scene, unit.distinct));
        all.push_back(store::mean_figure(names.of_body, unit.of_tables, trace.tables));
        all.push_back(trace.frames > 0 ? store::mean_figure(names.of_frame, unit.in_frames, trace.frames)
                                       : store::no_figure(names.of_frame, "no whole frame was followed",
                                                          "trace a frame or more of a scene that has frames: "
                                                          "tumble with in_time_order=1, or pressure"));
        const auto knee = [&](const measure::MissCurve& curve, std::uint64_t touched,
                              std::uint64_t queries) -> std::optional<double> {
            if (queries == 0) return std::nullopt;
            return static_cast<double>(measure::knee(curve, touched) * unit.unit_bytes);
        };
        store::add_values(names.knee,
                          {knee(unit.steady.all, unit.with_scene.all, trace.queries.all),
                           knee(unit.steady.cold, unit.with_scene.cold, trace.queries.cold),
                           knee(unit.steady.warm, unit.with_scene.warm, trace.queries.warm)},
                          all);
        for (int power = least; power <= most; power += 1) {
            const std::uint64_t size = (std::uint64_t{1} << power) / unit.unit_bytes;
            const std::string exponent = std::to_string(power);
            store::add_means(
                names.misses.of(exponent),
                {unit.steady.all.misses(size), unit.steady.cold.misses(size), unit.steady.warm.misses(size)},
                trace.queries, all);
        }
    }
};

}  // namespace edgewise::probes
