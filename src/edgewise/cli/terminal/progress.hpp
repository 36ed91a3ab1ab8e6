// SPDX-License-Identifier: MIT
//
// A progress bar with an estimate, for people: one line on stderr, rewritten in place; where stderr is no
// terminal, a line every 30 seconds.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "edgewise/measure/stopwatch.hpp"

namespace edgewise {

struct ProgressState {
    std::size_t done = 0, total = 0;
    std::size_t resumed = 0;  ///< of `done`, what an earlier run did; the estimate leaves it out
    double seconds = 0;       ///< since the start of this run
    bool even = true;         ///< steps take about the same time each, from which the time left is estimated
    std::optional<double> left = {};  ///< s, of steps that are not even; nothing where that is not known
};

/// One line of at most `columns` characters, without a line break; "" when there is no room for anything.
///     sweep [#########------------]  43 %  31/72  1m20s left  tumble sphere386
/// Parts that do not fit are left out: first the note, then the bar.
[[nodiscard]] std::string progress_line(const std::string& title, const ProgressState& state,
                                        const std::string& note, std::size_t columns);

/// One line for a log: "sweep: 434 of 1281 cells, 3 min left".
[[nodiscard]] std::string progress_log_line(const std::string& title, const ProgressState& state,
                                            const std::string& steps);

/// "42s", "3m05s", "2h07m".
[[nodiscard]] std::string format_duration(double seconds);

class Progress {
  public:
    /// `steps`: what these are called in a log. Work that is usually short shows nothing for `quiet` seconds.
    Progress(std::string title, std::size_t total, std::size_t resumed = 0, std::string steps = "steps",
             double quiet = 0);
    /// Wipes the line, so that what is printed next starts on a clean one.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Counts `steps` more as done; `note` says what comes next.
    void advance(std::size_t steps = 1, const std::string& note = {});

    /// For steps that differ in what they take: the seconds that are left, where they are known.
    void estimate_by(std::function<std::optional<double>()> left);
    /// Wipes the line; to be called before other output to the terminal.
    void clear();

  private:
    void draw();

    std::string title_, note_, steps_;
    ProgressState state_;
    std::function<std::optional<double>()> left_;
    measure::Stopwatch watch_;
    double quiet_;          ///< seconds
    double next_draw_ = 0;  ///< seconds; a terminal is slow, and drawing must not disturb what is measured
    double next_log_;       ///< likewise, where stderr is no terminal
    bool visible_ = false;
};

}  // namespace edgewise
