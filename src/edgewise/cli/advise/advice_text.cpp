// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "edgewise/cli/advise/advice.hpp"
#include "edgewise/cli/terminal/text_table.hpp"
#include "edgewise/scene/scenes.hpp"

namespace edgewise::cli {

namespace {

std::string bytes_text(double bytes) {
    if (bytes >= 1024 * 1024) return fmt::format("{:.1f} MiB", bytes / 1024 / 1024);
    return fmt::format("{:.1f} KiB", bytes / 1024);
}

std::string ratio_text(const Finalist& one) {
    return fmt::format("{:.2f} [{:.2f}, {:.2f}]", one.mid(), one.low(), one.high());
}

double tables_of(const Advice& advice) {
    const auto complete = scene::complete_parameters(advice.asked.scene.name, advice.asked.scene.parameters);
    return advice.asked.own_tables && complete && complete->contains("bodies") ? complete->at("bodies") : 1;
}

/// Label in a column of its own, the rest folded beside it.
std::string labelled(const std::string& label, const std::string& text) {
    constexpr std::size_t indent = 14;
    return fmt::format("  {:<11} {}\n", label, folded(text, widest_line - indent, indent));
}

std::string taken_text(const Advice& advice) {
    const Finalist& taken = advice.finals.ranked.front();
    const Finalist* paper = advice.finals.find("vclip", "aos_f64");
    const double tables = tables_of(advice);
    std::string bytes = fmt::format("{}; {:.1f} bytes per edge, {} in all", taken.name(),
                                    taken.bytes_per_edge, bytes_text(tables * taken.table_bytes));
    if (paper && paper != &taken)
        bytes += fmt::format(" (the paper's layout: {:.1f}, {})", paper->bytes_per_edge,
                             bytes_text(tables * paper->table_bytes));
    std::string text = labelled("take", bytes);
    const std::string noise = advice.finals.processes < 2
                                  ? "what that one differs by from process to process is not known"
                                  : fmt::format("that one beside itself: {:.2f} to {:.2f}",
                                                advice.finals.noise_low, advice.finals.noise_high);
    text +=
        labelled("time", fmt::format("{:.0f} ns per query here, {} of the paper's layout; processes: {}; {}",
                                     taken.ns, ratio_text(taken), advice.finals.processes, noise));
    text += labelled("error", fmt::format("{:.1e} of the pair's size (asked: {:.0e})", taken.error,
                                          advice.asked.error_limit));
    return text + labelled("why", fmt::format("{:.1f} steps and {:.1f} lines of 64 bytes per query",
                                              taken.steps, taken.lines));
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

/// Those that are out for their error, not for their time, which are many.
std::string out_text(const Advice& advice) {
    std::string text;
    for (const auto& cell : advice.screen.cells) {
        if (cell.out.empty() || cell.is_slow) continue;
        text +=
            (text.empty() ? "" : "; ") + fmt::format("{} ({:.0f} ns): {}", cell.name(), cell.ns, cell.out);
    }
    return text.empty() ? "" : labelled("out", text);
}

/// "29.5 / 0.0" per level.
std::string misses_text(const std::vector<double>& misses) {
    std::string text;
    for (const double level : misses) text += (text.empty() ? "" : " / ") + fmt::format("{:.1f}", level);
    return text;
}

std::string caches_text(const Advice& advice) {
    std::string text;
    const Finalist& taken = advice.finals.ranked.front();
    const Finalist* paper = advice.finals.find("vclip", "aos_f64");
    for (const auto& [machine, misses] : taken.misses) {
        std::string line =
            fmt::format("{} misses per query, level by level: {}", taken.table, misses_text(misses));
        if (paper && paper != &taken && paper->misses.contains(machine))
            line += fmt::format("; the paper's layout: {}", misses_text(paper->misses.at(machine)));
        if (machine != "host") line += "; modelled: time there was not measured";
        text += labelled("caches", machine + ": " + line);
    }
    return text;
}

std::string prediction_text(const Advice& advice) {
    const auto held = prediction_held(advice.finals);
    if (!held) return labelled("predicted", "nothing: this machine's caches are not known");
    const Finalist& best = advice.finals.fastest_predicted();
    std::string latencies;
    for (const double ns : advice.finals.latencies_ns)
        latencies += fmt::format("{}{:.0f}", latencies.empty() ? "" : ", ", ns);
    return labelled(
        "predicted",
        fmt::format("{} fastest, {:.0f} ns: {:.0f} ns in cache, and its modelled misses as long as they take "
                    "here ({} ns beyond the first level, nothing overlapping): {}",
                    best.name(), best.predicted_ns, best.in_cache_ns, latencies,
                    *held ? "held, it is among those that tie" : "did not hold"));
}

/// How sure the answer is, of the two questions that a reader has.
std::string certainty_text(const Advice& advice) {
    const Finalist& taken = advice.finals.ranked.front();
    const Finalist* paper = advice.finals.find("vclip", "aos_f64");
    if (advice.finals.processes < 2)
        return "no: one process alone, and what differs between processes is not known (--time)";
    std::string text;
    if (paper == &taken) {
        text = "the paper's layout is the fastest itself";
    } else {
        const bool beats = taken.high() < std::min(1.0, advice.finals.noise_low);
        text = fmt::format("that {} beats the paper's layout: {}", taken.table,
                           beats ? fmt::format("yes, in each of {} processes", advice.finals.processes)
                                 : "no, not by more than what that differs from itself");
    }
    const auto ties = std::ranges::count_if(advice.finals.ranked,
                                            [&](const Finalist& one) { return advice.finals.ties(one); });
    return text +
           (ties > 1 ? fmt::format("; which of the {} that tie: no", ties) : "; that it is the fastest: yes");
}

}  // namespace

std::vector<std::string> what_would_change(const Advice& advice) {
    std::vector<std::string> changes;
    const Finalist& taken = advice.finals.ranked.front();
    if (!advice.other_tables.empty()) {
        const auto& best = advice.other_tables.front();
        std::string text =
            fmt::format("{}: {}, {:.0f} ns at a first look",
                        advice.asked.own_tables ? "one table for all bodies" : "a table for each body",
                        best.name(), best.ns);
        for (const auto& cell : advice.other_tables)
            if (cell.type->name == taken.table && cell.algorithm == taken.algorithm && &cell != &best)
                text += fmt::format("; {} then takes {:.0f} ns", taken.table, cell.ns);
        if (std::ranges::none_of(advice.other_tables, [&](const auto& cell) {
                return cell.type->name == taken.table && cell.algorithm == taken.algorithm;
            }))
            text += fmt::format("; {} is then slower by a third at least", taken.name());
        changes.push_back(text);
    }
    for (const auto& cell : advice.screen.cells) {
        if (cell.error <= advice.asked.error_limit || cell.bytes_per_edge >= taken.bytes_per_edge) continue;
        changes.push_back(
            fmt::format("an error of {:.1e} allowed: {} becomes possible ({:.1f} bytes per edge, {:.0f} ns)",
                        cell.error, cell.name(), cell.bytes_per_edge, cell.ns));
        break;
    }
    if (taken.error > 0)
        changes.push_back(
            fmt::format("an error below {:.1e} asked for: {} goes out", taken.error, taken.name()));
    return changes;
}

std::string advise_command(const Advice& advice) {
    const auto complete = scene::complete_parameters(advice.asked.scene.name, advice.asked.scene.parameters);
    std::string text = "edgewise advise";
    if (!advice.asked.mesh.empty()) {
        text += " --mesh " + advice.asked.mesh;
    } else {
        text += fmt::format(" --vertices {}", advice.asked.shape.body.vertex_count());
    }
    if (complete && complete->contains("bodies")) text += fmt::format(" --bodies {}", complete->at("bodies"));
    if (complete && complete->contains("rotation_step"))
        text += fmt::format(" --turn {}", complete->at("rotation_step"));
    text += fmt::format(" {} --error {:.0e} --needs {}",
                        advice.asked.own_tables ? "--own-tables" : "--shared-tables",
                        advice.asked.error_limit, to_string(advice.asked.needs));
    if (!advice.machines.empty()) text += fmt::format(" --machine {}", fmt::join(advice.machines, ","));
    return text + fmt::format(" --seed {}", advice.asked.seed);
}

std::string advice_text(const Advice& advice) {
    std::string text = sentence_of(advice.asked) + "\n\n";
    for (const std::string& assumed : advice.assumed)
        text += labelled(&assumed == &advice.assumed.front() ? "assumed" : "", assumed);
    if (advice.finals.ranked.empty()) {
        text += labelled("take",
                         advice.finals.problem.empty() ? "nothing meets the error" : advice.finals.problem);
        return text + out_text(advice);
    }
    text += taken_text(advice) + next_text(advice) + out_text(advice) + caches_text(advice) +
            prediction_text(advice);
    text += labelled("sure?", certainty_text(advice));
    text += "  would change it\n";
    for (const std::string& change : what_would_change(advice)) text += labelled("", change);
    for (const std::string& left : advice.not_asked)
        text += labelled(&left == &advice.not_asked.front() ? "not asked" : "", left);
    return text + labelled("repeat", advise_command(advice)) + fmt::format("  ({:.0f} s)\n", advice.seconds);
}

}  // namespace edgewise::cli
