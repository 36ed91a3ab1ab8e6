// SPDX-License-Identifier: MIT
//
// What the algorithm does inside: how often a warm query ends where it started, and of GJK how support points
// move from step to step, how far climbs go, at which subset the sub-distance algorithm ends, and whether it
// ends on V-Clip's features.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "edgewise/bench/probe.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

/// Inner work of Enhanced GJK, whatever the layout: how its support points move, how its sub-distance
/// algorithm ends, and where it ends compared with V-Clip.
struct AlgorithmWork {
    std::uint64_t queries = 0;  ///< observed; 0: none
    std::uint64_t supports = 0, hops = 0,
                  vertices = 0;  ///< calls that climbed; edges climbed; vertices visited
    /// Warm queries' vertices of the last simplex: all; in the one before; neighbours of one there.
    std::uint64_t kept_of = 0, kept = 0, near = 0;
    std::uint64_t sub_distances = 0, subsets_tried = 0;
    std::array<std::uint64_t, 4> accepted{};        ///< sub-distances by the size of the subset that held
    std::uint64_t compared = 0, same_features = 0;  ///< compared with V-Clip's
    std::string reason = "not observed", remedy;    ///< where queries is 0
};

/// Looks into Enhanced GJK at work on the workload; of the queries at the checked positions that are
/// separated some are compared with V-Clip's answers on this table type.
[[nodiscard]] AlgorithmWork gjk_work(const bench::TableType& type, const scene::Workload& workload,
                                     std::span<const std::size_t> checked_positions);

class work {
  public:
    static constexpr std::string_view summary =
        "unchanged answers, answers from bounds; of GJK: support points kept, hops of a climb, subsets tried";

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        return {figures(work_of(cell), cell.counts, cell.needs)};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(const AlgorithmWork& inside,
                                                              const bench::AnswerCounts& counts,
                                                              Needs needs = Needs::witnesses) {
        std::vector<measure::Figure> all = of_warm(counts, needs);
        if (inside.queries == 0) {
            all.push_back(store::no_figure("work.support_unchanged", inside.reason, inside.remedy));
            return all;
        }
        const char* const cold = "no query starts warm";
        const char* const scanned =
            "bodies this small, or all but flat at their edges, are scanned, not climbed";
        all.push_back(share("work.support_unchanged", inside.kept, inside.kept_of, cold));
        all.push_back(share("work.support_near", inside.near, inside.kept_of, cold));
        all.push_back(share("work.hops_per_support", inside.hops, inside.supports, scanned));
        all.push_back(share("work.vertices_per_support", inside.vertices, inside.supports, scanned));
        all.push_back(
            share("work.subsets_tried", inside.subsets_tried, inside.sub_distances, "none was asked"));
        for (std::size_t i = 0; i < inside.accepted.size(); ++i)
            all.push_back(share(store::FigureName("work.accepted_{number}").of(std::to_string(i + 1)),
                                inside.accepted[i], inside.sub_distances, "none was asked"));
        all.push_back(share("work.features_agree", inside.same_features, inside.compared,
                            "no checked query is separated, or the layout does not serve V-Clip"));
        return all;
    }

  private:
    /// Figures of warm queries: ended where they started, or decided by bounds and so without a start.
    [[nodiscard]] static std::vector<measure::Figure> of_warm(const bench::AnswerCounts& counts,
                                                              Needs needs) {
        const char* const cold = "no query starts warm";
        const store::FigureName unchanged("work.unchanged"), told("work.told_by_bounds");
        std::vector<measure::Figure> all = of_first(counts);
        if (has_margin(needs)) {
            all.push_back(store::no_figure(unchanged, "bounds answer most queries, which start nowhere",
                                           "a cell that needs more"));
            all.push_back(share(told, counts.told, counts.warm, cold));
        } else {
            all.push_back(share(unchanged, counts.unchanged, counts.warm, cold));
            all.push_back(store::no_figure(told, "no answer may come from bounds", "needs=nearer"));
        }
        return all;
    }

    /// How many queries are their pair's first, where pairs are followed.
    [[nodiscard]] static std::vector<measure::Figure> of_first(const bench::AnswerCounts& counts) {
        const store::FigureName first("work.first_queries"), share_of("work.first_share");
        if (!counts.follows_pairs || counts.queries == 0) {
            const char* const reason = "no pair is followed: every query starts cold";
            return {store::no_figure(first, reason, "another scene"),
                    store::no_figure(share_of, reason, "another scene")};
        }
        return {store::figure(first, counts.queries - counts.warm),
                store::mean_figure(share_of, counts.queries - counts.warm, counts.queries)};
    }

    /// The inner work does not depend on the layout, so it is observed for one layout.
    [[nodiscard]] static AlgorithmWork work_of(const bench::ProbedCell& cell) {
        AlgorithmWork work;
        if (!cell.verified) return work;
        if (!cell.plain) {
            work.reason = "measured for the cell without further axes";
        } else if (cell.algorithm.name != "gjk") {
            work.reason = "only GJK has support points and sub-distances";
        } else if (cell.type.name != "aos_f64") {
            work.reason = "the same for every layout: see aos_f64";
        } else {
            work = gjk_work(cell.type, cell.workload, cell.checked_positions);
        }
        return work;
    }

    /// Part divided by whole, or why there is no such thing.
    static measure::Figure share(const store::FigureName& name, std::uint64_t part, std::uint64_t whole,
                                 const char* reason) {
        if (whole == 0) return store::no_figure(name, reason, "another scene");
        return store::mean_figure(name, part, whole);
    }
};

}  // namespace edgewise::probes
