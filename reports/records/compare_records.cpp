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

std::vector<const RecordRow*> rows_of(const MachineRecord& record, const std::string& question) {
    std::vector<const RecordRow*> rows;
    for (const RecordRow& row : record.rows)
        if (row.question() == question) rows.push_back(&row);
    std::ranges::stable_sort(rows, {}, [](const RecordRow* row) { return row->ratio; });
    return rows;
}

std::optional<FirstPlace> first_place(const MachineRecord& record, const std::string& question) {
    const auto rows = rows_of(record, question);
    if (rows.empty()) return std::nullopt;
    FirstPlace first{{}, rows.front()->ratio};
    for (const RecordRow* row : rows)
        if (row->low <= rows.front()->high) first.tables.push_back(row->table);
    return first;
}

std::vector<std::string> questions_of(std::span<const MachineRecord> records) {
    std::vector<std::string> questions;
    for (const MachineRecord& record : records) {
        for (const RecordRow& row : record.rows) {
            const std::string question = row.question();
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

/// Values of each parameter of a scene, over all records.
using ParameterValues = std::map<std::string, std::map<std::string, std::set<std::string>>>;

ParameterValues values_in(std::span<const MachineRecord> records) {
    ParameterValues values;
    for (const MachineRecord& record : records) {
        for (const RecordRow& row : record.rows) {
            const nlohmann::json parameters = input::json_or_null(row.parameters);
            for (const auto& [name, value] : parameters.items()) values[row.scene][name].insert(value.dump());
        }
    }
    return values;
}

/// For people: of the scene's parameters those that differ between questions.
std::string label_of(const RecordRow& row, const ParameterValues& values) {
    const nlohmann::json all = input::json_or_null(row.parameters);
    std::string parameters;
    for (const auto& [name, value] : all.items())
        if (values.at(row.scene).at(name).size() > 1) parameters += fmt::format(" {} {}", name, value.dump());
    return fmt::format("{}{}, {}, {}", row.scene, parameters, row.shape, row.algorithm);
}

std::map<std::string, std::string> labels_of(std::span<const MachineRecord> records) {
    const ParameterValues values = values_in(records);
    std::map<std::string, std::string> labels;  // of questions
    for (const MachineRecord& record : records)
        for (const RecordRow& row : record.rows) labels[row.question()] = label_of(row, values);
    return labels;
}

std::string label_of(const MachineRecord& record) {
    return record.is_model ? record.machine + " (model)" : record.machine;
}

std::string place_text(const std::optional<FirstPlace>& place) {
    if (!place) return "not asked";
    const std::string others =
        place->tables.size() > 1 ? fmt::format(" or {} more", place->tables.size() - 1) : "";
    return fmt::format("{} {:.3f}{}", place->tables.front(), place->ratio, others);
}

}  // namespace

std::vector<ComparedQuestion> compare_records(std::span<const MachineRecord> records) {
    std::vector<ComparedQuestion> result;
    for (const std::string& question : questions_of(records)) {
        ComparedQuestion compared{question, {}, {}};
        for (const MachineRecord& record : records)
            compared.machines.push_back(first_place(record, question));
        compared.first_everywhere = first_on_all(compared);
        result.push_back(std::move(compared));
    }
    return result;
}

std::string comparison_text(std::span<const MachineRecord> records) {
    std::string text = "fastest table and its ratio to the record's baseline; 'or n more': intervals meet\n";
    std::size_t alike = 0;
    const auto compared = compare_records(records);
    const auto labels = labels_of(records);
    for (const ComparedQuestion& question : compared) {
        text += labels.at(question.question) + "\n";
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

nlohmann::ordered_json comparison_json(std::span<const MachineRecord> records) {
    nlohmann::ordered_json questions = nlohmann::ordered_json::array(), machines = questions;
    for (const MachineRecord& record : records)
        machines.push_back({{"machine", record.machine}, {"modelled", record.is_model}});
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
