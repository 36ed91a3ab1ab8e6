// SPDX-License-Identifier: MIT
#include "edgewise/studies/gate/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/measure/machine/machine.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/sweep/axes.hpp"
#include "edgewise/sweep/prepared_cell.hpp"

namespace edgewise::studies {

namespace {

using measure::ComparedRow, measure::FigureRecord, measure::Outcome, measure::RecordComparison,
    measure::RecordRow;

std::string word_of(const std::string& cell, int number) {
    std::istringstream words(cell);
    std::string word;
    for (int i = 0; i <= number; ++i)
        if (!(words >> word)) return {};
    return word;
}

/// Cells that are measured in the same rounds, and divided by one reference: "cold cube8".
std::string gate_group_name(const std::string& scene, const std::string& shape) {
    return scene + " " + shape;
}
/// Returns the group of the cell "gjk lean_f64 cold cube8 batch=yes".
std::string gate_group_of(const std::string& cell) {
    return gate_group_name(word_of(cell, 2), word_of(cell, 3));
}

}  // namespace

std::string gate_table_of(const std::string& cell) { return word_of(cell, 1); }

std::optional<RecordRow> gate_row(std::string cell, std::string figure, std::span<const double> times,
                                  std::span<const double> beside) {
    const std::vector<double> ratios = measure::paired_ratios(times, beside);
    if (!std::all_of(ratios.begin(), ratios.end(), [](double ratio) { return ratio > 0; }))
        return std::nullopt;
    const auto middle = measure::median(ratios);
    const auto interval = measure::bootstrap_median(ratios);
    if (!middle || !interval) return std::nullopt;
    // The interval of a bootstrap may miss the median of a sample of few values.
    return RecordRow{std::move(cell),
                     std::move(figure),
                     *middle,
                     std::min(interval->lower, *middle),
                     std::max(interval->upper, *middle),
                     true};
}

RecordComparison compare_speed(FigureRecord baseline, const FigureRecord& now) {
    for (RecordRow& row : baseline.rows) row.low = row.high = row.value;
    RecordComparison found = compare(baseline, now);
    for (ComparedRow& row : found.rows)
        if (row.is.figure == over_kernel && (row.outcome == Outcome::worse || row.outcome == Outcome::better))
            row.note = "other ratios of " + gate_group_of(row.is.cell) + " are divided by this one's time";
    return found;
}

std::vector<std::string> suspect_groups(const RecordComparison& found) {
    std::vector<std::string> groups;
    for (const ComparedRow& row : found.rows) {
        const std::string group = gate_group_of(row.is.cell);
        if (row.outcome == Outcome::worse && std::ranges::find(groups, group) == groups.end())
            groups.push_back(group);
    }
    return groups;
}

void look_again(FigureRecord& now, const RecordComparison& found, const FigureRecord& again) {
    std::set<std::string> suspects;
    for (const ComparedRow& row : found.rows)
        if (row.outcome == Outcome::worse) suspects.insert(row.is.cell);
    for (RecordRow& row : now.rows) {
        const auto second = std::ranges::find(again.rows, row.cell, &RecordRow::cell);
        if (second == again.rows.end() || !suspects.contains(row.cell)) continue;
        if (second->low < row.low) row = *second;
    }
}

namespace {

constexpr std::size_t node_count = 2048;  // 128 KiB
constexpr int walk_steps = 8192, products = 24'576;

/// Multiplies in a chain; each product waits for the last. The factors are inverses, so no value overflows.
double chain_of_products(double start) {
    double value = start;
    for (int i = 0; i < products / 2; ++i) value = value * 1.25 * 0.8;
    return value;
}

/// Measures the speed of this machine independently of algorithms and layouts, about half of the time each: a
/// chain of dependent multiplications, limited by the clock, and a walk along pointers through a
/// buffer larger than a first-level and smaller than a second-level cache, limited by the caches. The walk is
/// one circle in an order that no prefetcher knows (Sattolo, 1986).
class GateKernel {
  public:
    GateKernel() : nodes_(node_count) {
        std::vector<std::size_t> order(node_count);
        std::iota(order.begin(), order.end(), std::size_t{0});
        scene::Rng rng(1);
        for (std::size_t i = node_count - 1; i > 0; --i) std::swap(order[i], order[rng.below(i)]);
        for (std::size_t i = 0; i < node_count; ++i) nodes_[i].next = &nodes_[order[i]];
    }

