// SPDX-License-Identifier: MIT
//
// One algorithm on one table type over the cases of one family: asks, judges, proves and times.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "edgewise/bench/registry.hpp"
#include "edgewise/studies/stability_cases.hpp"
#include "edgewise/studies/stability_tally.hpp"

namespace edgewise::studies {

class StabilitySubject {
  public:
    /// `warm`: poses of a case keep the pair's cache. At most `proofs` poses get depth, certificate and time.
    StabilitySubject(const bench::TableType& type, const std::string& algorithm, bool warm,
                     StabilityCases& cases, std::size_t proofs)
        : type_(type),
          algorithm_(algorithm),
          runner_(type.make_runner(algorithm)),
          warm_(warm),
          cases_(cases),
          proofs_(proofs) {}

    /// Before it runs: as raw V-Clip.
    void make_raw() { runner_->configure({.query = {.hardened = false}}); }

    void run(StabilityTally& tally);

  private:
    void ask(std::size_t index, StabilityTally& tally);
    void check_pose(StabilityPose at, const Distance& answer, StabilityTally& tally);
    void prove_pose(StabilityPose at, StabilityTally& tally);
    [[nodiscard]] truth::CheckedAnswer checked(StabilityPose at, const truth::Claim& claim) const;
    [[nodiscard]] std::map<std::string, scene::Workload> by_gap();
    void time(StabilityTally& tally);
    [[nodiscard]] scene::Workload workload_of(std::size_t index) const;

    const bench::TableType& type_;
    std::string algorithm_;
    std::unique_ptr<bench::Runner> runner_;
    bool warm_;
    StabilityCases& cases_;
    std::size_t proofs_, proven_ = 0;
};

}  // namespace edgewise::studies
