// SPDX-License-Identifier: MIT
//
// The effort run as a study.

#include <algorithm>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/parallel.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/studies/effort/effort.hpp"
#include "edgewise/sweep/study.hpp"

namespace edgewise::studies {

namespace {

constexpr const char* effort_run = "effort";

using Number = measure::Expected<double>;

/// Returns the quotient, or the reason of the missing number.
Number over(const Number& above, const Number& below) {
    if (!above.value) return above;
    if (!below.value) return below;
    if (*below.value == 0) return Number::none("there is nothing to divide by");
    return {*above.value / *below.value};
}

template <class Whole, class Part>
Number part_of(const measure::Expected<Whole>& whole, Part Whole::*part) {
    if (!whole.value) return whole.refusal();
    return {*whole.value.*part};
}

Number mispredictions_of(const measure::Expected<measure::CallgrindCounts>& counted) {
    if (!counted.value) return counted.refusal();
    if (!counted.value->mispredictions) return Number::none("Callgrind simulated no branches");
    return {*counted.value->mispredictions};
}

/// A row in progress: examined, or with the reason why it cannot be.
struct Examined {
    std::size_t place;
    const EffortContender* contender;
    store::CellRow row;
    std::optional<Effort> effort;
};

Examined examine_row(std::size_t place, const EffortContender& contender, store::CellRow row) {
    try {
        Effort effort = examine(contender.choice);
        row.status = effort.is_peer         ? store::CellStatus::judged
                     : effort.wrong.empty() ? store::CellStatus::verified
                                            : store::CellStatus::failed;
        row.reason = effort.wrong;
        return {place, &contender, std::move(row), std::move(effort)};
    } catch (const std::invalid_argument& problem) {  // bodies that the table cannot store
        row.status = store::CellStatus::unavailable;
        row.reason = problem.what();
        return {place, &contender, std::move(row), std::nullopt};
    }
}

}  // namespace

std::vector<EffortContender> contenders(const EffortPlan& plan) {
    std::vector<EffortContender> all;
    for (const bench::TableType* type : plan.types) {
        for (const std::string& algorithm : plan.algorithms) {
            if (!type->serves(algorithm)) continue;
            all.push_back({type, plan.cell});
            all.back().choice.table = type->name;
            all.back().choice.algorithm = algorithm;
        }
    }
    for (const bench::TableType* peer : plan.peers) {
        all.push_back({peer, plan.cell});
        all.back().choice.peer = peer->name;
        all.back().choice.algorithm = peer->algorithms.front();
    }
    return all;
}

measure::Expected<measure::CacheGeometry> geometry_of(const measure::MachineChoice& choice) {
    if (!choice.machine.value) return choice.machine.refusal();
    return measure::callgrind_geometry(*choice.machine.value);
}

std::vector<store::FigureRow> effort_figures(const Effort& effort, const std::string& machine) {
    std::vector<store::FigureRow> figures;
    const auto add = [&](const store::FigureName& name, const Number& number) {
        figures.push_back({store::figure(name, number.value, number.reason, number.remedy), name.probe()});
    };
    const Number instructions = part_of(effort.counted, &measure::CallgrindCounts::instructions);
    const Number mispredictions = mispredictions_of(effort.counted);
    const Number flops = part_of(effort.floor, &ProofFloor::flops);
    const Number vertices = part_of(effort.floor, &ProofFloor::vertices);
    const Number lines = part_of(effort.floor, &ProofFloor::lines);
    const store::FigureName d1("effort.{machine}.d1_misses"), ll("effort.{machine}.ll_misses");
    add("effort.instructions", instructions);
    add("effort.mispredictions", mispredictions);
    add(d1.of(machine), part_of(effort.counted, &measure::CallgrindCounts::d1_misses));
    add(ll.of(machine), part_of(effort.counted, &measure::CallgrindCounts::ll_misses));
    add("effort.steps", effort.steps);
    add("effort.vertices_read", effort.vertices_read);
    add("effort.lines_read", effort.lines_read);
    add("effort.instructions_per_step", over(instructions, effort.steps));
    add("effort.mispredictions_per_step", over(mispredictions, effort.steps));
    add("effort.vertices_per_step", over(effort.vertices_read, effort.steps));
    add("effort.floor_vertices", vertices);
    add("effort.floor_flops", flops);
    add("effort.floor_lines", lines);
    add("effort.instructions_over_floor", over(instructions, flops));
    add("effort.vertices_over_floor", over(effort.vertices_read, vertices));
    add("effort.lines_over_floor", over(effort.lines_read, lines));
    add("bytes.table_bytes", {effort.table_bytes});
    add("bytes.object_bytes", {effort.object_bytes});
    add("bytes.pair_bytes", {effort.pair_bytes});
    return figures;
}

bool run_effort(const EffortPlan& plan, const std::function<bool(const store::CellRow&)>& wanted,
                const std::function<void(std::size_t place, const store::StoredCell&)>& on_row,
                const std::atomic<bool>& stop) {
    const auto geometry = geometry_of(plan.machine);
    const auto program = program_for_valgrind();
    const std::vector<EffortContender> all = contenders(plan);
    std::vector<Examined> examined;
    for (std::size_t place = 0; place < all.size() && !stop; ++place) {
        store::CellRow row = row_of(all[place].choice, *all[place].type, effort_run);
        if (wanted(row)) examined.push_back(examine_row(place, all[place], std::move(row)));
    }
    std::mutex one_at_a_time;
    bench::for_each_index(examined.size(), [&](std::size_t i) {
        if (stop) return;
        auto& [place, contender, row, effort] = examined[i];
        if (effort) effort->counted = count_effort(contender->choice, *effort, geometry, program);
        const std::scoped_lock lock(one_at_a_time);
        on_row(place,
               {row, effort ? effort_figures(*effort, plan.machine.name) : std::vector<store::FigureRow>{}});
    });
    return !stop;
}

bool store_effort(const EffortPlan& plan, const std::string& build, store::Store& store,
                  const std::function<void(std::size_t place, const store::StoredCell&)>& on_row,
                  const std::atomic<bool>& stop) {
    constexpr store::FigureName misses("effort.{machine}.d1_misses");
    const auto lacks_counts = [&](const store::CellRow& row) {
        const auto stored = store.find_cell(build, row.hash);
        return !stored || !stored->figure(misses.of(plan.machine.name)).value;
    };
    return run_effort(
        plan, lacks_counts,
        [&](std::size_t place, const store::StoredCell& row) {
            store.put_cell(build, row, store.with_stored_figures(build, row.hash, row.figures));
            on_row(place, row);
        },
        stop);
}

namespace {

EffortPlan effort_plan(const sweep::SweepWork& work) {
    const std::string machines[] = {effort_machine};
    EffortPlan plan{effort_cell, work.types, work.peers, work.algorithms,
                    measure::choose_machines(machines).front()};
    plan.cell.queries = work.plan.count_of(effort_run);
    plan.cell.checked = std::min(work.plan.checked, plan.cell.queries);
    plan.cell.seed = work.plan.seed;
    return plan;
}

bool run_effort_study(const sweep::SweepWork& work, store::Store& store, const sweep::OnStudyRow& on_row,
                      const std::atomic<bool>& stop) {
    const auto notify = [&](std::size_t, const store::StoredCell& row) {
        on_row(row.algorithm + " " + row.table, row.status);
    };
    return store_effort(effort_plan(work), bench::this_build().id, store, notify, stop);
}

}  // namespace

sweep::Study effort_study() {
    return {.name = effort_run,
            .counts = input::queries_or_none,
            .rows = [](const sweep::SweepWork& work) { return contenders(effort_plan(work)).size(); },
            .seconds_each =
                [](const sweep::SweepWork& work) {
                    constexpr double query_seconds = 0.02;  // under Callgrind
                    return query_seconds * static_cast<double>(work.plan.count_of(effort_run));
                },
            .run = run_effort_study};
}

}  // namespace edgewise::studies
