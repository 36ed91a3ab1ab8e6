// SPDX-License-Identifier: MIT
//
// What is left of a run, in seconds, from the speeds that this run has shown so far. Work is of several
// kinds, and each kind has a speed of its own. An estimate is either near or not given: it is withheld while
// groups of a kind have run at speeds too different, or too much of what is left is of a kind that has not
// run yet.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace edgewise::sweep {

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

}  // namespace edgewise::sweep
