// SPDX-License-Identifier: MIT
//
// The expected work of the groups of a sweep. It gives the estimate of the time left, and makes shards even.
// A group is a scene on a shape with all its cells. Work is in seconds: the time that the same group took
// when it last ran into the store, otherwise a rule of thumb. Only the ratios of rules of thumb matter.
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

// The time left of a run, in seconds, from the speeds that this run has shown so far. Work is of several
// kinds, and each kind has a speed of its own. An estimate is either near or not given: it is withheld while
// the groups of a kind ran at speeds that differ too much, or while too much of the work left is of a kind
// that has not run yet.

class TimeLeft {
  public:
    /// The kind of work with expected seconds that an earlier run measured.
    static constexpr const char* last_run = "last run";
    /// An estimate is given if the truth is probably within this factor of it.
    static constexpr double largest_factor = 1.5;

    /// Adds work of a kind that lies ahead, in seconds on any machine.
    void expect(const std::string& kind, double work) { kinds_[kind].ahead += work; }
    /// Notes that this work was done, and how many seconds it took.
    void done(const std::string& kind, double work, double seconds);
    /// Removes work that is already done, because an earlier run stored its results.
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

/// The steps of a group, in order.
enum class Step {
    verify,  ///< tables built, every query answered, a sample checked exactly
    trace,   ///< caches modelled, on all processors
    rounds,  ///< timed
    alone    ///< counters, lines, and all else that is measured cell by cell
};

inline constexpr Step steps[] = {Step::verify, Step::trace, Step::rounds, Step::alone};

struct GroupWork {
    std::array<double, 4> parts{};  ///< by Step
    bool remembered = false;        ///< an earlier run measured their sum
    bool own_tables = false;        ///< every body has its own table: queries wait for memory

    [[nodiscard]] double of(Step step) const { return parts[static_cast<std::size_t>(step)]; }
    [[nodiscard]] double all() const { return parts[0] + parts[1] + parts[2] + parts[3]; }
    /// Kind of work for TimeLeft.
    [[nodiscard]] std::string kind(Step step) const;
};

/// `all`: number of cells of a group. `points`: its cells on tables that hold points only; queries read most
/// such tables completely.
struct CellCount {
    std::size_t all = 0, points = 0;
};
[[nodiscard]] CellCount count_cells(const SweepWork& work, const SceneWork& scene);

/// Returns the work of a group by rules of thumb: a query costs the square root of the body's vertices, a
/// table the vertices. A missing body has no work. `processors`: number of processors that share the traces.
[[nodiscard]] GroupWork estimated_work(const Plan& plan, const SceneWork& scene,
                                       const scene::NamedShape& shape, const CellCount& cells,
                                       unsigned processors = std::thread::hardware_concurrency());

/// Returns the name of a group in a store: scene, parameters, shape, queries, rounds and number of cells.
[[nodiscard]] std::string group_key(const Plan& plan, const SceneWork& scene, const scene::NamedShape& shape,
                                    std::size_t cells);

/// Returns the work of all groups, in the order in which they run. `took_before`: seconds by a group's key.
[[nodiscard]] std::vector<GroupWork> expected_work(
    const SweepWork& work, const std::function<std::optional<double>(const std::string& key)>& took_before);

}  // namespace edgewise::sweep
