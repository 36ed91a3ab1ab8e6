// SPDX-License-Identifier: MIT
//
// Heat: where accesses go by field, how few lines take most of them, and what of the tables' bytes, vertices,
// edges and faces the scene ever touched: what it needs, against what was modelled.
#pragma once

#include "edgewise/bench/probe.hpp"
#include "edgewise/bench/trace/trace_scene.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class heat {
  public:
    static constexpr std::string_view summary =
        "accesses by field, hottest lines, and the part of tables and features ever touched";
    static constexpr bool beside_others = true;

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        return {figures(bench::scene_trace(cell))};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(const measure::SceneTrace& trace) {
        if (!trace.traced()) return {store::no_figure("heat.touched_part", trace.reason, trace.remedy)};
        const measure::SceneHeat& found = trace.heat;
        const measure::TouchedTables& tables = found.tables;
        std::vector<measure::Figure> all = {
            store::mean_figure("heat.touched_part", tables.bytes, tables.of_bytes),
            store::figure("heat.touched_bytes", tables.bytes),
            store::figure("heat.lines_of_half_the_accesses", found.lines_of_half),
            store::figure("heat.lines_of_most_accesses", found.lines_of_most),
            store::figure("heat.lines", found.lines),
            feature("heat.touched_vertices", tables.vertices, "vertices"),
            feature("heat.touched_edges", tables.edges, "edges"),
            feature("heat.touched_faces", tables.faces, "faces")};
        for (const auto& [component, part] : tables.by_component)
            all.push_back(store::figure(store::FigureName("heat.touched_{component}").of(component), part));
        store::add_means({"heat.lines_of_query", "heat.lines_of_query.{start}"}, found.lines_of_queries,
                         found.queries, all);
        constexpr store::StartNames accesses{"heat.accesses.{field}", "heat.accesses.{field}.{start}"};
        for (std::size_t i = 0; i < trace.fields.size(); ++i) {
            if (found.by_field.all[i] == 0) continue;
            store::add_means(accesses.of(trace.fields[i]),
                             {found.by_field.all[i], found.by_field.cold[i], found.by_field.warm[i]},
                             found.queries, all);
        }
        return all;
    }

  private:
    static measure::Figure feature(const store::FigureName& name, const std::optional<double>& part,
                                   const std::string& features) {
        return store::figure(name, part, "the layout stores nothing for " + features + " one by one",
                             "a layout that does");
    }
};

}  // namespace edgewise::probes
