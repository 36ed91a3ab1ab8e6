// SPDX-License-Identifier: MIT
#include "edgewise/measure/record/record.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "edgewise/input/file_text.hpp"
#include "edgewise/input/json_text.hpp"

namespace edgewise::measure {

namespace {

using Json = nlohmann::ordered_json;

/// Whole numbers without a fraction, as people write them.
Json number_json(double value) {
    constexpr double most = 9e15;  // below it every whole number is a double
    return std::abs(value) < most && value == std::floor(value) ? Json(static_cast<std::int64_t>(value))
                                                                : Json(value);
}

Json row_json(const RecordRow& row) {
    if (!row.text.empty()) return row.text;
    if (!row.has_interval) return number_json(row.value);
    return {row.low, row.value, row.high};
}

/// What is wrong with a record, without the file's name.
struct RecordFault {
    std::string text;
};

void refuse_unknown(const Json& json, std::string_view what, const std::vector<std::string>& known) {
    if (const std::string unknown = input::unknown_member(json, what, known); !unknown.empty())
        throw RecordFault{unknown};
}

const Json& object_in(const Json& json, const std::string& member) {
    static const Json none = Json::object();
    if (!json.contains(member)) return none;
    if (!json[member].is_object()) throw RecordFault{member + ": needs an object"};
    return json[member];
}

Conditions conditions_in(const Json& json, const char* member) {
    Conditions all;
    for (const auto& [name, value] : object_in(json, member).items()) {
        if (!value.is_string()) throw RecordFault{fmt::format("{}.{}: needs a text", member, name)};
        all.emplace_back(name, value.get<std::string>());
    }
    return all;
}

/// Null where there is no such member; `path`: what the member is in.
std::optional<double> number_in(const Json& json, const char* member, const std::string& path = {}) {
    if (!json.contains(member)) return std::nullopt;
    if (!json[member].is_number() || json[member] < 0)
        throw RecordFault{fmt::format("{}{}: needs a number from 0 on", path, member)};
    return json[member].get<double>();
}

bool matches(const Limit& limit, const std::string& figure) {
    return ::fnmatch(limit.figures.c_str(), figure.c_str(), 0) == 0;
}

std::vector<Limit> limits_in(const Json& json, const std::vector<RecordRow>& rows) {
    std::vector<Limit> limits;
    const Json& members = object_in(json, "limits");
    for (const auto& [figures, none] : members.items()) {
        const Json& bounds = object_in(members, figures);
        refuse_unknown(bounds, "a limit", {"soft", "hard"});
        const std::string path = fmt::format("limits.{}.", figures);
        limits.push_back({figures, number_in(bounds, "soft", path), number_in(bounds, "hard", path)});
        if (std::ranges::none_of(rows,
                                 [&](const RecordRow& row) { return matches(limits.back(), row.figure); }))
            throw RecordFault{fmt::format("limits.{}: the record has no such figure", figures)};
    }
    return limits;
}

bool is_interval(const Json& json) {
    if (!json.is_array() || json.size() != 3 || !std::ranges::all_of(json, &Json::is_number)) return false;
    return 0 <= json[0] && json[0] <= json[1] && json[1] <= json[2] && json[1] > 0;
}

RecordRow row_in(const std::string& cell, const std::string& figure, const Json& json) {
    RecordRow row{cell, figure};
    if (is_interval(json)) {
        row.low = json[0].get<double>();
        row.value = json[1].get<double>();
        row.high = json[2].get<double>();
        row.has_interval = true;
    } else if (json.is_number()) {
        row.value = row.low = row.high = json.get<double>();
    } else if (json.is_string() && !json.get_ref<const std::string&>().empty()) {
        row.text = json.get<std::string>();
    } else {
        throw RecordFault{
            fmt::format("{}{}{}: needs a number, or [low, value, high] with 0 <= low <= value <= high", cell,
                        cell.empty() ? "" : ": ", figure)};
    }
    return row;
}

FigureRecord record_in(const Json& json, std::string_view kind) {
    if (!json.is_object()) throw RecordFault{"needs an object"};
    const Json is = json.value("edgewise_record", Json());
    if (!is.is_string()) throw RecordFault{"edgewise_record: needs the kind of record, such as \"lock\""};
    refuse_unknown(json, "a record",
                   {"edgewise_record", "of", "with", "slack", "limits", "figures", "cells"});
    FigureRecord record{
        is.get<std::string>(), conditions_in(json, "of"), conditions_in(json, "with"), {}, {}};
    if (!kind.empty() && record.kind != kind)
        throw RecordFault{fmt::format("a record of kind '{}'; needs one of kind '{}'", record.kind, kind)};
    record.slack = number_in(json, "slack");
    for (const auto& [figure, value] : object_in(json, "figures").items())
        record.rows.push_back(row_in("", figure, value));
    const Json& cells = object_in(json, "cells");
    for (const auto& [cell, figures] : cells.items())
        for (const auto& [figure, value] : object_in(cells, cell).items())
            record.rows.push_back(row_in(cell, figure, value));
    record.limits = limits_in(json, record.rows);
    return record;
}

/// A lock of version 0.1 in the form of today; other records of that version are refused.
Json in_this_form(const Json& json) {
    const auto is_old = [&](const char* name) { return json.is_object() && json.value(name, Json()) == 1; };
    if (is_old("gate") || is_old("edgewise_machine_record"))
        throw RecordFault{"a record of version 0.1, whose form is no longer read: write it again"};
    if (!is_old("edgewise_lock")) return json;
    Json lock = {{"edgewise_record", "lock"}};
    for (const auto& [name, value] : json.items())
        if (name != "edgewise_lock") lock[name] = value;
    return lock;
}

}  // namespace

const std::string& FigureRecord::condition(std::string_view name, const std::string& file) const {
    for (const auto& [known, value] : of)
        if (known == name) return value;
    throw std::runtime_error(fmt::format("{}: of.{}: needs a text", file, name));
}

std::optional<double> FigureRecord::bound_of(const std::string& figure,
                                             std::optional<double> Limit::*bound) const {
    for (const Limit& limit : limits)
        if (limit.*bound && matches(limit, figure)) return limit.*bound;
    return std::nullopt;
}

std::string to_json(const FigureRecord& record) {
    Json json = {{"edgewise_record", record.kind}};
    for (const auto& [name, value] : record.of) json["of"][name] = value;
    for (const auto& [name, value] : record.with) json["with"][name] = value;
    if (record.slack) json["slack"] = number_json(*record.slack);
    for (const Limit& limit : record.limits) {
        if (limit.soft) json["limits"][limit.figures]["soft"] = number_json(*limit.soft);
        if (limit.hard) json["limits"][limit.figures]["hard"] = number_json(*limit.hard);
    }
    for (const RecordRow& row : record.rows)
        (row.cell.empty() ? json["figures"] : json["cells"][row.cell])[row.figure] = row_json(row);
    return input::json_text(json, 2) + "\n";
}

FigureRecord parse_record(const std::string& json, const std::string& file, std::string_view kind) {
    const auto parsed = input::parse_json<Json>(json);
    try {
        if (!parsed) throw RecordFault{parsed.error + "; needs a record (edgewise_record)"};
        return record_in(in_this_form(*parsed), kind);
    } catch (const RecordFault& fault) {
        throw std::runtime_error(fmt::format("{}: {}", file, fault.text));
    }
}

FigureRecord read_record(const std::string& file, std::string_view kind) {
    const auto text = input::read_file_text(file);
    if (!text) throw std::runtime_error(text.error);
    return parse_record(*text, file, kind);
}

}  // namespace edgewise::measure