    /// Time of one run in ns, with the buffer in cache.
    [[nodiscard]] double time_ns() const {
        volatile double start = 1;
        volatile bool sink = walk(nodes_.data(), node_count) == nullptr;
        const measure::Stopwatch watch;
        const double product = chain_of_products(start);
        const Node* end = walk(nodes_.data(), walk_steps);
        sink = end == nullptr || product < 0;
        const double ns = watch.elapsed_ns();
        static_cast<void>(sink);
        return ns;
    }

  private:
    /// A node fills one cache line.
    struct alignas(64) Node {
        const Node* next = nullptr;
    };

    [[nodiscard]] static const Node* walk(const Node* from, int steps) {
        for (int i = 0; i < steps; ++i) from = from->next;
        return from;
    }

    std::vector<Node> nodes_;
};

/// A scene of the fixed set under a name of its own.
struct GateScene {
    const char* name;
    const char* kind;
    scene::SceneParameters parameters;
};

constexpr const char* reference_table = "aos_f64";
constexpr const char* reference_algorithm = "vclip";
constexpr const char* batch_axis = "batch=yes";

const bench::TableType& reference_type() { return bench::table_type_called(reference_table); }

struct GateCellChoice {
    const bench::TableType* type;
    std::string algorithm, axes;
};

/// Returns the plan's cells with the reference first; it is listed once.
std::vector<GateCellChoice> cells_of(const GatePlan& plan, const GateScene& scene) {
    std::vector<GateCellChoice> cells = {{&reference_type(), reference_algorithm, ""}};
    for (const bench::TableType* type : plan.types) {
        for (const std::string& algorithm : type->algorithms) {
            if (type->name != reference_table || algorithm != reference_algorithm)
                cells.push_back({type, algorithm, ""});
            if (algorithm == "gjk" && scene.kind == std::string_view("cold"))
                cells.push_back({type, algorithm, batch_axis});
        }
    }
    return cells;
}

sweep::Plan plan_for(const GatePlan& plan) {
    sweep::Plan queries;
    queries.queries = plan.queries;
    queries.checked = 20;  // answers per cell held against exact arithmetic
    return queries;
}

const std::vector<GateScene>& gate_scenes() {
    // 40 tables of the paper's record with 386 vertices take 10 MB.
    static const std::vector<GateScene> scenes = {
        {"cold", "cold", {}},
        {"tumble_0.01", "tumble", {{"rotation_step", 0.01}}},
        {"tumble_1", "tumble", {{"rotation_step", 1}}},
        {"tumble_random", "tumble", {{"random_orientation", 1}, {"rotation_step", 0}}},
        {"pressure", "pressure", {{"bodies", 40}}}};
    return scenes;
}

constexpr std::array gate_shapes = {"cube8", "sphere38", "sphere386"};

/// One scene on one body with every cell that a guard on speed times there: table types, algorithms, and GJK
/// asked in batches where pairs are cold. The first cell is the reference.
class GateGroup {
  public:
    /// Makes every cell and checks its answers; errors go to `wrong`. Throws like run_gate.
    GateGroup(const GatePlan& plan, const GateScene& scene, const std::string& shape,
              std::vector<std::string>& wrong)
        : shared_(plan_for(plan), {scene.kind, scene.parameters},
                  {shape, "built-in", scene::make_shape(shape).or_throw(), {}}) {
        for (const GateCellChoice& choice : cells_of(plan, scene)) {
            if (!choice.type->stored_body(shared_.workload().bodies[0]))
                continue;  // not a body for this layout
            Cell cell{choice.algorithm + " " + choice.type->name + " " + gate_group_name(scene.name, shape) +
                          (choice.axes.empty() ? "" : " " + choice.axes),
                      {*choice.type, choice.algorithm, sweep::parse_axes(choice.axes)},
                      {}};
            if (const std::string error = cell.cell.load(shared_.workload()); !error.empty())
                throw std::invalid_argument(cell.name + ": " + error);
            cell.cell.check(shared_);
            const std::string problem = cell.cell.wrong();
            if (!problem.empty()) wrong.push_back(cell.name + ": " + problem);
            if (problem.empty() || cells_.empty()) cells_.push_back(std::move(cell));
        }
    }

