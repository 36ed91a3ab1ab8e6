// SPDX-License-Identifier: MIT
//
// How much work the groups of a sweep are, so that what is left can be estimated and shards
// be made even. A group is a scene on a shape with all its cells. Work is in seconds: the time that the same
// group took when it last ran into the store, else rules of thumb, whose ratios alone matter.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "edgewise/sweep/work.hpp"

namespace edgewise::sweep {

// What is left of a run, in seconds, from the speeds that this run has shown so far. Work is of several
// kinds, and each kind has a speed of its own. An estimate is either near or not given: it is withheld while
// groups of a kind have run at speeds too different, or too much of what is left is of a kind that has not
// run yet.

class TimeLeft {
  public:
    /// The kind of work whose expected seconds an earlier run measured.
    static constexpr const char* last_run = "last run";
    /// An estimate is given if the truth is probably within this factor of it.
    static constexpr double largest_factor = 1.5;

    /// Adds work of a kind that lies ahead, in seconds on any machine.
    void expect(const std::string& kind, double work) { kinds_[kind].ahead += work; }
    /// Notes that this work was done, and how many seconds it took.
    void done(const std::string& kind, double work, double seconds);
    /// Takes out work whose results an earlier run left.
    void skip(const std::string& kind, double work) { kinds_[kind].ahead -= work; }
    /// Ends a group of similar work. The spread between groups of a kind is the uncertainty of its speed.
    void end_group();

    /// Returns the estimate; nothing if none is near enough.
    [[nodiscard]] std::optional<double> seconds() const;

  private:
    /// Logarithms of seconds per work, weighted by the work.
    struct Speeds {
        double weight = 0, sum = 0, squares = 0, weight_squares = 0;

        void add(double work, double seconds);
        /// Their standard deviation; `at_first` counts as that of one group.
        [[nodiscard]] double deviation(double at_first) const;
    };
    struct Kind {
        double ahead = 0, work = 0, seconds = 0;   ///< work that is left and done; s
        double group_work = 0, group_seconds = 0;  ///< of the group in hand
        Speeds groups = {};                        ///< of groups that ended
    };

    std::map<std::string, Kind> kinds_;
};

/// What a group does in turn.
enum class Step {
    verify,  ///< tables built, every query answered, a sample checked exactly
    trace,   ///< caches modelled, on all processors
    rounds,  ///< timed
    alone    ///< counters, lines, and what else is measured cell by cell
};

inline constexpr Step steps[] = {Step::verify, Step::trace, Step::rounds, Step::alone};

struct GroupWork {
    std::array<double, 4> parts{};  ///< by Step
    bool remembered = false;        ///< an earlier run measured their sum
    bool own_tables = false;        ///< every body has one: queries wait for memory

    [[nodiscard]] double of(Step step) const { return parts[static_cast<std::size_t>(step)]; }
    [[nodiscard]] double all() const { return parts[0] + parts[1] + parts[2] + parts[3]; }
    /// Kind of work for TimeLeft.
    [[nodiscard]] std::string kind(Step step) const;
};

/// Number of cells of a group, and of its cells on tables of points alone, most of which queries read
/// completely.
struct CellCount {
    std::size_t all = 0, points = 0;
};
[[nodiscard]] CellCount count_cells(const SweepWork& work, const SceneWork& scene);

/// Work of a group by rules of thumb: queries by the root of the body's vertices, tables by its vertices.
/// A body that is missing has no work. `processors` share the traces.
[[nodiscard]] GroupWork estimated_work(const Plan& plan, const SceneWork& scene,
                                       const scene::NamedShape& shape, const CellCount& cells,
                                       unsigned processors = std::thread::hardware_concurrency());

/// Names a group in a store: scene, parameters, shape, queries, rounds, and how many cells.
[[nodiscard]] std::string group_key(const Plan& plan, const SceneWork& scene, const scene::NamedShape& shape,
                                    std::size_t cells);

/// Work of all groups, in the order in which they run. `took_before`: seconds by a group's key.
[[nodiscard]] std::vector<GroupWork> expected_work(
    const SweepWork& work, const std::function<std::optional<double>(const std::string& key)>& took_before);

}  // namespace edgewise::sweep
