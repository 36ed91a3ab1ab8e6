// SPDX-License-Identifier: MIT
//
// Scenes that are files: what each varies, its cells, and their numbers. The store holds a scene's text as
// JSON under its name, and its numbers in every cell's scene parameters.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "edgewise/measure/expected.hpp"
#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

struct StoredScene {
    std::string name;    ///< "paper_angular_8"
    std::string varied;  ///< the number that it varies; empty: its cells differ in their shapes
    std::string note;    ///< what its author says of it
    std::vector<const ReportCell*> cells;

    /// Returns a cell's place on an axis: the varied number, else the vertices.
    [[nodiscard]] std::optional<double> place(const ReportCell& cell) const;
    [[nodiscard]] std::string axis_title() const;  ///< in words
};

/// All of them, by name; a text that is no JSON gives a scene that varies nothing.
[[nodiscard]] std::vector<StoredScene> scene_files(const ReportData& data);
/// One by its name; without cells when the store has none.
[[nodiscard]] StoredScene scene_file(const ReportData& data, const std::string& name);
/// The scenes that follow the paper, all that come along (reports/paper/scenes); a user's file has another
/// name.
inline constexpr std::string_view paper_scenes[] = {
    "paper_static",        "paper_linear_8",   "paper_bodies",      "paper_bodies_shrinking",
    "paper_angular_8",     "paper_angular_38", "paper_angular_386", "paper_proximity",
    "paper_complexity",    "paper_caching",    "paper_cold",        "paper_needs",
    "paper_thrash_8",      "paper_thrash_38",  "paper_thrash_386",  "paper_caches_here",
    "paper_seeds",         "paper_time_step",  "paper_body_count",  "paper_margin",
    "paper_static_margin", "paper_static_gap", "paper_tolerance"};
[[nodiscard]] bool is_of_paper(const std::string& scene);

/// A new random orientation each step: coherence's other end.
[[nodiscard]] inline bool has_random_orientation(const ReportCell& cell) {
    return parameter_of(cell, "random_orientation").value_or(0) != 0;
}
/// Returns the verified cell of this algorithm and table type that is nearest to a wanted place; null if
/// there is none.
[[nodiscard]] const ReportCell* nearest_cell(const StoredScene& scene, const std::string& algorithm,
                                             const std::string& table, double wanted);

// What the store knows of the thrash at 386 vertices: V-Clip on the paper's record (aos_f64), tables of its
// own for every body, against the caches and memories of 2001. The scenes, these caches and memories, and the
// rules that make a cause of it are here.

inline constexpr std::array<int, 3> thrash_vertices = {8, 38, 386};
[[nodiscard]] inline StoredScene thrash_scene(const ReportData& data, int vertices) {
    return scene_file(data, "paper_thrash_" + std::to_string(vertices));
}
/// The angle per step at which curves against the size of a cache are shown: the paper's fastest, 7 rad/s, at
/// 60 steps per second.
inline constexpr double thrash_step_angle = 7.0 / 60;

struct OldLevel {
    const char *machine, *level;
    const char* label;
};
/// Processors of the paper's time with modelled caches, and the size of each level (their descriptions
/// in measure/machines name the sources).
inline constexpr std::array<OldLevel, 4> old_levels = {
    {{"pentium3_coppermine", "L1D", "Pentium III L1D, 16 KiB"},
     {"pentium3_coppermine", "L2", "Pentium III L2, 256 KiB"},
     {"athlon_thunderbird", "L1D", "Athlon L1D, 64 KiB"},
     {"athlon_thunderbird", "L2", "Athlon L2, 256 KiB"}}};
inline constexpr std::array<const char*, 2> old_machines = {"pentium3_coppermine", "athlon_thunderbird"};

inline constexpr double old_cache = 256 * 1024.0;           ///< the second level of both, bytes
inline constexpr double least_old_memory = 64 * 1048576.0;  ///< of a machine of 2001, bytes
inline constexpr double most_old_memory = 256 * 1048576.0;

/// How much longer the paper's axis of time is for 386 vertices than for 38: 1.2e-3 s over 1e-4 s.
inline constexpr double papers_factor = 12;
/// Growth of the paper's axis from figure 7 to figure 8, in nanoseconds.
inline constexpr double papers_growth_ns = 1.1e6;
/// A cause must give at least this share of the growth: modelled processors may have ten times the speed.
inline constexpr double least_share = 0.1;
/// A page from a disk of the time, nanoseconds: a seek and half a turn, about 10 ms. `least_faults`
/// per query take that share of the growth.
inline constexpr double old_disk_ns = 1e7;
inline constexpr double least_faults = least_share * papers_growth_ns / old_disk_ns;
/// "Hundreds of such primitives": fewer than this.
inline constexpr double more_than_hundreds = 1000;

/// Cells of paper_thrash_N by angle per step, rising: one algorithm on one table type.
[[nodiscard]] std::vector<std::pair<double, const ReportCell*>> thrash_cells(const ReportData& data,
                                                                             int vertices,
                                                                             const std::string& algorithm,
                                                                             const std::string& table);
/// V-Clip on aos_f64: a figure at the slowest or the fastest rotation.
[[nodiscard]] measure::Expected<double> thrash_figure(const ReportData& data, int vertices, bool fastest,
                                                      const store::FigureName& name);
/// Returns a number of the scene at that rotation: "rotation_step", "bodies".
[[nodiscard]] measure::Expected<double> thrash_number(const ReportData& data, int vertices, bool fastest,
                                                      const std::string& name);
/// The larger of a figure at the slowest and at the fastest rotation.
[[nodiscard]] measure::Expected<double> worst_figure(const ReportData& data, int vertices,
                                                     const store::FigureName& name);
/// How many bodies it takes, in proportion, until the worst knee passes `bytes`.
[[nodiscard]] measure::Expected<double> bodies_to_fill(const ReportData& data, int vertices,
                                                       const store::FigureName& knee, double bytes);
/// Modelled memory time at 386 vertices over that at 38; infinite where 38 vertices never wait.
[[nodiscard]] measure::Expected<double> memory_factor(const ReportData& data, const std::string& machine,
                                                      bool fastest);

/// Returns true if the cache makes figure 8: on some machine, at some speed, the modelled memory time grows
/// by the paper's factor from 38 to 386 vertices, and by at least a tenth of the growth of the paper's axis.
/// Null when nothing was modelled.
[[nodiscard]] std::optional<bool> cache_is_a_cause(const ReportData& data);
/// Returns true if paging does: hundreds of bodies of 386 vertices use more pages than the smallest memory of
/// the time holds, and those of 38 do not; or with that memory and more they were measured to fault often
/// enough. Null when neither reuse distances of pages nor such a measurement are stored.
[[nodiscard]] std::optional<bool> paging_is_a_cause(const ReportData& data);

/// The figures of one limit of a paging row; null where the store has no value.
struct PagingLimit {
    measure::Figure limit, held, faults, predicted_at_held, predicted_at_limit, us;
};

/// Returns the limits in the order of the store's numbers, up to the first missing one.
[[nodiscard]] std::vector<PagingLimit> paging_limits(const ReportCell& row);

}  // namespace edgewise::reports
