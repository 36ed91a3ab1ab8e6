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

std::string remaining(const ProgressState& state) {
    const std::size_t fresh = state.done - std::min(state.resumed, state.done);
    if (state.done >= state.total || fresh == 0) return {};
    const double each = state.seconds / static_cast<double>(fresh);
    return fmt::format("  {} left", format_duration(each * static_cast<double>(state.total - state.done)));
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
    const std::size_t percent = state.total == 0 ? 100 : done * 100 / state.total;
    const std::string head = plain(title) + " ";
    const std::string tail = fmt::format("{:3} %  {}/{}{}", percent, done, state.total, remaining(state));
    const std::size_t fixed = head.size() + tail.size();
    if (fixed > columns) return (head + tail).substr(0, columns);

    // "[" + cells + "] ": a bar of less than 8 cells says nothing.
    const std::size_t room = columns - fixed;
    const std::size_t cells = room >= 11 ? std::min<std::size_t>(room - 3, 24) : 0;
    if (cells == 0) return head + tail;
    const std::size_t filled = state.total == 0 ? cells : done * cells / state.total;
    const std::string bar = "[" + std::string(filled, '#') + std::string(cells - filled, '-') + "] ";
    const std::string line = head + bar + tail;
    const std::string rest = note.empty() ? "" : "  " + plain(note);
    return line + rest.substr(0, columns - line.size());
}

Progress::Progress(std::string title, std::size_t total, std::size_t resumed)
    : title_(std::move(title)), visible_(isatty(STDERR_FILENO) == 1) {
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

void Progress::clear() {
    if (!visible_) return;
    std::fprintf(stderr, "\r%*s\r", static_cast<int>(terminal_columns() - 1), "");
    std::fflush(stderr);
    next_draw_ = 0;
}

void Progress::draw() {
    if (!visible_) return;
    state_.seconds = watch_.elapsed_ns() * 1e-9;
    if (state_.seconds < next_draw_ && state_.done < state_.total) return;
    next_draw_ = state_.seconds + redraw_seconds;
    // Padded, so that a shorter line leaves nothing of a longer one.
    const std::size_t columns = terminal_columns() - 1;
    const std::string line = progress_line(title_, state_, note_, columns);
    std::fprintf(stderr, "\r%-*s", static_cast<int>(columns), line.c_str());
    std::fflush(stderr);
}

}  // namespace edgewise
