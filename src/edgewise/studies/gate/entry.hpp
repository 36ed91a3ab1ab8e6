// SPDX-License-Identifier: MIT
//
// What a guard on speed keeps: ratios of times measured in the same rounds of one process, with what was
// measured, where, and by which build.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgewise::studies {

/// A median of rounds' ratios with its 95 % interval.
struct GateRatio {
    double value = 0, low = 0, high = 0;
};

/// What an entry's time is divided by.
enum class GateOver : std::uint8_t {
    reference,  ///< V-Clip on the paper's record, of the same scene and shape
    kernel,     ///< work that no change of the algorithms touches: the reference itself is held against it
};

struct GateEntry {
    std::string algorithm, table, scene, shape, axes;  ///< axes: "batch=yes", or empty
    GateOver over = GateOver::reference;
    GateRatio ratio;

    /// "gjk lean_f64 cold cube8 batch=yes".
    [[nodiscard]] std::string name() const;
};

/// What is measured in the same rounds, and divided by one reference: "cold cube8".
[[nodiscard]] std::string gate_group_name(const std::string& scene, const std::string& shape);

/// All of one run.
struct GateRecord {
    std::string machine;  ///< the processor's name
    std::string git_revision, compiler, flags, build_type;
    int rounds = 0;
    std::size_t queries = 0;  ///< per pass; ratios of other numbers are not comparable
    double slack = 0.1;       ///< by how much a ratio may grow
    std::vector<GateEntry> entries;
};

/// Of times and of what they are divided by, round by round. Null for fewer rounds than an interval takes
/// (measure::least_sample), or where a time is not positive.
[[nodiscard]] std::optional<GateRatio> gate_ratio(std::span<const double> times,
                                                  std::span<const double> beside);

}  // namespace edgewise::studies
