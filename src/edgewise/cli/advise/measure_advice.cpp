// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "edgewise/cli/advise/advice.hpp"
#include "edgewise/cli/advise/race.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/studies/advise/race_plan.hpp"

namespace edgewise::cli {

namespace {

using studies::advise::DroppedFor;
using studies::advise::Screen;
using studies::advise::ScreenedCell;
using studies::advise::TimeLimit;

// Parts of the time at which the first look and the race have to be over.
constexpr double until_screened = 0.4, until_raced = 0.8;
constexpr double until_screened_for_machines = 0.3;  ///< where machines were named, which the race models
constexpr std::size_t most_raced = 5;

/// The fastest few, the baseline, and the best of the algorithm that is not among them.
std::vector<ScreenedCell> cells_to_race(const Screen& screen) {
    std::vector<ScreenedCell> raced;
    const auto add_first = [&](const auto& wanted) {
        const auto found = std::ranges::find_if(screen.cells, wanted);
        if (found == screen.cells.end()) return;
        const bool known = std::ranges::any_of(raced, [&](const ScreenedCell& other) {
            return other.type == found->type && other.algorithm == found->algorithm;
        });
        if (!known) raced.push_back(*found);
    };
    for (const ScreenedCell& cell : screen.cells)
        if (cell.is_in() && raced.size() < most_raced) raced.push_back(cell);
    if (raced.empty()) return raced;
    add_first([](const ScreenedCell& cell) {
        return cell.is_baseline() && cell.dropped_for != DroppedFor::failure;
    });
    for (const char* algorithm : {"gjk", "vclip"})
        add_first([&](const ScreenedCell& cell) {
            return cell.algorithm == algorithm && (cell.is_in() || cell.dropped_for == DroppedFor::time);
        });
    return raced;
}

std::size_t count_dropped(const Screen& screen) {
    return static_cast<std::size_t>(
        std::ranges::count_if(screen.cells, [](const ScreenedCell& cell) { return !cell.is_in(); }));
}

/// The steps of an advice, one after the other.
class Measuring {
  public:
    Measuring(Advice& advice, double seconds, const std::function<void(const std::string&)>& say)
        : advice_(advice), seconds_(seconds), say_(say) {}

    void run() {
        look();
        if (const auto cells = cells_to_race(advice_.screen); !cells.empty()) race(cells);
        if (can_share(advice_.asked)) look_at_other_tables();
        advice_.not_asked.emplace_back(
            "other velocities, other bodies; hardware counters (edgewise machine says which there are)");
        advice_.seconds = elapsed();
    }

  private:
    [[nodiscard]] double elapsed() const { return watch_.elapsed_ns() * 1e-9; }
    [[nodiscard]] TimeLimit until(double part) const {
        return TimeLimit([this] { return elapsed(); }, part * seconds_);
    }

    void look() {
        TimeLimit limit = until(advice_.machines.empty() ? until_screened : until_screened_for_machines);
        advice_.screen = screen(advice_.asked, {}, [&] { return !limit.begin_piece(); });
        say_(fmt::format("looked at {} cells, {} dropped ({:.1f} s)", advice_.screen.cells.size(),
                         count_dropped(advice_.screen), elapsed()));
        looked_seconds_ = elapsed();
        if (advice_.screen.left_out > 0)
            advice_.left_out.push_back(
                fmt::format("{} of {} cells: no time was left to look at them (--time)",
                            advice_.screen.left_out, advice_.screen.cells.size() + advice_.screen.left_out));
    }

    void race(const std::vector<ScreenedCell>& cells) {
        advice_.race = run_race(advice_.asked, cells, {advice_.machines, until(until_raced).left()});
        const Race& race = advice_.race;
        const reports::SceneRanking* const scene = race.scene();
        say_(fmt::format("raced {} of them in {} processes ({:.1f} s)", scene ? scene->cells.size() : 0,
                         race.processes(), elapsed()));
        const int wanted = studies::advise::whole_race.processes;
        name_unmodelled_machines();
        const auto lost = std::ranges::count_if(cells, [&](const ScreenedCell& cell) {
            return !scene || !scene->find(cell.algorithm, cell.type->name);
        });
        if (lost > 0 && race.processes() > 0)
            advice_.left_out.push_back(fmt::format(
                "{} of the {} fastest cells: no time was left to race them (--time)", lost, cells.size()));
        if (race.processes() < wanted)
            advice_.left_out.push_back(fmt::format(
                "{} of {} processes: {}", wanted - race.processes(), wanted,
                race.problem.empty() ? "too long for the time that was left (--time)" : race.problem));
        if (race.taken() && !race.taken()->lines_per_query)
            advice_.left_out.emplace_back("lines, misses and a prediction: no time was left (--time)");
    }

    /// Before all else that there was no time for.
    void name_unmodelled_machines() {
        const reports::RankedCell* const taken = advice_.race.taken();
        const studies::advise::CacheCost* const cost = taken ? advice_.race.caches_of(*taken) : nullptr;
        std::vector<std::string> unmodelled;
        for (const measure::MachineChoice& choice : measure::choose_machines(advice_.machines)) {
            const bool modelled = cost && cost->misses.contains(choice.name);
            if (choice.machine.value && !modelled)
                unmodelled.push_back(
                    fmt::format("the caches of {}: no time was left to model them (--time)", choice.name));
        }
        advice_.left_out.insert(advice_.left_out.begin(), unmodelled.begin(), unmodelled.end());
    }

    /// Of the case with its tables the other way, shorter than the first look; half of a look says nothing.
    void look_at_other_tables() {
        studies::advise::CaseAsked other = advice_.asked;
        other.own_tables = !other.own_tables;
        const char* const name = other.own_tables ? "a table each" : "one table for all";
        TimeLimit limit = until(1);
        const std::string no_time = fmt::format("{}: no time was left for all of it (--time)", name);
        if (limit.left() < looked_seconds_ / 2) {
            advice_.left_out.push_back(no_time);
            return;
        }
        const Screen screen = studies::advise::screen(other, {.queries = 1000, .checked = 20, .passes = 3},
                                                      [&] { return !limit.begin_piece(); });
        if (screen.left_out > 0) {
            advice_.left_out.push_back(no_time);
            return;
        }
        std::ranges::copy_if(screen.cells, std::back_inserter(advice_.other_tables),
                             [](const ScreenedCell& cell) { return cell.is_in(); });
        say_(fmt::format("looked at the case with {} ({:.1f} s)", name, elapsed()));
    }

    Advice& advice_;
    double seconds_;
    const std::function<void(const std::string&)>& say_;
    measure::Stopwatch watch_;
    double looked_seconds_ = 0;
};

}  // namespace

void measure_advice(Advice& advice, double seconds, const std::function<void(const std::string&)>& say) {
    Measuring(advice, seconds, say).run();
}

}  // namespace edgewise::cli
