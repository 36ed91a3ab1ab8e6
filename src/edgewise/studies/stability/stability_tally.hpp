// SPDX-License-Identifier: MIT
//
// Counts and errors of one algorithm on one table type over the cases of one family.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/truth/checked_answer.hpp"

namespace edgewise::studies {

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
    struct Time {
        std::string bin;
        std::optional<double> ns;
        std::string none;  ///< why not
    };
    std::vector<Time> times_;
    std::string first_refusal_, first_wrong_;
};

}  // namespace edgewise::studies
