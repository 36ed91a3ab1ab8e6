// SPDX-License-Identifier: MIT
//
// The figures of a small sweep that must be the same bytes in every run, environment and build: bytes,
// traces, modelled misses, reuse, heat, errors.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "program.hpp"
#include "sweep_store.hpp"

namespace edgewise::cli_test {

using Figures = std::vector<std::string>;

/// All such figures of a store.
[[nodiscard]] inline Figures deterministic_figures_in(const std::filesystem::path& store) {
    return rows_of(store,
                   "select scene, scene_parameters, shape, algorithm, table_type, probe, name, axes, "
                   "printf('%!.17g', value), unit, figure.reason from figure join cell using (build, hash) "
                   "where probe in ('bytes', 'lines', 'caches', 'reuse', 'heat', 'error', 'work') or name = "
                   "'requested_bytes' or (probe = 'stability' and name not like 'ns_at%') "
                   "order by 1, 2, 3, 4, 5, 6, 7, 8");
}

/// Figures of table types that every preset has: one per precision, and one per way to find a neighbour.
/// `environment`: further variables, NAME=VALUE.
[[nodiscard]] inline Figures deterministic_figures(const std::string& sweep_program,
                                                   const Arguments& environment, const Folder& folder) {
    Arguments arguments = environment;
    arguments.insert(arguments.end(), {sweep_program, "sweep",
                                       "--scenes",    "tumble,static,cold",
                                       "--shapes",    "sphere38",
                                       "--layouts",   "aos_mixed,lean_f32,points_soa_f64",
                                       "--queries",   "200",
                                       "--checked",   "20",
                                       "--rounds",    "1",
                                       "--caches",    "all",
                                       "--stability", "0",
                                       "--store",     "s.db",
                                       "--axes",      "sharing=per_instance,order=bfs"});
    arguments.emplace_back("--no-report");
    const Outcome outcome = Process("/usr/bin/env", arguments, folder).wait();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return deterministic_figures_in(folder / "s.db");
}

}  // namespace edgewise::cli_test
