// SPDX-License-Identifier: MIT
//
// The fields run as a study: advice on the paper's record (fields.hpp) by both algorithms.
#include "edgewise/bench/build_info.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/studies/fields/fields.hpp"
#include "edgewise/sweep/study.hpp"

namespace edgewise::studies {

namespace {

constexpr const char* fields_run = "fields";

using Role = FieldsContender::Role;

constexpr std::string_view whose(Role role) {
    constexpr std::string_view names[] = {"original", "own_groups", "control", "advised", "beside"};
    return names[static_cast<int>(role)];
}

class FieldsFigures {
  public:
    explicit FieldsFigures(const FieldsAdvice& advice) : advice_(advice) {}

    [[nodiscard]] std::vector<store::FigureRow> take() {
        for (std::size_t field = 0; field < advice_.fields.size(); ++field) add_field(field);
        if (advice_.own) add_groups("fields.own_group.{field}", *advice_.own);
        add_groups("fields.advised_group.{field}", advice_.advised);
        add_cost("predicted", advice_.predicted);
        for (const FieldsContender& contender : advice_.contenders) add_contender(contender);
        constexpr store::FigureName unseen("fields.unseen_lines.{whose}");
        add(unseen.of("original"), advice_.unseen_lines);
        add(unseen.of("advised"), advice_.unseen_lines_advised);
        add("fields.lines_held", advice_.lines_held() == Held::yes ? 1 : 0);
        const Held time = advice_.time_held();
        add("fields.time_held", time == Held::yes ? 1 : time == Held::no ? -1 : 0);
        return std::move(figures_);
    }

  private:
    void add(const store::FigureName& name, std::optional<double> value, const std::string& reason = {}) {
        figures_.push_back({store::figure(name, value, reason), name.probe()});
    }

    void add_field(std::size_t a) {
        const CoAccess& together = advice_.together;
        const std::string_view name = advice_.fields[a].name;
        const auto part = [](std::uint64_t of, std::uint64_t all) {
            return all == 0 ? 0 : static_cast<double>(of) / static_cast<double>(all);
        };
        add(store::FigureName("fields.bytes.{field}").of(name), advice_.fields[a].bytes);
        add(store::FigureName("fields.number.{field}").of(name), static_cast<double>(a));
        add(store::FigureName("fields.query_part.{field}").of(name),
            part(together.by_query[a][a], together.queries));
        add(store::FigureName("fields.step_part.{field}").of(name),
            part(together.by_step[a][a], together.steps));
        for (std::size_t b = a + 1; b < advice_.fields.size(); ++b) {
            const std::string_view other = advice_.fields[b].name;
            add(store::FigureName("fields.same_query.{field}.{other}").of(name, other),
                CoAccess::overlap(together.by_query, a, b));
            add(store::FigureName("fields.same_step.{field}.{other}").of(name, other),
                CoAccess::overlap(together.by_step, a, b));
            if (advice_.fields[a].record == advice_.fields[b].record)
                add(store::FigureName("fields.same_record.{field}.{other}").of(name, other),
                    CoAccess::overlap(together.by_record, a, b));
        }
    }

    void add_groups(const store::FigureName& name, const FieldGroups& groups) {
        double number = 0;
        groups.for_each([&](std::span<const std::uint8_t> group) {
            for (const std::uint8_t field : group) add(name.of(advice_.fields[field].name), number);
            ++number;
        });
    }

    void add_cost(std::string_view of, const TraceCost& cost) {
        add(store::FigureName("fields.lines.{whose}").of(of), cost.lines_per_query());
        for (const LevelMissesPerQuery& level : cost.misses)
            add(store::FigureName("fields.misses.{machine}.{level}.{whose}")
                    .of(level.machine, level.level, of),
                level.misses);
    }

    void add_contender(const FieldsContender& contender) {
        const std::string_view of = whose(contender.role);
        add_cost(of, contender.cost);
        add(store::FigureName("fields.table_bytes.{whose}").of(of), contender.table_bytes);
        if (contender.role == advice_.baseline()) return;
        const auto ratio = advice_.ratio(contender.role, advice_.baseline());
        const std::string reason = "too few rounds for an interval";
        const auto add_end = [&](const store::FigureName& name, double TimeRatio::*end) {
            add(name.of(of), ratio ? std::optional(*ratio.*end) : std::nullopt, reason);
        };
        add_end("fields.time_ratio.{whose}", &TimeRatio::middle);
        add_end("fields.time_ratio_low.{whose}", &TimeRatio::low);
        add_end("fields.time_ratio_high.{whose}", &TimeRatio::high);
    }

    const FieldsAdvice& advice_;
    std::vector<store::FigureRow> figures_;
};

/// Returns the cells of the run, as far as this program can build their records in other groups.
std::vector<CellChoice> fields_cells(const sweep::SweepWork& work) {
    std::vector<CellChoice> cells;
    for (const char* algorithm : {"vclip", "gjk"}) {
        CellChoice choice = fields_cell;
        choice.table = "aos_f64";
        choice.algorithm = algorithm;
        choice.queries = work.plan.count_of(fields_run);
        choice.seed = work.plan.seed;
        const bench::TableType* const type = bench::find_table_type(choice.table);
        if (type && bench::find_table_type(builder_of(*type))) cells.push_back(choice);
    }
    return cells;
}

bool run_fields_study(const sweep::SweepWork& work, store::Store& store, const sweep::OnStudyRow& on_row,
                      const std::atomic<bool>& stop) {
    const std::string build = bench::this_build().id;
    for (const CellChoice& choice : fields_cells(work)) {
        if (stop) return false;
        store::CellRow row = fields_row(choice);
        if (const auto stored = store.find_cell(build, row.hash)) {
            row.status = stored->status;
        } else {
            FieldsPlan plan;
            plan.cell = choice;
            const FieldsAdvice advice = advise_fields(plan, [] {});
            row.status = advice.all_right() ? store::CellStatus::verified : store::CellStatus::failed;
            for (const FieldsContender& contender : advice.contenders)
                if (row.reason.empty()) row.reason = contender.wrong;
            store.put_cell(build, row, fields_figures(advice));
        }
        on_row(row.algorithm + " " + row.table, row.status);
    }
    return !stop;
}

}  // namespace

store::CellRow fields_row(const CellChoice& choice) {
    return row_of(choice, bench::table_type_called(choice.table), fields_run);
}

std::vector<store::FigureRow> fields_figures(const FieldsAdvice& advice) {
    return FieldsFigures(advice).take();
}

sweep::Study fields_study() {
    return {.name = fields_run,
            .counts = input::queries_or_none,
            .rows = [](const sweep::SweepWork& work) { return fields_cells(work).size(); },
            .seconds_each = [](const sweep::SweepWork&) { return 10.0; },
            .run = run_fields_study};
}

}  // namespace edgewise::studies
