// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "edgewise/cli/advise/advice.hpp"
#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::cli {

namespace {

using studies::advise::ScreenedCell;

// Parts of the time that the steps may take together.
constexpr double until_screened = 0.4, until_raced = 0.8;
constexpr std::size_t most_finalists = 5;

/// The fastest few, the paper's layout, and the best of the algorithm that is not among them.
std::vector<ScreenedCell> finalists_of(const studies::advise::Screen& screen) {
    std::vector<ScreenedCell> finalists;
    const auto add_first = [&](const auto& wanted) {
        for (const ScreenedCell& cell : screen.cells) {
            if (!wanted(cell)) continue;
            const auto known = std::ranges::find_if(finalists, [&](const ScreenedCell& other) {
                return other.type == cell.type && other.algorithm == cell.algorithm;
            });
            if (known == finalists.end()) finalists.push_back(cell);
            return;
        }
    };
    for (const ScreenedCell& cell : screen.cells)
        if (cell.out.empty() && finalists.size() < most_finalists) finalists.push_back(cell);
    if (finalists.empty()) return finalists;
    add_first(
        [](const ScreenedCell& cell) { return cell.algorithm == "vclip" && cell.type->name == "aos_f64"; });
    for (const char* algorithm : {"gjk", "vclip"})
        add_first([&](const ScreenedCell& cell) {
            return cell.algorithm == algorithm && (cell.out.empty() || cell.is_slow);
        });
    return finalists;
}

std::size_t count_out(const studies::advise::Screen& screen) {
    return static_cast<std::size_t>(
        std::ranges::count_if(screen.cells, [](const ScreenedCell& cell) { return !cell.out.empty(); }));
}

/// Of the case with its tables the other way, shorter than the first look.
void look_at_other_tables(Advice& advice, const std::function<bool()>& stop) {
    studies::advise::CaseAsked other = advice.asked;
    other.own_tables = !other.own_tables;
    const studies::advise::Screen screen =
        studies::advise::screen(other, {.queries = 1000, .checked = 20, .passes = 3}, stop);
    if (screen.stopped) {
        advice.not_asked.push_back(fmt::format("{}: no time was left for all of it (--time)",
                                               other.own_tables ? "a table each" : "one table for all"));
        return;
    }
    for (const ScreenedCell& cell : screen.cells)
        if (cell.out.empty()) advice.other_tables.push_back(cell);
}

}  // namespace

void measure_advice(Advice& advice, double seconds, const std::function<void(const std::string&)>& say) {
    const measure::Stopwatch watch;
    const auto elapsed = [&] { return watch.elapsed_ns() * 1e-9; };
    const auto past = [&](double part) { return [&, part] { return elapsed() > part * seconds; }; };
    advice.screen = studies::advise::screen(advice.asked, {}, past(until_screened));
    say(fmt::format("looked at {} cells, {} are out ({:.1f} s)", advice.screen.cells.size(),
                    count_out(advice.screen), elapsed()));
    if (advice.screen.stopped) advice.not_asked.emplace_back("some table types: no time was left (--time)");
    const std::vector<ScreenedCell> finalists = finalists_of(advice.screen);
    if (!finalists.empty()) {
        FinalsOptions options;
        options.machines = advice.machines;
        advice.finals = run_finals(advice.asked, finalists, options, past(until_raced));
        say(fmt::format("raced {} of them in {} processes ({:.1f} s)", advice.finals.ranked.size(),
                        advice.finals.processes, elapsed()));
        if (advice.finals.processes < options.processes)
            advice.not_asked.push_back(fmt::format("{} of {} processes: no time was left (--time)",
                                                   options.processes - advice.finals.processes,
                                                   options.processes));
    }
    if (can_share(advice.asked)) {
        look_at_other_tables(advice, past(1));
        say(fmt::format("looked at the case with {} ({:.1f} s)",
                        advice.asked.own_tables ? "one table for all" : "a table each", elapsed()));
    }
    // A body over the limit is no finalist; and those that were raced to be compared with may be over it,
    // too.
    std::erase_if(advice.finals.ranked, [&](const Finalist& one) {
        return one.error > advice.asked.error_limit && !(one.algorithm == "vclip" && one.table == "aos_f64");
    });
    advice.not_asked.emplace_back(
        "other velocities, other bodies; hardware counters (edgewise machine says which there are)");
    advice.seconds = elapsed();
}

std::optional<bool> prediction_held(const Finals& finals) {
    if (finals.ranked.empty() || finals.fastest_predicted().predicted_ns == 0) return std::nullopt;
    return finals.ties(finals.fastest_predicted());
}

}  // namespace edgewise::cli
