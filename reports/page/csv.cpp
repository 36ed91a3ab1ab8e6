// SPDX-License-Identifier: MIT
//
// The report as comma-separated values, which are the shortest text that reads back as the same double.
#include <fmt/core.h>

#include "edgewise/reports/page/page.hpp"

namespace edgewise::reports {

namespace {

std::string quoted(const std::string& field) {
    if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
    std::string out = "\"";
    for (const char c : field) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + "\"";
}

std::string csv_row(const std::vector<std::string>& fields) {
    std::string out;
    for (std::size_t i = 0; i < fields.size(); ++i) (out += i ? "," : "") += quoted(fields[i]);
    return out + "\r\n";
}

std::vector<std::string> cell_fields(const ReportData& data, const ReportCell& cell) {
    return {data.build.id,
            cell.hash,
            cell.scene,
            cell.scene_parameters,
            cell.shape,
            cell.shape_source,
            cell.algorithm,
            cell.layout,
            cell.precision,
            cell.table,
            std::to_string(cell.vertices),
            std::to_string(cell.edges),
            std::to_string(cell.faces),
            std::to_string(cell.seed),
            std::to_string(cell.queries),
            cell.status,
            cell.reason};
}

std::vector<std::string> figure_fields(const store::FigureRow& figure) {
    return {figure.probe,
            figure.name,
            figure.value ? "measured" : "not measured",
            figure.value ? fmt::format("{}", *figure.value) : "",
            figure.unit,
            figure.reason,
            figure.remedy};
}

std::string rows_of(const ReportData& data, const ReportCell& cell) {
    std::string out;
    std::vector<store::FigureRow> figures = cell.figures;
    if (figures.empty()) figures.push_back({{"", std::nullopt, "", "no figure is stored"}, ""});
    for (const store::FigureRow& figure : figures) {
        std::vector<std::string> fields = cell_fields(data, cell);
        const std::vector<std::string> rest = figure_fields(figure);
        fields.insert(fields.end(), rest.begin(), rest.end());
        out += csv_row(fields);
    }
    return out;
}

}  // namespace

std::string results_csv(const ReportData& data) {
    std::string out = csv_row({"build",         "hash",         "scene",     "scene_parameters",
                               "shape",         "shape_source", "algorithm", "layout",
                               "precision",     "table_type",   "vertices",  "edges",
                               "faces",         "seed",         "queries",   "status",
                               "status_reason", "probe",        "figure",    "state",
                               "value",         "unit",         "reason",    "remedy"});
    for (const auto* cells : {&data.cells, &data.from_files, &data.paging, &data.effort, &data.peers}) {
        for (const ReportCell& cell : *cells) out += rows_of(data, cell);
    }
    return out;
}

}  // namespace edgewise::reports
