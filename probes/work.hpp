// SPDX-License-Identifier: MIT
//
// What the algorithm does inside: how often a warm query ends where it started, and of GJK how support points
// move from step to step, how far climbs go, at which subset the sub-distance algorithm ends, and whether it
// ends on V-Clip's features.
#pragma once

#include "edgewise/measure/probe.hpp"

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
            share("unchanged", subject.counts.unchanged, subject.counts.warm, "no query starts warm")};
        if (inside.queries == 0) {
            all.push_back({"support_unchanged", std::nullopt, "1", inside.reason, inside.remedy});
            return all;
        }
        const char* const cold = "no query starts warm";
        const char* const scanned =
            "bodies this small, or all but flat at their edges, are scanned, not climbed";
        all.push_back(share("support_unchanged", inside.kept, inside.kept_of, cold));
        all.push_back(share("support_near", inside.near, inside.kept_of, cold));
        all.push_back(share("hops_per_support", inside.hops, inside.supports, scanned));
        all.push_back(share("vertices_per_support", inside.vertices, inside.supports, scanned));
        all.push_back(share("subsets_tried", inside.subsets_tried, inside.sub_distances, "none was asked"));
        for (std::size_t i = 0; i < inside.accepted.size(); ++i)
            all.push_back(share("accepted_" + std::to_string(i + 1), inside.accepted[i], inside.sub_distances,
                                "none was asked"));
        all.push_back(share("features_agree", inside.same_features, inside.compared,
                            "no checked query is separated, or the layout does not serve V-Clip"));
        return all;
    }

  private:
    /// Part over whole, or why there is no such thing.
    static measure::Figure share(std::string name, std::uint64_t part, std::uint64_t whole,
                                 const char* reason) {
        if (whole == 0) return {std::move(name), std::nullopt, "1", reason, "another scene"};
        return {std::move(name), static_cast<double>(part) / static_cast<double>(whole), "1"};
    }
};

}  // namespace edgewise::probes
