// SPDX-License-Identifier: MIT
//
// The stability run: every hard family x algorithm x table type, judged by the exact oracle, with
// certificates and depths of some, and time against signed gap. Each result is a row of the store under the
// scene `stability`.
//
// The cases of one hard family for one kind of storage, and their exact answers. Tables that store the same
// values hold the same bodies, so one exact answer serves all of them.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/hard/families.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/sweep/shard.hpp"
#include "edgewise/truth/checked_answer.hpp"

namespace edgewise::studies {

// Counts and errors of one algorithm on one table type over the cases of one family.

/// Contact tolerances of the tolerance curve, relative to the scale of the pair.
inline constexpr std::array<double, 9> stability_tolerances = {0,    1e-16, 1e-14, 1e-12, 1e-10,
                                                               1e-8, 1e-6,  1e-5,  1e-3};

/// Bins of time against signed gap: edges of the gap divided by the scale.
inline constexpr std::array<double, 4> stability_gaps = {1e-9, 1e-6, 1e-3, 1e-1};

/// One checked answer.
struct StabilityAnswer {
    truth::CheckedAnswer checked;
    Distance answer;
    double exact_distance = 0;
};

/// One answer with depth and certificate.
struct StabilityProof {
    double depth_error = 0;  ///< over scale, beyond the band; 0 unless in contact
    bool depth_wrong = false;
    double certificate_width = 0;  ///< over scale; of the stored bodies
    /// True if the certificate, for the stored or for the given bodies, does not hold the exact distance, if
    /// the answer contradicts it, or if there was none.
    bool certificate_missed = false;
    bool depth_cut_short = false;  ///< EPA reached its face limit: the depth is an upper bound
};

class StabilityTally {
  public:
    StabilityTally();

    void add(const StabilityAnswer& asked);
    void add(const StabilityProof& proof);
    void add_refusal(std::size_t poses, const std::string& reason);
    /// Adds the time of one bin of gaps, e.g. "-1e-03", or the reason why there is none.
    void add_time(const std::string& bin, std::optional<double> ns, const std::string& none);

    [[nodiscard]] std::vector<measure::Figure> figures() const;
    /// Returns the errors; empty if there were answers and every answer was right.
    [[nodiscard]] std::string what_is_wrong() const;

  private:
    std::uint64_t& count(const store::FigureName& name) { return counts_.at(&name.info()); }
    [[nodiscard]] std::uint64_t counted(const store::FigureName& name) const {
        return counts_.at(&name.info());
    }
    void count_answer(const Distance& answer);
    void compare_with_control(const StabilityAnswer& asked);
    void note(const char* what, const StabilityAnswer& asked);

    std::map<const store::FigureInfo*, std::uint64_t>
        counts_;  ///< of each figure that counts queries or escapes
    std::uint64_t steps_ = 0;
    int max_steps_ = 0;
    std::array<std::size_t, stability_tolerances.size()> failures_{};
    std::vector<double> errors_, witness_errors_, depth_errors_, widths_;
    std::vector<measure::Figure> times_;
    std::string first_refusal_, first_wrong_;
};

/// Two bodies that could be built, and their poses. In a warm family the poses are in time order. Otherwise
/// they are the poses of all consecutive cases with the same two bodies.
struct StabilityCase {
    Polyhedron a, b;
    std::vector<std::pair<Pose, Pose>> poses;
};

struct StabilityPose {
    std::size_t index, pose;  ///< of the case, and of its poses
};

class StabilityCases {
  public:
    /// About `count` poses. `single`: for tables that store in single precision.
    StabilityCases(const scene::HardFamily& family, std::size_t count, std::uint64_t seed, bool single,
                   std::span<const Polyhedron> real);

    [[nodiscard]] const std::vector<StabilityCase>& all() const { return cases_; }
    [[nodiscard]] std::size_t refused() const { return refused_; }
    [[nodiscard]] const std::string& first_refusal() const { return first_refusal_; }

    /// Returns the exact answers for a pose between the two bodies that the tables hold: as given, or rounded
    /// to single.
    [[nodiscard]] truth::KnownPair& known(StabilityPose at) { return truth_of(at).pair; }
    [[nodiscard]] truth::PlacedBodies placed(StabilityPose at, std::span<const Polyhedron> stored) const {
        return {stored[0].vertices, poses_of(at).first, stored[1].vertices, poses_of(at).second};
    }
    /// Returns the verdict of the paper's control, in double on the same bodies; nothing if a body is flat.
    [[nodiscard]] std::optional<bool> control(StabilityPose at, std::span<const Polyhedron> stored);

  private:
    struct Truth {
        truth::KnownPair pair;
        std::optional<std::optional<bool>> control;
    };

    [[nodiscard]] Truth& truth_of(StabilityPose at) { return truths_[at.index][at.pose]; }
    [[nodiscard]] const std::pair<Pose, Pose>& poses_of(StabilityPose at) const {
        return cases_[at.index].poses[at.pose];
    }

    std::vector<StabilityCase> cases_;
    std::vector<std::vector<Truth>> truths_;
    std::size_t refused_ = 0;
    std::string first_refusal_;
};

/// `run` and scene of the rows.
inline constexpr const char* stability_run = "stability";

/// The family of real hulls, the one that asks for mesh files.
inline constexpr const char* real_family = "real_hulls_at_gaps";

/// Table type on which V-Clip is also checked raw.
inline constexpr const char* raw_type = "aos_f64";

struct StabilityPlan {
    std::vector<std::string> families;  ///< empty: all
    std::size_t count = 200;            ///< poses per family
    std::size_t proofs = 200;           ///< poses with depth, certificate and time, at most
    std::uint64_t seed = 1;
    std::vector<const bench::TableType*> types;
    std::vector<std::string> algorithms;
    bool raw = false;              ///< V-Clip without its fallback too, on table type raw_type
    std::vector<Polyhedron> real;  ///< for the family of real hulls; without any its rows are unavailable
};

/// Returns the number of rows of a plan.
[[nodiscard]] std::size_t stability_rows(const StabilityPlan& plan);

/// Runs the plan and writes its rows into the store, with the seconds of each family; rows that this build
/// wrote there before are not measured again. Returns false if it was stopped before its last row. `on_row`
/// is called with each row as soon as it is there. Throws std::invalid_argument that lists the known names
/// when a family is unknown.
[[nodiscard]] bool run_stability(const StabilityPlan& plan, store::Store& store,
                                 const std::function<void(const store::StoredCell&)>& on_row,
                                 const std::atomic<bool>& stop);

/// Keeps only the shard's families; returns false if it has none. `seconds`: as for sweep::keep_shard.
[[nodiscard]] bool keep_shard(StabilityPlan& plan, const sweep::Shard& shard,
                              const std::map<std::string, double>& seconds);

}  // namespace edgewise::studies
