// SPDX-License-Identifier: MIT
#include "edgewise/studies/phases/phases.hpp"

#include <cstddef>

namespace edgewise::studies {

namespace {

/// The first that fits counts. `place`: a file of src/edgewise, or all of a folder; `function`: its plain
/// name, or any.
struct Rule {
    std::string_view place, function;
    std::string_view phase;                     ///< empty: of whoever this is inlined into
    std::optional<Recurrence> recurrence = {};  ///< nothing: likewise
};

/// Their short names are for this table alone.
namespace phase_rules {

constexpr Recurrence once = Recurrence::once, step = Recurrence::step;

constexpr std::string_view scan = "support: scan", climb = "support: climb", sub_distance = "sub-distance",
                           gjk = "GJK: loop, duality gap", vclip = "V-Clip: loop, cycle guard",
                           start = "start", reads = "table: reads", pose = "poses", pair = "pair's memory",
                           answer = "answer: points, normal", trust = "answer: trust, fallback",
                           runner = "runner";

// clang-format off
constexpr Rule all[] = {
    {"", "operator", ""},  // a lambda's
    {"algorithms/support.hpp", "scan_support", scan},
    {"algorithms/support.hpp", "scan_packs", scan},
    {"algorithms/support.hpp", "highest", scan},
    {"algorithms/support.hpp", "first_equal", scan},
    {"geometry/pack.hpp", "", scan},
    {"algorithms/support.hpp", "cold_support", climb},
    {"algorithms/support.hpp", "", climb},
    {"algorithms/sub_distance.hpp", "", sub_distance},
    {"algorithms/cofactors.hpp", "", sub_distance},
    {"algorithms/johnson.hpp", "", sub_distance},
    {"algorithms/subset.hpp", "", sub_distance},
    {"algorithms/simplex.hpp", "", sub_distance},
    {"algorithms/gjk.hpp", "advance", gjk, step},
    {"algorithms/gjk.hpp", "run", gjk, step},
    {"algorithms/gjk_start.hpp", "support_from", ""},
    {"algorithms/gjk_start.hpp", "", start, once},
    {"algorithms/kept_simplex.hpp", "", start, once},
    {"algorithms/gjk.hpp", "finish", answer, once},
    {"algorithms/gjk.hpp", "gjk_answer", answer, once},
    {"algorithms/gjk.hpp", "separated_or_contact", answer, once},
    {"algorithms/gjk.hpp", "", gjk, once},
    {"algorithms/distance.hpp", "", answer, once},
    {"algorithms/answerable.hpp", "", pose, once},
    {"algorithms/query_options.hpp", "", answer, once},
    {"algorithms/vclip.hpp", "step", vclip, step},
    {"algorithms/vclip.hpp", "walk", vclip, step},
    {"algorithms/vclip.hpp", "answer", answer, once},
    {"algorithms/vclip.hpp", "", vclip, once},
    {"algorithms/vclip/cycle_guard.hpp", "", vclip},
    {"algorithms/vclip/vertex_vertex.hpp", "", "state V-V", step},
    {"algorithms/vclip/vertex_edge.hpp", "", "state V-E", step},
    {"algorithms/vclip/vertex_face.hpp", "", "state V-F", step},
    {"algorithms/vclip/edge_edge.hpp", "", "state E-E", step},
    {"algorithms/vclip/edge_face.hpp", "", "state E-F", step},
    {"algorithms/vclip/clip.hpp", "", ""},
    {"algorithms/vclip/body.hpp", "", ""},
    {"algorithms/vclip/nearer_start.hpp", "", start, once},
    {"algorithms/vclip/still_closest.hpp", "", trust, once},
    {"algorithms/vclip/closest_points.hpp", "", answer, once},
    {"algorithms/vclip/trust.hpp", "", trust, once},
    {"algorithms/vclip/fallback.hpp", "", trust, once},
    {"algorithms/vclip/feature_pair.hpp", "", pair, once},
    {"algorithms/simplex_pair.hpp", "", pair, once},
    {"algorithms/observer.hpp", "", ""},
    {"table/ring_questions.hpp", "", "ring scans", step},
    {"table/", "", ""},
    {"layouts/points_soa.hpp", "scan_support", scan},
    {"layouts/points_soa.hpp", "scan_packs", scan},
    {"layouts/points_soa.hpp", "scan_one_by_one", scan},
    {"layouts/points_soa.hpp", "heights_from", scan},
    {"layout_parts/seeds.hpp", "", start, once},
    {"layout_parts/derived/derived_planes.hpp", "vertex", reads},
    {"layout_parts/derived/derived_planes.hpp", "", "table: derived planes"},
    {"layout_parts/voronoi.hpp", "", "table: derived planes"},
    {"layout_parts/derived/derived_table.hpp", "", "table: derived planes"},
    {"layout_parts/derived/thin_corners.hpp", "", "table: derived planes"},
    {"layout_parts/narrow_rings.hpp", "", "table: rings"},
    {"layout_parts/rings.hpp", "", "table: rings"},
    {"layout_parts/derived/derived_half_edges.hpp", "", "table: derived edges, faces"},
    {"layout_parts/derived/derived_rings.hpp", "", "table: derived edges, faces"},
    {"layouts/", "", reads},
    {"layout_parts/", "", reads},
    {"geometry/pose.hpp", "", pose},
    {"geometry/", "", ""},
    {"bench/", "", runner, once},
    {"scene/", "", runner, once},
    {"cli/", "", runner, once},
};
// clang-format on

}  // namespace phase_rules

/// Returns the path within src/edgewise; nothing for other files, because they have no phase.
std::optional<std::string_view> own_file(std::string_view file) {
    constexpr std::string_view root = "src/edgewise/";
    const std::size_t at = file.rfind(root);
    return at == std::string_view::npos ? std::nullopt : std::optional(file.substr(at + root.size()));
}

const Rule* rule_of(std::string_view file, std::string_view function) {
    for (const Rule& rule : phase_rules::all) {
        const bool is_folder = rule.place.empty() || rule.place.ends_with('/');
        const bool here = is_folder ? file.starts_with(rule.place) : file == rule.place;
        if (here && (rule.function.empty() || rule.function == function)) return &rule;
    }
    return nullptr;
}

}  // namespace

PhaseOfFrames phase_of(const std::vector<measure::InlineFrame>& frames) {
    PhaseOfFrames found;
    for (const measure::InlineFrame& frame : frames) {
        const auto file = own_file(frame.file);
        if (!file && frame.file.starts_with("/")) continue;
        const Rule* rule = file ? rule_of(*file, frame.function) : nullptr;
        if (!rule) {
            if (found.phase) continue;
            found.phase = other_phase;
            found.place = file ? std::string(*file) : frame.function + ", without a line table";
            continue;
        }
        if (!found.phase && !rule->phase.empty()) found.phase = rule->phase;
        if (!found.recurrence) found.recurrence = rule->recurrence;
    }
    return found;
}

}  // namespace edgewise::studies
