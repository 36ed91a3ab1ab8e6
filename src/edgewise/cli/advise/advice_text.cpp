// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "edgewise/cli/advise/advice.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/studies/advise/changes.hpp"

namespace edgewise::cli {

namespace {

using reports::wrapped, reports::widest_line;
using studies::advise::Finalist;
using studies::advise::OutFor;

std::string bytes_text(double bytes) {
    if (bytes >= 1024 * 1024) return fmt::format("{:.1f} MiB", bytes / 1024 / 1024);
    return fmt::format("{:.1f} KiB", bytes / 1024);
}

std::string ratio_text(const Finalist& one) {
    return fmt::format("{:.2f} [{:.2f}, {:.2f}]", one.mid(), one.low(), one.high());
}

/// Of all tables of the case where it is known how many there are, else of one.
std::string table_bytes_text(const studies::advise::CaseAsked& asked, double table_bytes) {
    if (!can_share(asked)) return bytes_text(table_bytes) + " per table";
    const auto complete = scene::complete_parameters(asked.scene.name, asked.scene.parameters).or_throw();
    return bytes_text(asked.own_tables ? complete.at("bodies") * table_bytes : table_bytes) + " in all";
}

/// Label in a column of its own, the rest folded beside it.
std::string labelled(const std::string& label, const std::string& text) {
    constexpr std::size_t indent = 14;
    return fmt::format("  {:<11} {}\n", label, wrapped(text, widest_line - indent, indent));
}

/// The paper's layout; null where it is taken itself, or was not raced.
const Finalist* compared(const Advice& advice) {
    const Finalist* const paper = advice.finals.baseline();
    return paper == &advice.finals.ranked.front() ? nullptr : paper;
}

std::string taken_text(const Advice& advice) {
    const Finalist& taken = advice.finals.ranked.front();
    const Finalist* const paper = compared(advice);
    std::string bytes = fmt::format("{}; {:.1f} bytes per edge, {}", taken.name(), taken.bytes_per_edge,
                                    table_bytes_text(advice.asked, taken.table_bytes));
    if (paper)
        bytes += fmt::format(" (the paper's layout: {:.1f}, {})", paper->bytes_per_edge,
                             table_bytes_text(advice.asked, paper->table_bytes));
    const std::string noise = advice.finals.processes < 2
                                  ? "what that one differs by from process to process is not known"
                                  : fmt::format("that one beside itself: {:.2f} to {:.2f}",
                                                advice.finals.noise_low, advice.finals.noise_high);
    const std::string lines = taken.lines ? fmt::format(" and {:.1f} lines of 64 bytes", *taken.lines) : "";
    return labelled("take", bytes) +
           labelled("time",
                    fmt::format("{:.0f} ns per query here, {} of the paper's layout; processes: {}; {}",
                                taken.mid_ns(), ratio_text(taken), advice.finals.processes, noise)) +
           labelled("error", fmt::format("{:.1e} of the pair's size (asked: {})", taken.error,
                                         advice.asked.error_limit)) +
           labelled("why", fmt::format("{:.1f} steps{} per query", taken.steps, lines));
}

std::string next_text(const Advice& advice) {
    std::string text;
    for (const Finalist& one : advice.finals.ranked) {
        if (&one == &advice.finals.ranked.front()) continue;
        text += labelled(text.empty() ? "next" : "",
                         fmt::format("{}: {} of the paper's layout, {:.1f} bytes per edge, error {:.1e}{}",
                                     one.name(), ratio_text(one), one.bytes_per_edge, one.error,
                                     advice.finals.ties(one) ? ", a tie" : ""));
    }
    return text;
}

/// Those that are out for what they answer, not for their time, which are many.
std::string out_text(const Advice& advice) {
    std::vector<std::string> out;
    for (const auto& cell : advice.screen.cells)
        if (cell.out_for == OutFor::error || cell.out_for == OutFor::failure)
            out.push_back(cell.name() + ": " + cell.out);
    for (const Finalist& one : advice.finals.over_limit)
        if (!advice.screen.is_inexact(one.algorithm, one.table))
            out.push_back(fmt::format("{}: error {:.1e}, at a closer look", one.name(), one.error));
    return out.empty() ? "" : labelled("out", fmt::format("{}", fmt::join(out, "; ")));
}

/// "29.5 / 0.0" per level.
std::string misses_text(const std::vector<double>& misses) {
    std::vector<std::string> levels;
    for (const double level : misses) levels.push_back(fmt::format("{:.1f}", level));
    return fmt::format("{}", fmt::join(levels, " / "));
}

/// Beside the fastest there what is taken, where that is another.
std::string than_taken(const Finalist& best, const Finalist& taken, const std::string& machine) {
    if (&best == &taken || !taken.predicted_ns.contains(machine)) return "";
    return fmt::format(" ({}: {:.0f} ns)", taken.name(), taken.predicted_ns.at(machine));
}

/// Of each machine: the misses, and for another than this one, whose time is not measured, what is predicted.
std::string caches_text(const Advice& advice) {
    std::string text;
    const Finalist& taken = advice.finals.ranked.front();
    const Finalist* const paper = compared(advice);
    for (const auto& [machine, misses] : taken.misses) {
        std::string line = fmt::format("{}: {} misses per query, level by level: {}", machine, taken.table,
                                       misses_text(misses));
        if (paper && paper->misses.contains(machine))
            line += fmt::format("; the paper's layout: {}", misses_text(paper->misses.at(machine)));
        const Finalist* const best = advice.finals.fastest_predicted(machine);
        if (machine != studies::advise::this_machine && best)
            line += fmt::format(
                "; modelled, with every miss waited for as long as here, fastest is {}, "
                "{:.0f} ns{}; time there was not measured",
                best->name(), best->predicted_ns.at(machine), than_taken(*best, taken, machine));
        text += labelled("caches", line);
    }
    return text;
}

std::string prediction_text(const Advice& advice) {
    const Finalist* const best = advice.finals.fastest_predicted(studies::advise::this_machine);
    if (!best) return labelled("predicted", "nothing: this machine's caches or the misses are not known");
    std::vector<std::string> latencies;
    for (const double ns : advice.finals.latencies_ns) latencies.push_back(fmt::format("{:.0f}", ns));
    return labelled(
        "predicted",
        fmt::format("{} fastest, {:.0f} ns: {:.0f} ns in cache, and its modelled misses as long as they take "
                    "here ({} ns beyond the first level, nothing overlapping): {}",
                    best->name(), best->predicted_ns.at(studies::advise::this_machine), *best->in_cache_ns,
                    fmt::join(latencies, ", "),
                    *advice.finals.prediction_held() ? "held, it is among those that tie" : "did not hold"));
}

/// How sure the answer is, of the two questions that a reader has.
std::string certainty_text(const Advice& advice) {
    const Finalist& taken = advice.finals.ranked.front();
    if (advice.finals.processes < 2)
        return "no: one process alone, and what differs between processes is not known (--time)";
    std::string text = "the paper's layout is the fastest itself";
    if (compared(advice)) {
        const bool beats = taken.high() < std::min(1.0, advice.finals.noise_low);
        text = fmt::format("that {} beats the paper's layout: {}", taken.name(),
                           beats ? fmt::format("yes, in each of {} processes", advice.finals.processes)
                                 : "no, not by more than what that differs from itself");
    }
    const auto ties = std::ranges::count_if(advice.finals.ranked,
                                            [&](const Finalist& one) { return advice.finals.ties(one); });
    return text +
           (ties > 1 ? fmt::format("; which of the {} that tie: no", ties) : "; that it is the fastest: yes");
}

/// Where nothing was raced: why, and what the first look says.
std::string nothing_text(const Advice& advice) {
    const auto& cells = advice.screen.cells;
    if (cells.empty()) return "nothing: no time was left to look at any cell (--time)";
    if (!cells.front().is_in()) return "nothing: nothing meets the error";
    return fmt::format("nothing is sure: {}. At a first look {} is fastest, {:.0f} ns per query",
                       advice.finals.problem, cells.front().name(), cells.front().ns);
}

}  // namespace

std::string advice_text(const Advice& advice) {
    std::string text = sentence_of(advice.asked) + "\n\n";
    for (const std::string& dropped : advice.dropped)
        text += labelled(&dropped == &advice.dropped.front() ? "left out" : "", dropped);
    for (const std::string& assumed : advice.assumed)
        text += labelled(&assumed == &advice.assumed.front() ? "assumed" : "", assumed);
    if (advice.finals.ranked.empty()) {
        text += labelled("take", nothing_text(advice)) + out_text(advice);
    } else {
        text += taken_text(advice) + next_text(advice) + out_text(advice) + caches_text(advice) +
                prediction_text(advice) + labelled("sure?", certainty_text(advice)) + "  would change it\n";
        for (const std::string& change : what_would_change(advice.asked, advice.screen, advice.other_tables,
                                                           advice.finals.ranked.front()))
            text += labelled("", change);
    }
    for (const std::string& left : advice.not_asked)
        text += labelled(&left == &advice.not_asked.front() ? "not asked" : "", left);
    return text + labelled("repeat", advice.command) + fmt::format("  ({:.0f} s)\n", advice.seconds);
}

}  // namespace edgewise::cli
