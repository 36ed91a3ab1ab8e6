// SPDX-License-Identifier: MIT
//
// Rows of JSON as a grid: what a command prints for people is what it prints for programs.
#include <fmt/core.h>

#include <sstream>

#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

namespace {

using Json = nlohmann::json;

struct MemberColumn {
    Json::json_pointer member;
    double unit = 1;
    int digits = -1;
};

/// "#KiB = bytes 1024 0": the title is taken off.
MemberColumn member_column(std::string& title) {
    const std::size_t equals = title.find(" = ");
    if (equals == std::string::npos) return {Json::json_pointer("/" + title)};
    std::istringstream rest(title.substr(equals + 3));
    title.resize(equals);
    std::string member;
    MemberColumn column;
    rest >> member >> column.unit >> column.digits;
    column.member = Json::json_pointer("/" + member);
    return column;
}

std::string member_text(const Json& value, const MemberColumn& column) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_array()) {
        std::string list;
        for (const Json& item : value) append(list, member_text(item, column));
        return list;
    }
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (column.digits >= 0) return fmt::format("{:.{}f}", value.get<double>() / column.unit, column.digits);
    if (value.is_number_float() || column.unit != 1) return number_text(value.get<double>() / column.unit);
    return value.dump();
}

std::string reason_of(const Json& object) {
    std::string why;
    for (const char* part : {"reason", "remedy"})
        if (object.contains(part) && object[part].is_string())
            append(why, object[part].get<std::string>(), "; ");
    return why;
}

/// Returns the reason for a missing value: a member next to it, or one of its row.
GridCell member_cell(const Json& row, const MemberColumn& column, bool numeric) {
    const Json value = row.contains(column.member) ? row.at(column.member) : Json();
    if (!value.is_null()) return {member_text(value, column)};
    const Json::json_pointer owner = column.member.parent_pointer();
    std::string why = row.contains(owner) ? reason_of(row.at(owner)) : "";
    if (why.empty()) why = reason_of(row);
    return why.empty() ? GridCell{numeric ? "-" : ""} : missing_cell(why);
}

}  // namespace

TextGrid member_grid(const Json& rows, std::string_view columns) {
    TextGrid grid{"", columns_of(columns)};
    std::vector<MemberColumn> members;
    for (GridColumn& column : grid.columns) members.push_back(member_column(column.title));
    for (const Json& row : rows) {
        std::vector<GridCell>& cells = grid.rows.emplace_back();
        for (std::size_t i = 0; i < members.size(); ++i)
            cells.push_back(member_cell(row, members[i], grid.columns[i].number));
    }
    return grid;
}

}  // namespace edgewise::reports
