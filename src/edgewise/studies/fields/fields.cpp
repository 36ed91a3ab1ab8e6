// SPDX-License-Identifier: MIT
#include "edgewise/studies/fields/fields.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <string_view>
#include <unordered_map>

#include "edgewise/layout_parts/stored_fields.hpp"
#include "edgewise/measure/cache/cache_model.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::studies {

namespace {

struct ModelledCaches final : measure::TraceListener {
    explicit ModelledCaches(std::span<const measure::CacheMachine> machines) {
        for (const measure::CacheMachine& machine : machines) models.emplace_back(machine.caches);
    }
    void on_access(const measure::TracedAccess& access) override {
        for (measure::CacheModel& model : models) model.access(access.address, access.bytes, access.kind);
    }

    std::vector<measure::CacheModel> models;
};

}  // namespace

TraceCost cost_of(const TracePass& pass, std::span<const measure::CacheMachine> machines) {
    measure::LineCounter lines;
    ModelledCaches caches(machines);
    measure::TraceFanOut both({&lines, &caches});
    pass(both);
    for (measure::CacheModel& model : caches.models) model.forget_counts();
    pass(caches);
    const measure::LinesTouched& sum = lines.sums().all;
    TraceCost cost{sum.queries, sum.lines, sum.reads, {}};
    for (std::size_t i = 0; i < machines.size(); ++i) {
        const measure::CacheModel& model = caches.models[i];
        for (std::size_t level = 0; level < model.counts().size(); ++level) {
            const auto misses = static_cast<double>(model.counts(level).misses);
            cost.misses.push_back({machines[i].name, model.geometry().levels[level].name,
                                   sum.queries == 0 ? 0 : misses / static_cast<double>(sum.queries)});
        }
    }
    return cost;
}

namespace {

using Role = FieldsContender::Role;

/// A contender in progress, with its cell.
struct Standing {
    FieldsContender contender;
    std::unique_ptr<SingleCell> cell;
};

/// Returns the layout made by hand, with fewer lines than the given table, that it is usually compared with.
std::string usual_beside(const bench::TableType& type) {
    const std::string name = "hot_cold_" + type.precision;
    return type.layout == "hot_cold" || !bench::find_table_type(name) ? "" : name;
}

class FieldsRun {
  public:
    explicit FieldsRun(const FieldsPlan& plan)
        : plan_(plan), machines_(measure::described_machines(plan.machines)) {}

    [[nodiscard]] FieldsAdvice run(const std::function<void()>& on_round) {
        stand(Role::original, plan_.cell.table, std::nullopt);
        find_advice();
        if (advice_.own) {
            stand(Role::own_groups, advice_.builder, advice_.own);
            stand(Role::control, advice_.builder, advice_.own);
        } else {
            stand(Role::control, plan_.cell.table, std::nullopt);
        }
        stand(Role::advised, advice_.builder, advice_.advised);
        const std::string beside = plan_.beside.empty() ? usual_beside(type()) : plan_.beside;
        if (!beside.empty()) stand(Role::beside, beside, std::nullopt);
        time_rounds(on_round);
        for (Standing& standing : standing_) advice_.contenders.push_back(std::move(standing.contender));
        return std::move(advice_);
    }

  private:
    [[nodiscard]] const SingleCell& original() const { return *standing_.front().cell; }
    [[nodiscard]] const bench::TableType& type() const { return original().type(); }

    /// Builds a cell, verifies it and counts what it reads.
    void stand(Role role, const std::string& table, const std::optional<FieldGroups>& groups) {
        CellChoice choice = plan_.cell;
        choice.table = table;
        FieldsContender contender{role, table, groups, {}, {}, 0, {}};
        auto cell = make_cell(choice, groups);
        contender.table = cell->type().name;
        contender.wrong = cell->prepared().wrong();
        contender.cost = cost_of(
            [&](measure::TraceListener& listener) {
                static_cast<void>(cell->runner().trace(bench::TraceExtent::everything(), listener));
            },
            machines_);
        contender.table_bytes = cell->runner().memory().requested;
        standing_.push_back({std::move(contender), std::move(cell)});
    }

