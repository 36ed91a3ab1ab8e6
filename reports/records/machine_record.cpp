// SPDX-License-Identifier: MIT
#include "edgewise/reports/records/machine_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/answer/ranking.hpp"

namespace edgewise::reports {

namespace {

constexpr store::FigureName modelled_ns("caches.{machine}.modelled_memory_ns");

/// Cells that anybody can measure again: those of bodies and scenes that come with Edgewise, without further
/// axes.
bool is_common(const ReportCell& cell) {
    return cell.verified() && cell.axes.empty() && cell.shape_source == "built-in";
}

/// What tables compete in.
std::string question_of(const ReportCell& cell) {
    return fmt::format("{} {} {} {}", cell.scene, cell.scene_parameters, cell.shape, cell.algorithm);
}

void add_rows(const ReportCell& cell, double low, double ratio, double high, measure::FigureRecord& record) {
    const std::string name = question_of(cell) + " " + cell.table;
    record.rows.push_back({name, ratio_figure, ratio, low, high, true});
    if (const auto bytes = cell.figure("bytes.total_bytes_per_edge").value)
        record.rows.push_back({name, "bytes per edge", *bytes});
}

std::string text_of(const nlohmann::json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// What of `edgewise machine --json` explains a ratio.
measure::Conditions facts_in(const std::string& machine_json) {
    using input::member_of;
    const nlohmann::json machine = input::json_or_null(machine_json);
    const nlohmann::json cpu = member_of(machine, "cpu"), name = member_of(cpu, "name");
    measure::Conditions facts = {{"machine", name.is_string() ? text_of(name) : "unknown processor"},
                                 {"times", "measured"}};
    for (const char* member :
         {"vendor", "family", "model", "stepping", "cores", "threads", "vector_extensions"})
        if (const nlohmann::json value = member_of(cpu, member); !value.is_null())
            facts.emplace_back(fmt::format("cpu.{}", member), text_of(value));
    for (const nlohmann::json& cache : member_of(machine, "caches"))
        facts.emplace_back(
            fmt::format("cache.L{} {}", text_of(member_of(cache, "level")),
                        text_of(member_of(cache, "type"))),
            fmt::format("{} bytes, {} ways, lines of {}", text_of(member_of(cache, "bytes")),
                        text_of(member_of(cache, "ways")), text_of(member_of(cache, "line_bytes"))));
    return facts;
}

}  // namespace

measure::FigureRecord measured_record(const ReportData& data) {
    measure::FigureRecord record{machine_kind, {}, facts_in(data.build.machine_json), {}, {}};
    for (const ReportCell& cell : data.cells) {
        if (!is_common(cell)) continue;
        const auto timed = ranked_cell(cell, std::numeric_limits<double>::infinity());
        if (!timed || !timed->interval) continue;
        add_rows(cell, std::min(timed->low(), timed->ratio), timed->ratio,
                 std::max(timed->high(), timed->ratio), record);
    }
    if (record.rows.empty())
        throw std::runtime_error("the store has no timed cell of a built-in shape; run edgewise sweep");
    return record;
}

measure::FigureRecord modelled_record(const ReportData& data, const measure::CacheMachine& machine) {
    measure::FigureRecord record{machine_kind,
                                 {},
                                 {{"machine", machine.name},
                                  {"times", "modelled misses alone: no such machine was measured"},
                                  {"cpu.name", machine.what}},
                                 {},
                                 {}};
    for (std::size_t i = 0; i < machine.caches.levels.size(); ++i)
        record.with.emplace_back(
            "cache." + machine.caches.levels[i].name,
            fmt::format("{} bytes, {} ways", machine.caches.bytes_of(i), machine.caches.levels[i].ways));
    const store::FigureName figure = modelled_ns.of(machine.name);
    std::map<std::string, double> baselines;
    for (const ReportCell& cell : data.cells) {
        const auto ns = cell.figure(figure).value;
        if (is_common(cell) && ns && cell.table == modelled_baseline) baselines[question_of(cell)] = *ns;
    }
    for (const ReportCell& cell : data.cells) {
        const auto ns = cell.figure(figure).value;
        const auto baseline = baselines.find(question_of(cell));
        if (!is_common(cell) || !ns || baseline == baselines.end()) continue;
        if (!(*ns > 0 && baseline->second > 0)) continue;  // nothing missed: the model has nothing to say
        const double ratio = *ns / baseline->second;
        add_rows(cell, ratio, ratio, ratio, record);
    }
    if (record.rows.empty())
        throw std::runtime_error(fmt::format(
            "the store has no modelled memory time of '{0}' and of {1}; run edgewise sweep --caches all --machines {0}",
            machine.name, modelled_baseline));
    return record;
}

namespace {

using measure::FigureRecord, measure::RecordRow;

/// A cell's name without its last word, the table.
std::string question_of(const RecordRow& row) { return row.cell.substr(0, row.cell.rfind(' ')); }
std::string table_of(const RecordRow& row) { return row.cell.substr(row.cell.rfind(' ') + 1); }

std::string with(const FigureRecord& record, const char* name) {
    const auto found = std::ranges::find(record.with, name, &std::pair<std::string, std::string>::first);
    return found == record.with.end() ? "unknown" : found->second;
}

bool is_model(const FigureRecord& record) { return with(record, "times") != "measured"; }

RatioRange range_of(const RecordRow& row) { return {row.low, row.value, row.high}; }

/// Returns how much the baseline's own cell differs from 1 in the scene and shape of a question.
OwnVariation own_variation(const FigureRecord& record, const std::string& question) {
    const Baseline own;
    const std::string cell =
        fmt::format("{} {} {}", question.substr(0, question.rfind(' ')), own.algorithm, own.table);
    for (const RecordRow& row : record.rows)
        if (row.figure == ratio_figure && row.cell == cell) return {std::max(row.value, 1 / row.value)};
    return {};
}

std::optional<FirstPlace> first_place(const FigureRecord& record, const std::string& question) {
    std::vector<RecordRow> rows;
    std::ranges::copy_if(record.rows, std::back_inserter(rows), [&](const RecordRow& row) {
        return row.figure == ratio_figure && question_of(row) == question;
    });
    if (rows.empty()) return std::nullopt;
    std::ranges::stable_sort(rows, {}, &RecordRow::value);
    FirstPlace first{{}, rows.front().value};
    const OwnVariation variation = own_variation(record, question);
    for (const RecordRow& row : rows)
        if (ties(range_of(row), range_of(rows.front()), variation)) first.tables.push_back(table_of(row));
    return first;
}

std::vector<std::string> first_on_all(const ComparedQuestion& compared) {
    std::map<std::string, std::size_t> times;
    std::size_t asked = 0;
    for (const auto& place : compared.machines) {
        if (!place) continue;
        ++asked;
        for (const std::string& table : place->tables) ++times[table];
    }
    std::vector<std::string> tables;
    for (const auto& [table, count] : times)
        if (count == asked) tables.push_back(table);
    return tables;
}

/// "tumble (rotation_step 0.1) cube8 gjk" of the question "tumble {"rotation_step":0.1,...} cube8 gjk".
std::string label_of(const std::string& question) {
    const auto begin = question.find(" {"), end = question.rfind("} ");
    if (begin == question.npos || end == question.npos || end < begin) return question;
    store::CellRow cell;
    cell.scene = question.substr(0, begin);
    cell.scene_parameters = question.substr(begin + 1, end - begin);
    return scene_label(cell) + question.substr(end + 1);
}

std::string label_of(const FigureRecord& record) {
    return with(record, "machine") + (is_model(record) ? " (model)" : "");
}

std::string place_text(const std::optional<FirstPlace>& place) {
    if (!place) return "not asked";
    const std::string others =
        place->tables.size() > 1 ? fmt::format(" or {} more", place->tables.size() - 1) : "";
    return fmt::format("{} {:.3f}{}", place->tables.front(), place->ratio, others);
}

}  // namespace

std::vector<ComparedQuestion> compare_records(std::span<const FigureRecord> records) {
    std::vector<ComparedQuestion> result;
    for (const FigureRecord& record : records)
        for (const RecordRow& row : record.rows)
            if (row.figure == ratio_figure &&
                std::ranges::find(result, question_of(row), &ComparedQuestion::question) == result.end())
                result.push_back({question_of(row), {}, {}});
    for (ComparedQuestion& compared : result) {
        for (const FigureRecord& record : records)
            compared.machines.push_back(first_place(record, compared.question));
        compared.first_everywhere = first_on_all(compared);
    }
    return result;
}

std::string comparison_text(std::span<const FigureRecord> records) {
    std::string text = "fastest table and its ratio to the record's baseline; 'or n more': intervals meet\n";
    std::size_t alike = 0;
    const auto compared = compare_records(records);
    for (const ComparedQuestion& question : compared) {
        text += label_of(question.question) + "\n";
        for (std::size_t i = 0; i < records.size(); ++i)
            text += fmt::format("    {:<44} {}\n", label_of(records[i]), place_text(question.machines[i]));
        alike += !question.first_everywhere.empty();
        const bool none = question.first_everywhere.empty();
        text += fmt::format("    {:<44} {}\n", "first everywhere",
                            none ? "none" : fmt::format("{}", fmt::join(question.first_everywhere, ", ")));
    }
    return text + fmt::format("{} of {} questions have a table that is first on every machine asked\n", alike,
                              compared.size());
}

nlohmann::ordered_json comparison_json(std::span<const FigureRecord> records) {
    nlohmann::ordered_json questions = nlohmann::ordered_json::array(), machines = questions;
    for (const FigureRecord& record : records)
        machines.push_back({{"machine", with(record, "machine")}, {"modelled", is_model(record)}});
    for (const ComparedQuestion& compared : compare_records(records)) {
        nlohmann::ordered_json places = nlohmann::ordered_json::array();
        for (const auto& place : compared.machines) {
            nlohmann::ordered_json one;
            if (place) one = {{"tables", place->tables}, {"ratio", place->ratio}};
            places.push_back(one);
        }
        questions.push_back({{"question", compared.question},
                             {"first", places},
                             {"first_everywhere", compared.first_everywhere}});
    }
    return {{"machines", machines}, {"questions", questions}};
}

}  // namespace edgewise::reports
