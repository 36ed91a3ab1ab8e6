// SPDX-License-Identifier: MIT
#include "edgewise/reports/records/compare_records.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "edgewise/input/json_text.hpp"

namespace edgewise::reports {

namespace {

using measure::FigureRecord;
using measure::RecordRow;

/// A cell's name without its last word, the table.
std::string question_of(const RecordRow& row) { return row.cell.substr(0, row.cell.rfind(' ')); }
std::string table_of(const RecordRow& row) { return row.cell.substr(row.cell.rfind(' ') + 1); }

std::string with(const FigureRecord& record, const char* name) {
    const auto found = std::ranges::find(record.with, name, &std::pair<std::string, std::string>::first);
    return found == record.with.end() ? "unknown" : found->second;
}

bool is_model(const FigureRecord& record) { return with(record, "times") != "measured"; }

std::optional<FirstPlace> first_place(const FigureRecord& record, const std::string& question) {
    std::vector<RecordRow> rows;
    std::ranges::copy_if(record.rows, std::back_inserter(rows), [&](const RecordRow& row) {
        return row.figure == ratio_figure && question_of(row) == question;
    });
    if (rows.empty()) return std::nullopt;
    std::ranges::stable_sort(rows, {}, &RecordRow::value);
    FirstPlace first{{}, rows.front().value};
    for (const RecordRow& row : rows)
        if (row.low <= rows.front().high) first.tables.push_back(table_of(row));
    return first;
}

std::vector<std::string> questions_of(std::span<const FigureRecord> records) {
    std::vector<std::string> questions;
    for (const FigureRecord& record : records) {
        for (const RecordRow& row : record.rows) {
            const std::string question = question_of(row);
            if (row.figure != ratio_figure) continue;
            if (std::ranges::find(questions, question) == questions.end()) questions.push_back(question);
        }
    }
    return questions;
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

/// "scene {parameters} shape algorithm" in parts.
struct QuestionParts {
    std::string scene, rest;
    nlohmann::json parameters;

    explicit QuestionParts(const std::string& text) {
        const auto begin = text.find(" {"), end = text.rfind("} ");
        scene = text.substr(0, begin);
        if (begin == text.npos || end == text.npos || end < begin) return;
        parameters = input::json_or_null(text.substr(begin + 1, end - begin));
        rest = text.substr(end + 2);
    }
};

/// Values of each parameter of a scene, over all questions.
using ParameterValues = std::map<std::string, std::map<std::string, std::set<std::string>>>;

ParameterValues values_in(const std::vector<ComparedQuestion>& questions) {
    ParameterValues values;
    for (const ComparedQuestion& question : questions) {
        const QuestionParts parts(question.question);
        for (const auto& [name, value] : parts.parameters.items())
            values[parts.scene][name].insert(value.dump());
    }
    return values;
}

/// For people: of the scene's parameters those that differ between questions.
std::string label_of(const std::string& question, const ParameterValues& values) {
    const QuestionParts parts(question);
    std::string label = parts.scene;
    for (const auto& [name, value] : parts.parameters.items())
        if (values.at(parts.scene).at(name).size() > 1) label += fmt::format(" {} {}", name, value.dump());
    return label + " " + parts.rest;
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
    for (const std::string& question : questions_of(records)) {
        ComparedQuestion compared{question, {}, {}};
        for (const FigureRecord& record : records) compared.machines.push_back(first_place(record, question));
        compared.first_everywhere = first_on_all(compared);
        result.push_back(std::move(compared));
    }
    return result;
}

std::string comparison_text(std::span<const FigureRecord> records) {
    std::string text = "fastest table and its ratio to the record's baseline; 'or n more': intervals meet\n";
    std::size_t alike = 0;
    const auto compared = compare_records(records);
    const ParameterValues values = values_in(compared);
    for (const ComparedQuestion& question : compared) {
        text += label_of(question.question, values) + "\n";
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