    static std::unique_ptr<SingleCell> make_cell(const CellChoice& choice,
                                                 const std::optional<FieldGroups>& groups) {
        if (!groups) return std::make_unique<SingleCell>(choice);
        const FieldsGroupedBy<StoredField> fields(*groups);  // which the layout asks for
        return std::make_unique<SingleCell>(choice);
    }

    void find_advice() {
        const FieldTrace trace =
            trace_fields(original().runner(), bench::TraceExtent::everything(), type().name);
        advice_.table = type().name;
        advice_.builder = bench::table_type_called(builder_of(type())).name;
        advice_.fields = trace.fields();
        advice_.together = co_access(trace);
        advice_.own = own_groups(trace);
        advice_.advised =
            plan_.groups_file.empty() ? best_groups(trace) : read_groups(plan_.groups_file, advice_.fields);
        advice_.predicted = predict(trace, advice_.advised);
        look_at_unseen(trace.queries);
    }

    /// Returns the table's groups if records made of them reproduce the table: the same lines and bytes.
    [[nodiscard]] std::optional<FieldGroups> own_groups(const FieldTrace& trace) const {
        const std::optional<FieldGroups> groups = groups_of(trace.tables.front());
        if (!groups) return std::nullopt;
        const bool same = GroupedPlaces(trace.tables, *groups).taken() == trace.taken &&
                          predict(trace, *groups).lines == standing_.front().contender.cost.lines;
        return same ? groups : std::nullopt;
    }

    [[nodiscard]] TraceCost predict(const FieldTrace& trace, const FieldGroups& groups) const {
        const GroupedPlaces places(trace.tables, groups);
        return cost_of([&](measure::TraceListener& listener) { replay(trace, places, listener); }, machines_);
    }

    /// Traces the scene from another seed.
    void look_at_unseen(std::uint64_t queries) {
        CellChoice choice = plan_.cell;
        ++choice.seed;
        choice.checked = 0;
        const SingleCell other(choice);
        const FieldTrace trace = trace_fields(other.runner(), queries, type().name);
        const auto pass = [&](measure::TraceListener& listener) {
            static_cast<void>(other.runner().trace(queries, listener));
        };
        advice_.unseen_lines = cost_of(pass, {}).lines_per_query();
        advice_.unseen_lines_advised = predict(trace, advice_.advised).lines_per_query();
    }

    void time_rounds(const std::function<void()>& on_round) {
        const double clock_cost_ns = measure::calibrate();
        for (int round = 0; round < plan_.rounds; ++round) {
            sweep::take_turns(standing_.size(), static_cast<std::uint64_t>(round) + 1, [&](std::size_t i) {
                const measure::Timing timed = standing_[i].cell->runner().time({}, clock_cost_ns);
                standing_[i].contender.ns.push_back(timed.all().value_or(0));
            });
            on_round();
        }
    }

    const FieldsPlan& plan_;
    std::vector<measure::CacheMachine> machines_;
    std::vector<Standing> standing_;
    FieldsAdvice advice_;
};

}  // namespace

std::string builder_of(const bench::TableType& type) { return "grouped_" + type.precision; }

FieldsAdvice advise_fields(const FieldsPlan& plan, const std::function<void()>& on_round) {
    return FieldsRun(plan).run(on_round);
}

// Decides whether advice on fields held.

std::string_view to_string(FieldsContender::Role role) {
    constexpr std::string_view names[] = {"original", "own groups", "control", "advised", "beside"};
    return names[static_cast<int>(role)];
}

std::string_view to_string(Held held) {
    constexpr std::string_view names[] = {"held", "did not hold", "within the noise"};
    return names[static_cast<int>(held)];
}

const FieldsContender* FieldsAdvice::find(Role role) const {
    const auto found = std::find_if(contenders.begin(), contenders.end(),
                                    [&](const FieldsContender& contender) { return contender.role == role; });
    return found == contenders.end() ? nullptr : &*found;
}

