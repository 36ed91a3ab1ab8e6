// SPDX-License-Identifier: MIT
#include "edgewise/studies/fields/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/layout_parts/stored_fields.hpp"
#include "edgewise/measure/cache/cache_model.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/studies/fields/best_groups.hpp"
#include "edgewise/studies/fields/field_places.hpp"
#include "edgewise/studies/fields/group_text.hpp"

namespace edgewise::studies {

namespace {

class ModelledCaches final : public measure::TraceListener {
  public:
    explicit ModelledCaches(std::span<const measure::CacheMachine> machines) {
        for (const measure::CacheMachine& machine : machines) models_.emplace_back(machine.caches);
    }
    void on_access(const measure::TracedAccess& access) override {
        for (measure::CacheModel& model : models_) model.access(access.address, access.bytes, access.kind);
    }
    void on_query_end(bool /*counts*/) override {}

    [[nodiscard]] std::vector<measure::CacheModel>& models() { return models_; }

  private:
    std::vector<measure::CacheModel> models_;
};

}  // namespace

TraceCost cost_of(const TracePass& pass, std::span<const measure::CacheMachine> machines) {
    measure::LineCounter lines;
    ModelledCaches caches(machines);
    measure::TraceFanOut both({&lines, &caches});
    pass(both);
    for (measure::CacheModel& model : caches.models()) model.forget_counts();
    pass(caches);
    const measure::LinesTouched& sum = lines.sums().all;
    TraceCost cost{sum.queries, sum.lines, sum.reads, {}};
    for (std::size_t i = 0; i < machines.size(); ++i) {
        const measure::CacheModel& model = caches.models()[i];
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
    return type.layout == "hot_cold" || !has_table_type(name) ? "" : name;
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
        advice_.builder = builder_of(type());
        if (!has_table_type(advice_.builder))
            throw std::invalid_argument(fmt::format(
                "{}, which builds what is advised, is not in this program: name it in EDGEWISE_LAYOUTS",
                advice_.builder));
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
        const std::optional<FieldGroups> groups = groups_of(trace.maps.front());
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
                standing_[i].contender.ns.push_back(
                    standing_[i].cell->prepared().ns_per_query(clock_cost_ns));
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

bool has_table_type(const std::string& name) {
    return std::ranges::find(bench::table_types(), name, &bench::TableType::name) !=
           bench::table_types().end();
}

std::string builder_of(const bench::TableType& type) { return "grouped_" + type.precision; }

FieldsAdvice advise_fields(const FieldsPlan& plan, const std::function<void()>& on_round) {
    return FieldsRun(plan).run(on_round);
}

}  // namespace edgewise::studies