    /// Times every cell and the kernel once, in an order drawn for this round.
    void time_round(int number, const GateKernel& kernel, double clock_cost_ns) {
        sweep::take_turns(cells_.size() + 1, static_cast<std::uint64_t>(number) + 1, [&](std::size_t i) {
            if (i < cells_.size()) {
                cells_[i].ns.push_back(cells_[i].cell.runner().time({}, clock_cost_ns).all().value_or(0));
            } else {
                kernel_ns_.push_back(std::min(kernel.time_ns(), kernel.time_ns()));
            }
        });
    }

    /// Returns the rows over all rounds. Throws std::invalid_argument if there are too few rounds.
    [[nodiscard]] std::vector<measure::RecordRow> rows() const {
        std::vector<measure::RecordRow> rows;
        for (const Cell& cell : cells_) {
            const bool is_reference = &cell == &cells_.front();
            const auto row = gate_row(cell.name, is_reference ? over_kernel : over_reference, cell.ns,
                                      is_reference ? kernel_ns_ : cells_.front().ns);
            if (!row)
                throw std::invalid_argument(
                    fmt::format("{}: no ratio with an interval; give more --queries or --rounds", cell.name));
            rows.push_back(*row);
        }
        return rows;
    }

  private:
    struct Cell {
        std::string name;  ///< "gjk lean_f64 cold cube8 batch=yes"
        sweep::PreparedCell cell;
        std::vector<double> ns;  ///< per query, round by round
    };

    sweep::SharedQueries shared_;
    std::vector<Cell> cells_;
    std::vector<double> kernel_ns_;
};

measure::FigureRecord record_without_rows(const GatePlan& plan) {
    const store::BuildRow build = bench::this_build();
    return {speed_kind,
            {{"queries", std::to_string(plan.queries)}},
            {{"machine", measure::read_machine().cpu.name.value.value_or("unknown")},
             {"git_revision", build.git_revision},
             {"compiler", build.compiler},
             {"flags", build.flags},
             {"build_type", build.build_type},
             {"rounds", std::to_string(plan.rounds)}},
            {},
            {}};
}

/// Returns false if it was stopped.
bool add_group(const GatePlan& plan, const GateScene& scene, const std::string& shape,
               const std::atomic<bool>& stop, GateRun& run) {
    const GateKernel kernel;
    GateGroup group(plan, scene, shape, run.wrong);
    const double clock_cost_ns = measure::calibrate();
    for (int round = 0; round < plan.rounds; ++round) {
        if (stop) return false;
        group.time_round(round, kernel, clock_cost_ns);
    }
    for (measure::RecordRow& row : group.rows()) run.record.rows.push_back(std::move(row));
    return true;
}

}  // namespace

std::vector<std::string> gate_groups() {
    std::vector<std::string> groups;
    for (const GateScene& scene : gate_scenes())
        for (const char* shape : gate_shapes) groups.push_back(gate_group_name(scene.name, shape));
    return groups;
}

std::optional<GateRun> run_gate(const GatePlan& plan,
                                const std::function<void(const std::string& group)>& on_group,
                                const std::atomic<bool>& stop) {
    GateRun run{record_without_rows(plan), {}};
    for (const GateScene& scene : gate_scenes()) {
        for (const char* shape : gate_shapes) {
            const std::string name = gate_group_name(scene.name, shape);
            if (!plan.groups.empty() && std::ranges::find(plan.groups, name) == plan.groups.end()) continue;
            if (!add_group(plan, scene, shape, stop, run)) return std::nullopt;
            on_group(name);
        }
    }
    return run;
}

}  // namespace edgewise::studies
