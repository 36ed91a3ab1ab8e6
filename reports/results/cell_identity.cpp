// SPDX-License-Identifier: MIT
#include "edgewise/reports/results/cell_identity.hpp"

namespace edgewise::reports {

namespace {

/// Calls text(name, value), count(name, value) or seed(name, value) for each column, in order.
template <class Columns>
void for_each_column(Columns& columns, const ReportData& data, const ReportCell& cell) {
    columns.text("build", data.build.id);
    columns.text("hash", cell.hash);
    columns.text("run", cell.run);
    columns.text("scene", cell.scene);
    columns.text("scene_parameters", cell.scene_parameters);
    columns.text("shape", cell.shape);
    columns.text("shape_source", cell.shape_source);
    columns.text("algorithm", cell.algorithm);
    columns.text("layout", cell.layout);
    columns.text("precision", cell.precision);
    columns.text("table_type", cell.table);
    columns.count("vertices", cell.vertices);
    columns.count("edges", cell.edges);
    columns.count("faces", cell.faces);
    columns.seed("seed", cell.seed);
    columns.count("queries", cell.queries);
    columns.text("status", std::string(to_string(cell.status)));
    columns.text("status_reason", cell.reason);
}

struct Header {
    CsvRow& row;
    void text(const char* name, const std::string&) { row.text(name); }
    void count(const char* name, std::int64_t) { row.text(name); }
    void seed(const char* name, std::uint64_t) { row.text(name); }
};

struct Values {
    CsvRow& row;
    void text(const char*, const std::string& value) { row.text(value); }
    void count(const char*, std::int64_t value) { row.count(value); }
    void seed(const char*, std::uint64_t value) { row.seed(value); }
};

struct Members {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    void text(const char* name, const std::string& value) { object[name] = value; }
    void count(const char* name, std::int64_t value) { object[name] = value; }
    void seed(const char* name, std::uint64_t value) { object[name] = value; }
};

}  // namespace

void add_identity_header(CsvRow& row) {
    Header header{row};
    for_each_column(header, ReportData{}, ReportCell{});
}

void add_identity(CsvRow& row, const ReportData& data, const ReportCell& cell) {
    Values values{row};
    for_each_column(values, data, cell);
}

nlohmann::ordered_json identity_json(const ReportData& data, const ReportCell& cell) {
    Members members;
    for_each_column(members, data, cell);
    return members.object;
}

}  // namespace edgewise::reports
