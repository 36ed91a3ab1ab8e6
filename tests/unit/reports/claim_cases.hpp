// SPDX-License-Identifier: MIT
//
// Made-up report data for claims: for each claim a number that decides it, and a store's figures made from
// that number.
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// The numbers that make a claim come out in each way; some have no interval that could straddle.
struct ClaimCase {
    std::string id;
    std::function<ReportData(double)> make;
    double reproduced, not_reproduced;
    std::optional<double> straddling = std::nullopt;
    bool identifiable = true;  ///< false: where the rule is met the claim is consistent, no more
};

[[nodiscard]] std::vector<ClaimCase> speed_cases();   ///< cost, performance, coherence, complexity
[[nodiscard]] std::vector<ClaimCase> count_cases();   ///< scalability, robustness, ease, algorithms
[[nodiscard]] std::vector<ClaimCase> memory_cases();  ///< memory, thrash, paging

/// "probe.name" and a value.
using MadeFigures = std::vector<std::pair<std::string, double>>;

struct MadeCell {
    std::string scene, shape, algorithm;
    std::string parameter = {};  ///< of the scene, with its number
    double x = 0;
    std::string table = "aos_f64";
};

[[nodiscard]] ReportCell make_cell(const MadeCell& made, const MadeFigures& figures);
inline void add_cell(ReportData& data, const MadeCell& made, const MadeFigures& figures) {
    data.from_files.push_back(make_cell(made, figures));
}

/// Nanoseconds per query, with an interval of two per cent each way.
[[nodiscard]] MadeFigures made_time(double ns);

/// Radians per step: some in the range of every figure, at both readings of the time step.
inline constexpr double made_steps[] = {0, 1.0 / 60, 3.0 / 60, 7.0 / 60, 0.5, 1, 2, 3.1415927, 6.2831853};
/// One of the paper's scenes of turning bodies: figures by number of the step, from 0.
void add_angular(ReportData& data, int vertices, const std::string& algorithm,
                 const std::function<MadeFigures(int)>& figures);
/// All at the same time.
void add_angular_time(ReportData& data, int vertices, const std::string& algorithm, double ns);

inline const std::vector<std::string> both_algorithms = {"vclip", "gjk"};
[[nodiscard]] std::string made_shape(int vertices);

}  // namespace edgewise::reports
