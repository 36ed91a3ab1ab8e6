// SPDX-License-Identifier: MIT
#include "edgewise/reports/results/export.hpp"

#include <fmt/core.h>
#include <fnmatch.h>

#include "edgewise/input/shown_text.hpp"

namespace edgewise::reports {

namespace {

/// What a spreadsheet would run, or what looks like our own mark.
bool needs_mark(std::string_view field) {
    return !field.empty() && std::string_view("=+-@\t\r\n'").find(field.front()) != std::string_view::npos;
}

std::string in_quotes(std::string_view field) {
    std::string out = "\"";
    for (const char c : field) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

}  // namespace

void CsvRow::add(std::string_view field) {
    if (begun_) fields_ += ',';
    begun_ = true;
    fields_ += field;
}

CsvRow& CsvRow::text(std::string_view field) {
    const std::string shown = input::shown_text(field), safe = needs_mark(field) ? "'" + shown : shown;
    add(safe.find_first_of(",\"\r\n") == std::string::npos ? safe : in_quotes(safe));
    return *this;
}

CsvRow& CsvRow::number(std::optional<double> value) {
    add(value ? fmt::format("{}", *value) : "");
    return *this;
}

CsvRow& CsvRow::field(const nlohmann::ordered_json& value) {
    if (value.is_string()) return text(value.get_ref<const std::string&>());
    if (value.is_number_float()) return number(value.get<double>());
    add(value.is_null() ? "" : value.dump());
    return *this;
}

namespace {

/// Families in which every member is a main figure.
constexpr std::string_view main_families[] = {"caches.{machine}.{level}.misses_per_query",
                                              "caches.{machine}.modelled_memory_ns",
                                              "effort.{machine}.d1_misses", "effort.{machine}.ll_misses"};

/// The family with * for each pair of braces.
std::string pattern_of(std::string_view family) {
    std::string pattern;
    for (bool inside = false; const char c : family) {
        if (c == '{') pattern += '*';
        inside = c == '{' || (inside && c != '}');
        if (!inside && c != '}') pattern += c;
    }
    return pattern;
}

struct MainFigures {
    std::map<std::string_view, std::size_t> plain = {};
    std::vector<std::pair<std::string, std::size_t>> families = {};

    MainFigures() {
        for (std::size_t i = 0; i < std::size(store::vocabulary); ++i) {
            const std::string_view key = store::vocabulary[i].key;
            if (key.find('{') == key.npos) plain.emplace(key, i);
            for (const std::string_view family : main_families)
                if (key == family) families.emplace_back(pattern_of(family), i);
        }
    }
};

}  // namespace

std::optional<std::size_t> main_place(const std::string& key) {
    static const MainFigures all;
    if (const auto found = all.plain.find(key); found != all.plain.end()) return found->second;
    // A machine under another policy than its own is a variant of it.
    if (key.find('/') != std::string::npos) return std::nullopt;
    for (const auto& [pattern, place] : all.families)
        if (::fnmatch(pattern.c_str(), key.c_str(), 0) == 0) return place;
    return std::nullopt;
}

const store::FigureInfo* main_info(const std::string& key) {
    const auto place = main_place(key);
    return place ? &store::vocabulary[*place] : nullptr;
}

void add_identity_header(CsvRow& row) {
    const nlohmann::ordered_json columns = identity_json({}, {});
    for (const auto& column : columns.items()) row.text(column.key());
}

void add_identity(CsvRow& row, const ReportData& data, const ReportCell& cell) {
    for (const nlohmann::ordered_json& value : identity_json(data, cell)) row.field(value);
}

nlohmann::ordered_json identity_json(const ReportData& data, const ReportCell& cell) {
    return {{"build", data.build.id},
            {"hash", cell.hash},
            {"run", cell.run},
            {"scene", cell.scene},
            {"scene_parameters", cell.scene_parameters},
            {"shape", cell.shape},
            {"shape_source", cell.shape_source},
            {"algorithm", cell.algorithm},
            {"layout", cell.layout},
            {"precision", cell.precision},
            {"table_type", cell.table},
            {"vertices", cell.vertices},
            {"edges", cell.edges},
            {"faces", cell.faces},
            {"seed", cell.seed},
            {"queries", cell.queries},
            {"status", to_string(cell.status)},
            {"status_reason", cell.reason}};
}

}  // namespace edgewise::reports
