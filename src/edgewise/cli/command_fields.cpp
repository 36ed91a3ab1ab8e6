// SPDX-License-Identifier: MIT
//
// `edgewise fields`: which fields of a table's records are read together, in which groups they should lie,
// and what became of it when a table was built so.
#include <fmt/format.h>

#include "edgewise/cli/options.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/studies/fields/fields.hpp"

namespace edgewise::cli {

namespace {

using studies::FieldsAdvice, studies::FieldsContender;
using Role = FieldsContender::Role;

/// An interval needs nine rounds.
constexpr input::CountRange interval_rounds{9, 1000, "rounds"};

struct FieldsArguments {
    studies::FieldsPlan plan;
    std::string svg, write;
};

/// The advice as a store has it: what the report's tables and its picture are made of.
reports::ReportCell stored_advice(const FieldsAdvice& advice, const studies::CellChoice& choice) {
    store::CellRow row = studies::fields_row(choice);
    row.status = advice.all_right() ? store::CellStatus::verified : store::CellStatus::failed;
    return {{row, studies::fields_figures(advice)}, choice.scene};
}

nlohmann::json json_of(const studies::TraceCost& cost) {
    const nlohmann::json misses = json_rows(cost.misses, [](const studies::LevelMissesPerQuery& level) {
        return nlohmann::json{
            {"machine", level.machine}, {"level", level.level}, {"misses_per_query", level.misses}};
    });
    return {{"lines", cost.lines},
            {"lines_per_query", cost.lines_per_query()},
            {"reads_per_query", cost.reads_per_query()},
            {"misses", misses}};
}

nlohmann::json json_of(const std::optional<studies::TimeRatio>& ratio) {
    if (!ratio) return nullptr;
    return {ratio->low, ratio->middle, ratio->high};
}

nlohmann::json json_of(const FieldsContender& contender, const FieldsAdvice& advice) {
    nlohmann::json json = json_of(contender.cost);
    json["role"] = to_string(contender.role);
    json["table"] = contender.table;
    if (contender.groups) json["groups"] = studies::groups_json(*contender.groups, advice.fields);
    json["wrong"] = or_null(contender.wrong);
    json["table_bytes"] = contender.table_bytes;
    json["time_ratio_to_baseline"] = json_of(advice.ratio(contender.role, advice.baseline()));
    json["time_ratio_to_original"] = json_of(advice.ratio(contender.role, Role::original));
    return json;
}

nlohmann::json json_of(const FieldsAdvice& advice, const studies::CellChoice& cell) {
    const nlohmann::json fields = json_rows(advice.fields, [](const RecordField& field) {
        return nlohmann::json{{"name", field.name}, {"record", field.record}, {"bytes", field.bytes}};
    });
    const nlohmann::json contenders = json_rows(
        advice.contenders, [&](const FieldsContender& contender) { return json_of(contender, advice); });
    return {
        {"table", advice.table},
        {"algorithm", cell.algorithm},
        {"scene", cell.scene},
        {"shape", cell.shape},
        {"queries", advice.together.queries},
        {"steps", advice.together.steps},
        {"fields", fields},
        {"same_query", advice.together.by_query},
        {"same_step", advice.together.by_step},
        {"same_record_and_step", advice.together.by_record},
        {"own_groups", advice.own ? studies::groups_json(*advice.own, advice.fields) : nlohmann::json()},
        {"advised_groups", studies::groups_json(advice.advised, advice.fields)},
        {"predicted", json_of(advice.predicted)},
        {"unseen", {{"lines_per_query", advice.unseen_lines}, {"advised", advice.unseen_lines_advised}}},
        {"contenders", contenders},
        {"verdict", {{"lines", to_string(advice.lines_held())}, {"time", to_string(advice.time_held())}}}};
}

void print_pairs(const FieldsAdvice& advice) {
    const studies::CoAccess& together = advice.together;
    fmt::print(
        "{} queries of {} steps that read a table; parts of them, and what else the same step reads\n"
        "of the same record (of the steps and records that read either)\n",
        together.queries, together.steps);
    for (std::size_t a = 0; a < advice.fields.size(); ++a) {
        if (together.by_query[a][a] == 0) continue;
        std::string with;
        for (std::size_t b = 0; b < advice.fields.size(); ++b)
            if (const double part = studies::CoAccess::overlap(together.by_record, a, b);
                a != b && part >= 0.005)
                with += fmt::format(" {} {:.2f}", advice.fields[b].name, part);
        fmt::print("  {:<16} queries {:.2f}, steps {:.2f};{}\n", advice.fields[a].name,
                   static_cast<double>(together.by_query[a][a]) / static_cast<double>(together.queries),
                   static_cast<double>(together.by_step[a][a]) / static_cast<double>(together.steps),
                   with.empty() ? " alone" : with);
    }
}

void print(const FieldsAdvice& advice, const FieldsArguments& options) {
    const studies::CellChoice& cell = options.plan.cell;
    fmt::print("{} {}, {} {}, {} queries\n", advice.table, cell.algorithm, cell.scene, cell.shape,
               advice.together.queries);
    print_pairs(advice);
    reports::ReportData data;
    data.fields.push_back(stored_advice(advice, cell));
    fmt::print("\n{}\n{}\nlines: {}; time: {}\n", grid_text(reports::field_groups_grid(data.fields.front())),
               grid_text(reports::field_advice_grid(data)), to_string(advice.lines_held()),
               to_string(advice.time_held()));
    fmt::print(
        "times are those of the {} table; {} interleaved rounds of one process; another process may "
        "place its tables otherwise\n",
        to_string(advice.baseline()), options.plan.rounds);
    for (const FieldsContender& contender : advice.contenders)
        if (!contender.wrong.empty()) fmt::print("{}: {}\n", contender.table, contender.wrong);
}

int run_fields(const FieldsArguments& options, bool json) {
    Progress progress("fields", static_cast<std::size_t>(options.plan.rounds));
    const FieldsAdvice advice = studies::advise_fields(options.plan, [&] { progress.advance(); });
    progress.clear();
    if (!options.svg.empty())
        input::write_output(options.svg, reports::field_picture(stored_advice(advice, options.plan.cell)));
    if (!options.write.empty())
        input::write_output(
            options.write,
            nlohmann::json{{"groups", studies::groups_json(advice.advised, advice.fields)}}.dump() + "\n");
    if (json)
        print_json(json_of(advice, options.plan.cell));
    else
        print(advice, options);
    return advice.all_right() ? exit_done : exit_check_failed;
}

}  // namespace

void add_fields(CLI::App& app, Context& context) {
    auto [command, options] = add_command(
        app, context, "fields",
        "Which fields of a table's records are read together, and where they should lie", run_fields);
    studies::FieldsPlan& plan = options.plan;
    add_cell_options(*command, plan.cell);
    refuse_recordings(*command);
    add_checked_option(*command, plan.cell.checked);
    add_machines_option(*command, plan.machines);
    command->add_option("--beside", plan.beside, "a table type made by hand, which is timed too [hot_cold]");
    command->add_option("--groups", plan.groups_file, "a file of groups to try instead of the advised ones");
    add_output_file(*command, "--out,--write", options.write, "file to write: the advised groups as JSON");
    add_svg_option(*command, options.svg);
    add_rounds_option(*command, plan.rounds, interval_rounds);
}

}  // namespace edgewise::cli
