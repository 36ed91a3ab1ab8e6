// SPDX-License-Identifier: MIT
//
// What the algorithm does inside: how often a warm query ends where it started, and of GJK how support points
// move from step to step, how far climbs go, at which subset the sub-distance algorithm ends, and whether it
// ends on V-Clip's features.
#pragma once

#include "edgewise/measure/probe.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class work final : public measure::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "work"; }
    [[nodiscard]] std::string_view summary() const override {
        return "unchanged answers; of GJK: support points kept, hops of a climb, subsets tried";
    }

    [[nodiscard]] std::vector<measure::Figure> figures(const measure::Subject& subject) const override {
        const measure::AlgorithmWork& inside = subject.work;
        std::vector<measure::Figure> all = {
            share("work.unchanged", subject.counts.unchanged, subject.counts.warm, "no query starts warm")};
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
    /// Part over whole, or why there is no such thing.
    static measure::Figure share(const store::FigureName& name, std::uint64_t part, std::uint64_t whole,
                                 const char* reason) {
        if (whole == 0) return store::no_figure(name, reason, "another scene");
        return store::figure(name, static_cast<double>(part) / static_cast<double>(whole));
    }
};

}  // namespace edgewise::probes