std::optional<TimeRatio> FieldsAdvice::ratio(Role above, Role below) const {
    const FieldsContender *const a = find(above), *const b = find(below);
    if (!a || !b) return std::nullopt;
    const std::vector<double> ratios = measure::paired_ratios(a->ns, b->ns);
    const auto middle = measure::median(ratios);
    const auto interval = measure::bootstrap_median(ratios);
    if (!middle || !interval) return std::nullopt;
    return TimeRatio{interval->lower, *middle, interval->upper};
}

Role FieldsAdvice::baseline() const { return own ? Role::own_groups : Role::original; }

bool FieldsAdvice::all_right() const {
    return std::all_of(contenders.begin(), contenders.end(),
                       [](const FieldsContender& contender) { return contender.wrong.empty(); });
}

Held FieldsAdvice::lines_held() const {
    const FieldsContender *const built = find(Role::advised), *const before = find(Role::original);
    if (!built || !before) return Held::no;
    return built->cost.lines == predicted.lines && built->cost.lines < before->cost.lines ? Held::yes
                                                                                          : Held::no;
}

Held FieldsAdvice::time_held() const {
    const auto time = ratio(Role::advised, baseline()), noise = ratio(Role::control, baseline());
    if (!time || !noise) return Held::within_noise;
    if (time->high < std::min(1.0, noise->low)) return Held::yes;
    return time->low > std::max(1.0, noise->high) ? Held::no : Held::within_noise;
}

namespace {

/// Fields as bits.
using FieldSet = std::uint32_t;

void add_set(FieldCounts& counts, FieldSet set) {
    for (FieldSet left = set; left != 0; left &= left - 1) {
        const auto a = static_cast<std::size_t>(std::countr_zero(left));
        for (FieldSet others = set; others != 0; others &= others - 1)
            ++counts[a][static_cast<std::size_t>(std::countr_zero(others))];
    }
}

class CoAccessCounter {
  public:
    explicit CoAccessCounter(const std::vector<RecordField>& fields) {
        const FieldCounts none(fields.size(), std::vector<std::uint64_t>(fields.size()));
        counts_ = {none, none, none};
        std::map<std::string_view, std::uint64_t> kinds;
        for (const RecordField& field : fields)
            kind_.push_back(kinds.emplace(field.record, kinds.size()).first->second);
    }

    void read(measure::TraceSide side, const FieldAccess& field) {
        const FieldSet bit = FieldSet{1} << field.field;
        of_step_ |= bit;
        const std::uint64_t whose =
            kind_[field.field] << 40 | std::uint64_t{field.element} << 8 | static_cast<std::uint64_t>(side);
        of_records_[whose] |= bit;
    }
    void end_step() {
        if (of_step_ == 0) return;
        ++counts_.steps;
        add_set(counts_.by_step, of_step_);
        for (const auto& [whose, set] : of_records_) add_set(counts_.by_record, set);
        of_query_ |= of_step_;
        of_step_ = 0;
        of_records_.clear();
    }
    void end_query() {
        end_step();
        ++counts_.queries;
        add_set(counts_.by_query, of_query_);
        of_query_ = 0;
    }
    [[nodiscard]] CoAccess take() { return std::move(counts_); }

  private:
    CoAccess counts_;
    std::vector<std::uint64_t> kind_;  ///< of record, by field
    FieldSet of_step_ = 0, of_query_ = 0;
    std::unordered_map<std::uint64_t, FieldSet> of_records_;  ///< of the step
};

}  // namespace

double CoAccess::overlap(const FieldCounts& counts, std::size_t a, std::size_t b) {
    const std::uint64_t both = counts[a][b], either = counts[a][a] + counts[b][b] - both;
    return either == 0 ? 0 : static_cast<double>(both) / static_cast<double>(either);
}

CoAccess co_access(const FieldTrace& trace) {
    CoAccessCounter counter(trace.fields());
    for (const FieldEvent& event : trace.events) {
        if (event.kind == FieldEvent::Kind::step_start) counter.end_step();
        if (event.kind == FieldEvent::Kind::field) counter.read(event.access.side, event.field);
        if (event.kind == FieldEvent::Kind::query_end) counter.end_query();
    }
    return counter.take();
}

}  // namespace edgewise::studies
