// SPDX-License-Identifier: MIT
//
// Only \r and spaces, no escape sequences: works on every terminal. The last column stays free, since many
// terminals wrap as soon as it is written.
#include "edgewise/cli/terminal/progress.hpp"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace edgewise {

namespace {

constexpr double redraw_seconds = 0.1;
constexpr double log_seconds = 30;  ///< between lines where stderr is no terminal

/// Columns of the terminal on stderr; the customary 80 if it does not say.
std::size_t terminal_columns() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

/// Names of mesh files may hold anything: what is not printable ASCII would break the count of columns.
std::string plain(std::string text) {
    for (char& c : text) {
        if (c < ' ' || c > '~') c = '?';
    }
    return text;
}

/// Part of the steps that are done.
double share_done(const ProgressState& state) {
    if (state.total == 0) return 1;
    return static_cast<double>(std::min(state.done, state.total)) / static_cast<double>(state.total);
}

/// Nothing while there is no idea, and at the end.
std::optional<double> seconds_left(const ProgressState& state) {
    if (state.done >= state.total) return std::nullopt;
    if (!state.even) return state.left;
    if (state.done <= state.resumed) return std::nullopt;
    return state.seconds / static_cast<double>(state.done - state.resumed) *
           static_cast<double>(state.total - state.done);
}

std::string remaining(const ProgressState& state) {
    const auto seconds = seconds_left(state);
    return seconds ? fmt::format("  {} left", format_duration(*seconds)) : "";
}

}  // namespace

std::string format_duration(double seconds) {
    // Also what is not a number ends here, and no estimate beyond a month is worth its digits.
    const double limited = seconds > 0 ? std::min(seconds, 30.0 * 86'400) : 0;
    const auto whole = static_cast<long>(limited + 0.5);
    if (whole < 60) return fmt::format("{}s", whole);
    if (whole < 3600) return fmt::format("{}m{:02}s", whole / 60, whole % 60);
    return fmt::format("{}h{:02}m", whole / 3600, whole / 60 % 60);
}

std::string progress_line(const std::string& title, const ProgressState& state, const std::string& note,
                          std::size_t columns) {
    const std::size_t done = std::min(state.done, state.total);
    const bool all = state.done >= state.total;
    const std::size_t percent =
        all ? 100 : std::min<std::size_t>(99, static_cast<std::size_t>(share_done(state) * 100));
    const std::string head = plain(title) + " ";
    const std::string tail = fmt::format("{:3} %  {}/{}{}", percent, done, state.total, remaining(state));
    const std::size_t fixed = head.size() + tail.size();
    if (fixed > columns) return (head + tail).substr(0, columns);

    // "[" + cells + "] ": a bar of less than 8 cells says nothing.
    const std::size_t room = columns - fixed;
    const std::size_t cells = room >= 11 ? std::min<std::size_t>(room - 3, 24) : 0;
    if (cells == 0) return head + tail;
    const std::size_t filled =
        all ? cells
            : std::min(cells - 1, static_cast<std::size_t>(share_done(state) * static_cast<double>(cells)));
    const std::string bar = "[" + std::string(filled, '#') + std::string(cells - filled, '-') + "] ";
    const std::string line = head + bar + tail;
    const std::string rest = note.empty() ? "" : "  " + plain(note);
    return line + rest.substr(0, columns - line.size());
}

std::string progress_log_line(const std::string& title, const ProgressState& state,
                              const std::string& steps) {
    const auto seconds = seconds_left(state);
    std::string left;
    if (seconds) {
        const auto rounded = static_cast<long>(*seconds + 0.5);
        left = rounded < 90 ? fmt::format(", {} s left", rounded)
                            : fmt::format(", {} min left", (rounded + 30) / 60);
    }
    return fmt::format("{}: {} of {} {}{}", plain(title), state.done, state.total, steps, left);
}

Progress::Progress(std::string title, std::size_t total, std::size_t resumed, std::string steps, double quiet)
    : title_(std::move(title)),
      steps_(std::move(steps)),
      quiet_(quiet),
      next_log_(quiet > 0 ? quiet : log_seconds),
      visible_(isatty(STDERR_FILENO) == 1) {
    state_.total = total;
    state_.done = state_.resumed = std::min(resumed, total);
    draw();
}

Progress::~Progress() { clear(); }

void Progress::advance(std::size_t steps, const std::string& note) {
    state_.done = std::min(state_.done + steps, state_.total);
    note_ = note;
    draw();
}

void Progress::estimate_by(std::function<std::optional<double>()> left) {
    left_ = std::move(left);
    state_.even = false;
}

void Progress::clear() {
    if (!visible_ || watch_.elapsed_ns() * 1e-9 < quiet_) return;
    std::fprintf(stderr, "\r%*s\r", static_cast<int>(terminal_columns() - 1), "");
    std::fflush(stderr);
    next_draw_ = 0;
}

void Progress::draw() {
    state_.seconds = watch_.elapsed_ns() * 1e-9;
    if (state_.seconds < quiet_) return;
    if (!visible_) {
        if (state_.seconds < next_log_ || state_.done >= state_.total) return;
        next_log_ = state_.seconds + log_seconds;
        if (left_) state_.left = left_();
        fmt::print(stderr, "{}\n", progress_log_line(title_, state_, steps_));
        return;
    }
    if (state_.seconds < next_draw_ && state_.done < state_.total) return;
    next_draw_ = state_.seconds + redraw_seconds;
    if (left_) state_.left = left_();
    // Padded, so that a shorter line leaves nothing of a longer one.
    const std::size_t columns = terminal_columns() - 1;
    const std::string line = progress_line(title_, state_, note_, columns);
    std::fprintf(stderr, "\r%-*s", static_cast<int>(columns), line.c_str());
    std::fflush(stderr);
}

}  // namespace edgewise
