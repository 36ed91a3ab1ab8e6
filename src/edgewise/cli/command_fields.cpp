// SPDX-License-Identifier: MIT
//
// `edgewise fields`: which fields of a table's records are read together, in which groups they should lie,
// and what became of it when a table was built so.
#include <fmt/format.h>

#include <stdexcept>

#include "edgewise/cli/command.hpp"
#include "edgewise/cli/number_option.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/cli/usage/folders.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/reports/charts/co_access_picture.hpp"
#include "edgewise/studies/fields/fields.hpp"
#include "edgewise/studies/fields/group_text.hpp"

namespace edgewise::cli {

namespace {

using studies::FieldsAdvice;
using studies::FieldsContender;
using Role = FieldsContender::Role;

/// As many as an interval takes.
constexpr input::CountRange interval_rounds{9, 1000, "rounds"};

struct FieldsArguments {
    studies::FieldsPlan plan;
    std::string svg, write;
};

std::string title_of(const FieldsAdvice& advice, const studies::CellChoice& cell) {
    return fmt::format("{} {}, {} {}, {} queries", advice.table, cell.algorithm, cell.scene, cell.shape,
                       advice.together.queries);
}

/// Parts of what reads either; of a field alone, of all queries or steps.
reports::CoAccessParts parts_of(const studies::FieldCounts& counts, std::uint64_t all) {
    reports::CoAccessParts parts(counts.size(), std::vector<double>(counts.size()));
    for (std::size_t a = 0; a < counts.size(); ++a) {
        for (std::size_t b = 0; b < counts.size(); ++b)
            parts[a][b] = studies::CoAccess::overlap(counts, a, b);
        parts[a][a] = all == 0 ? 0 : static_cast<double>(counts[a][a]) / static_cast<double>(all);
    }
    return parts;
}

void write_picture(const FieldsAdvice& advice, const FieldsArguments& options) {
    std::vector<reports::CoAccessField> fields;
    for (const RecordField& field : advice.fields)
        fields.push_back({std::string(field.name), std::string(field.record)});
    input::write_output(options.svg,
                        reports::draw_co_access(title_of(advice, options.plan.cell), fields,
                                                parts_of(advice.together.by_query, advice.together.queries),
                                                parts_of(advice.together.by_step, advice.together.steps)));
}

nlohmann::json json_of(const studies::TraceCost& cost) {
    nlohmann::json misses = nlohmann::json::array();
    for (const studies::LevelMissesPerQuery& level : cost.misses)
        misses.push_back(
            {{"machine", level.machine}, {"level", level.level}, {"misses_per_query", level.misses}});
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
    nlohmann::json fields = nlohmann::json::array(), contenders = nlohmann::json::array();
    for (std::size_t i = 0; i < advice.fields.size(); ++i)
        fields.push_back({{"name", advice.fields[i].name},
                          {"record", advice.fields[i].record},
                          {"bytes", advice.fields[i].bytes}});
    for (const FieldsContender& contender : advice.contenders)
        contenders.push_back(json_of(contender, advice));
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

void print_groups(const char* whose, const FieldGroups& groups, const FieldsAdvice& advice) {
    fmt::print("{}\n", whose);
    groups.for_each([&](std::span<const std::uint8_t> group) {
        const GroupRecord record(group, advice.fields);
        std::string names;
        for (std::size_t i = 0; i < record.count; ++i)
            names += (i > 0 ? ", " : "") + std::string(advice.fields[record.fields[i]].name);
        fmt::print("  {:>3} bytes per {:<12} {}\n", record.size.bytes, advice.fields[group.front()].record,
                   names);
    });
}

std::string ratio_text(const std::optional<studies::TimeRatio>& ratio) {
    if (!ratio) return "-";
    return fmt::format("{:.3f} [{:.3f}, {:.3f}]", ratio->middle, ratio->low, ratio->high);
}

void print_costs(const FieldsAdvice& advice) {
    fmt::print("{:<12}{:<18}{:>10}{:>10}", "", "table", "lines", "reads");
    for (const studies::LevelMissesPerQuery& level : advice.predicted.misses)
        fmt::print("{:>26}", level.machine + " " + level.level);
    fmt::print("{:>12}  {}\n", "bytes", "time over the baseline's");
    const auto row = [&](std::string_view role, const std::string& table, const studies::TraceCost& cost,
                         const std::string& bytes, const std::string& time) {
        fmt::print("{:<12}{:<18}{:>10.3f}{:>10.1f}", role, table, cost.lines_per_query(),
                   cost.reads_per_query());
        for (const studies::LevelMissesPerQuery& level : cost.misses) fmt::print("{:>26.3f}", level.misses);
        fmt::print("{:>12}  {}\n", bytes, time);
    };
    row("predicted", advice.builder, advice.predicted, "", "");
    for (const FieldsContender& contender : advice.contenders)
        row(to_string(contender.role), contender.table, contender.cost,
            fmt::format("{:.0f}", contender.table_bytes),
            ratio_text(advice.ratio(contender.role, advice.baseline())));
}

void print(const FieldsAdvice& advice, const FieldsArguments& options) {
    fmt::print("{}\n", title_of(advice, options.plan.cell));
    print_pairs(advice);
    if (advice.own)
        print_groups("records now:", *advice.own, advice);
    else
        fmt::print("records now: not such as groups of fields make\n");
    print_groups(options.plan.groups_file.empty() ? "advised:" : "to be tried:", advice.advised, advice);
    print_costs(advice);
    fmt::print("queries that the advice never saw: {:.3f} lines per query, {:.3f} as advised\n",
               advice.unseen_lines, advice.unseen_lines_advised);
    fmt::print("lines: {} ({} predicted, {} counted, {} before)\n", to_string(advice.lines_held()),
               advice.predicted.lines, advice.find(Role::advised)->cost.lines,
               advice.find(Role::original)->cost.lines);
    fmt::print("time: {} (advised {} of the time of its {}; that table once more, beside itself {})\n",
               to_string(advice.time_held()), ratio_text(advice.ratio(Role::advised, advice.baseline())),
               to_string(advice.baseline()), ratio_text(advice.ratio(Role::control, advice.baseline())));
    fmt::print("{} interleaved rounds of one process; another process may place its tables otherwise\n",
               options.plan.rounds);
    for (const FieldsContender& contender : advice.contenders)
        if (!contender.wrong.empty()) fmt::print("{}: {}\n", contender.table, contender.wrong);
}

int run_fields(const FieldsArguments& options, bool json) {
    Progress progress("fields", static_cast<std::size_t>(options.plan.rounds));
    const FieldsAdvice advice = studies::advise_fields(options.plan, [&] { progress.advance(); });
    progress.clear();
    if (!options.svg.empty()) write_picture(advice, options);
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
    add_count(*command, "--checked", plan.cell.checked, input::queries_range,
              "queries checked exactly, of each table");
    add_names(*command, "--machines", plan.machines,
              "whose caches are modelled: names, or your own NAME.json");
    command->add_option("--beside", plan.beside, "a table type made by hand, timed beside [hot_cold]");
    command->add_option("--groups", plan.groups_file, "a file of groups to try, in place of advised ones");
    add_output_file(*command, "--write", options.write, "the advised groups as JSON, to this file");
    add_output_file(*command, "--svg", options.svg, "the matrix of fields as a picture, to this file");
    add_count(*command, "--rounds", plan.rounds, interval_rounds, "interleaved rounds of timing");
}

}  // namespace edgewise::cli
