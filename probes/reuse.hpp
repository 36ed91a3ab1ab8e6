// SPDX-License-Identifier: MIT
//
// Exact reuse distances: how many misses a query has in a fully associative LRU cache of any size, at lines
// of 64 bytes and at pages of 4 KiB, in the steady pass; the knee, below which the scene thrashes
// (measure/cache/miss_curve.hpp has the rule); and the working sets.
#pragma once

#include "edgewise/measure/probe.hpp"

namespace edgewise::probes {

class reuse final : public measure::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "reuse"; }
    [[nodiscard]] std::string_view summary() const override {
        return "lines and pages: touched, working sets, misses in caches of every size, and the knee";
    }

    [[nodiscard]] std::vector<measure::Figure> figures(const measure::Subject& subject) const override {
        const measure::SceneTrace& trace = *subject.trace;
        if (!trace.traced()) return {{"line_knee_bytes", std::nullopt, "B", trace.reason, trace.remedy}};
        std::vector<measure::Figure> all;
        add_unit(trace, trace.lines, "line", 10, 26, all);
        add_unit(trace, trace.pages, "page", 14, 30, all);
        return all;
    }

  private:
    /// Caches of 2^least to 2^most bytes.
    static void add_unit(const measure::SceneTrace& trace, const measure::ReuseOf& unit,
                         const std::string& name, int least, int most, std::vector<measure::Figure>& all) {
        const auto bytes = static_cast<double>(unit.unit_bytes);
        const auto queries = static_cast<double>(trace.queries), tables = static_cast<double>(trace.tables);
        const std::string units = name + "s";
        all.push_back({units + "_per_query", static_cast<double>(unit.touched) / queries, units});
        all.push_back({units + "_of_scene", static_cast<double>(unit.distinct), units});
        all.push_back({units + "_of_body", static_cast<double>(unit.of_tables) / tables, units});
        all.push_back(of_frame(trace, unit, units));
        all.push_back({name + "_knee_bytes",
                       static_cast<double>(measure::knee(unit.steady, unit.with_scene)) * bytes, "B"});
        for (int power = least; power <= most; power += 1) {
            const std::uint64_t size = (std::uint64_t{1} << power) / unit.unit_bytes;
            all.push_back({name + "_misses_at_2^" + std::to_string(power),
                           static_cast<double>(unit.steady.misses(size)) / queries, "misses"});
        }
    }

    static measure::Figure of_frame(const measure::SceneTrace& trace, const measure::ReuseOf& unit,
                                    const std::string& units) {
        if (trace.frames > 0)
            return {units + "_of_frame",
                    static_cast<double>(unit.in_frames) / static_cast<double>(trace.frames), units};
        return {units + "_of_frame", std::nullopt, units, "the scene is not asked frame after frame",
                "tumble with in_time_order=1, or pressure"};
    }
};

}  // namespace edgewise::probes
