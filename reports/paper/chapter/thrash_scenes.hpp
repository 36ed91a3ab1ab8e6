// SPDX-License-Identifier: MIT
//
// The scenes of the thrash at 386 vertices, and the caches and memories of 2001 that they are held against.
#pragma once

#include <array>
#include <string>

#include "edgewise/reports/paper/chapter/stored_scene.hpp"

namespace edgewise::reports {

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
/// Processors of the paper's time whose caches are modelled, with the size of each level (their descriptions
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
/// What its axis grows by, in nanoseconds.
inline constexpr double papers_growth_ns = 1.1e6;
/// A cause must give at least this share of that: the modelled processors may be ten times as fast as theirs.
inline constexpr double least_share = 0.1;
/// A page from a disk of the time, nanoseconds: a seek and half a turn, about 10 ms. So many faults per query
/// are that share of the growth.
inline constexpr double old_disk_ns = 1e7;
inline constexpr double least_faults = least_share * papers_growth_ns / old_disk_ns;
/// "Hundreds of such primitives": fewer than this.
inline constexpr double more_than_hundreds = 1000;

}  // namespace edgewise::reports
