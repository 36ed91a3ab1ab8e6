// SPDX-License-Identifier: MIT
//
// A process of an advice's race: a sweep of this program over the raced cells' tables and algorithms, into a
// store of its own in a folder that goes with the race.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "edgewise/studies/advise/screen.hpp"

namespace edgewise::cli {

/// The scenes of such a sweep: the case, and few bodies that fit the cache.
inline constexpr const char *case_scene = "advise_case", *small_scene = "advise_in_cache";

/// Removed at the end with all that it holds.
class WorkFolder {
  public:
    WorkFolder();
    ~WorkFolder();
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;

    [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const nlohmann::json& json) const;

  private:
    std::filesystem::path path_;
};

struct RaceSweep {
    std::vector<std::string> tables, algorithms;  ///< every table with every algorithm that it serves
    std::vector<std::string> machines;            ///< to model the caches of
    std::size_t queries = 3000, checked = 100;
    int rounds = 0;
    bool times_in_cache = false, traces = false;  ///< in addition to timing the case
    std::string store;
};

/// Every table and algorithm of these cells.
[[nodiscard]] RaceSweep sweep_of(const std::vector<studies::advise::ScreenedCell>& cells);

/// Returns the command. It ends the process after this number of seconds.
[[nodiscard]] std::vector<std::string> command_of(const RaceSweep& sweep,
                                                  const studies::advise::CaseAsked& asked,
                                                  const WorkFolder& folder, double seconds);

}  // namespace edgewise::cli
