// SPDX-License-Identifier: MIT
//
// Exact reuse distances: how many misses a query has in a fully associative LRU cache of any size, at lines
// of 64 bytes and at pages of 4 KiB, in the steady pass; the knee, below which the scene thrashes
// (measure/cache/reuse_distance.hpp has the rule); and the working sets.
#pragma once

#include "edgewise/bench/probe.hpp"
#include "edgewise/bench/trace/trace_scene.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class reuse final : public bench::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "reuse"; }
    [[nodiscard]] std::string_view summary() const override {
        return "lines and pages: touched, working sets, misses in caches of every size, and the knee";
    }

    [[nodiscard]] bool beside_others() const override { return true; }

    [[nodiscard]] bench::Findings measure(const bench::ProbedCell& cell) const override {
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
        const auto bytes = static_cast<double>(unit.unit_bytes);
        const auto queries = static_cast<double>(trace.queries), tables = static_cast<double>(trace.tables);
        all.push_back(store::figure(names.per_query, static_cast<double>(unit.touched) / queries));
        all.push_back(store::figure(names.of_scene, static_cast<double>(unit.distinct)));
        all.push_back(store::figure(names.of_body, static_cast<double>(unit.of_tables) / tables));
        all.push_back(of_frame(trace, unit, names.of_frame));
        all.push_back(store::figure(
            names.knee, static_cast<double>(measure::knee(unit.steady, unit.with_scene)) * bytes));
        for (int power = least; power <= most; power += 1) {
            const std::uint64_t size = (std::uint64_t{1} << power) / unit.unit_bytes;
            all.push_back(store::figure(names.misses.of(std::to_string(power)),
                                        static_cast<double>(unit.steady.misses(size)) / queries));
        }
    }

    static measure::Figure of_frame(const measure::SceneTrace& trace, const measure::ReuseOf& unit,
                                    const store::FigureName& name) {
        if (trace.frames > 0)
            return store::figure(name,
                                 static_cast<double>(unit.in_frames) / static_cast<double>(trace.frames));
        return store::no_figure(name, "the scene is not asked frame after frame",
                                "tumble with in_time_order=1, or pressure");
    }
};

}  // namespace edgewise::probes
