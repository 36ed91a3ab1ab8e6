// SPDX-License-Identifier: MIT
//
// The thrash on the machine that measured: what its own caches make of figures 7 and 8, in times.
#include <fmt/core.h>

#include <optional>

#include "edgewise/reports/paper/chapter/paper_thrash.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

constexpr double thrash_here_half_turn = 3.1415927;  ///< rad per step: no turn is less coherent

/// ns per query at half a turn per step; the table type with its axes.
std::optional<double> time_of(const ReportData& data, int vertices, const std::string& algorithm,
                              const std::string& table) {
    const StoredScene scene = scene_file(data, "paper_angular_" + std::to_string(vertices));
    const ReportCell* cell = nearest_cell(scene, algorithm, table, thrash_here_half_turn);
    return cell ? cell->figure("time.all_ns").value : std::nullopt;
}

/// "from 1.06 to 16.4 us, a factor of 15.5"; empty where a time is missing.
std::string thrash_here_growth(const ReportData& data, const std::string& algorithm,
                               const std::string& table) {
    const auto small = time_of(data, 38, algorithm, table), large = time_of(data, 386, algorithm, table);
    if (!small || !large) return {};
    return fmt::format("from {} to {} us, by a factor of {}", number_text(*small / 1000),
                       number_text(*large / 1000), number_text(*large / *small));
}

}  // namespace

std::string thrash_here(const ReportData& data) {
    const std::string own = thrash_here_growth(data, "vclip", "aos_f64");
    if (own.empty()) return "On this machine it was not timed: paper_angular_38 and _386 are not stored.";
    std::string out = fmt::format(
        "On this machine, where all tables fit in memory and only its caches can thrash, V-Clip on aos_f64 "
        "rises {} at half a turn per step when every body has a table of its own",
        own);
    const std::string shared = thrash_here_growth(data, "vclip", "aos_f64 sharing=shared"),
                      gjk = thrash_here_growth(data, "gjk", "aos_f64");
    if (!shared.empty()) out += fmt::format("; {} when all share one", shared);
    if (!gjk.empty()) out += fmt::format("; GJK, with tables of their own, {}", gjk);
    return out + ".";
}

}  // namespace edgewise::reports
