// SPDX-License-Identifier: MIT
//
// What all cases share, and the cases of the claims about tables' bytes, caches and paging.
#include <fmt/core.h>

#include "claim_cases.hpp"
#include "made_up_data.hpp"

namespace edgewise::reports {
ReportCell make_cell(const MadeCell& made, const MadeFigures& figures) {
    ReportCell cell = base_cell(made.scene, made.shape, made.algorithm, "");
    cell.table = made.table;
    cell.scene_parameters =
        made.parameter.empty() ? "{}" : fmt::format(R"({{"{}":{}}})", made.parameter, made.x);
    cell.figures = figures_of(figures);
    return cell;
}

MadeFigures made_time(double ns) {
    return {{"time.all_ns", ns}, {"time.all_ns_low", 0.98 * ns}, {"time.all_ns_high", 1.02 * ns}};
}

std::string made_shape(int vertices) {
    if (vertices == 4) return "tetra4";
    return vertices == 8 ? "cube8" : "sphere" + std::to_string(vertices);
}

void add_angular(ReportData& data, int vertices, const std::string& algorithm,
                 const std::function<MadeFigures(int)>& figures) {
    const std::string scene = fmt::format("paper_angular_{}", vertices);
    int number = 0;
    for (const double step : made_steps)
        add_cell(data, {scene, made_shape(vertices), algorithm, "rotation_step", step}, figures(number++));
}

void add_angular_time(ReportData& data, int vertices, const std::string& algorithm, double ns) {
    add_angular(data, vertices, algorithm, [ns](int) { return made_time(ns); });
}

namespace {

ReportData slopes(double in_double, double in_single) {
    ReportData data;
    add_cell(data, {"paper_static", "sphere386", "vclip"}, {{"bytes.paper_bytes_per_edge", in_double}});
    add_cell(data, {"paper_static", "sphere386", "vclip", "", 0, "aos_f32"},
             {{"bytes.paper_bytes_per_edge", in_single}});
    return data;
}

ReportData table_bytes(double vclip, double gjk) {
    ReportData data;
    add_cell(data, {"paper_static", "sphere386", "vclip"}, {{"bytes.table_bytes", vclip}});
    add_cell(data, {"paper_static", "sphere386", "gjk"}, {{"bytes.table_bytes", gjk}});
    return data;
}

ReportData bytes_by_size(double smallest_body) {
    ReportData data;
    for (const int vertices : {8, 38, 386})
        add_cell(data, {"paper_complexity", made_shape(vertices), "vclip"},
                 {{"bytes.total_bytes_per_edge", vertices == 8 ? smallest_body : 230}});
    return data;
}

void add_thrash(ReportData& data, int vertices, const std::string& algorithm, const MadeFigures& figures,
                const std::string& table = "aos_f64") {
    for (const double step : {1.0 / 60, 7.0 / 60, 1.0, 3.1415927})
        add_cell(data,
                 {"paper_thrash_" + std::to_string(vertices), made_shape(vertices), algorithm,
                  "rotation_step", step, table},
                 figures);
}

MadeFigures misses(double count) {
    MadeFigures figures;
    for (const std::string machine : {"pentium3_coppermine", "pentium2_deschutes", "athlon_thunderbird"})
        figures.push_back({"caches." + machine + ".L2.misses_per_query.warm", count});
    return figures;
}

ReportData misses_by_size(double larger) {
    ReportData data;
    add_thrash(data, 38, "vclip", misses(1));
    add_thrash(data, 386, "vclip", misses(larger));
    return data;
}

ReportData misses_by_algorithm(double vclip) {
    ReportData data;
    add_thrash(data, 386, "gjk", misses(1));
    add_thrash(data, 386, "vclip", misses(vclip));
    return data;
}

ReportData misses_by_table(double without) {
    ReportData data;
    add_thrash(data, 386, "vclip", misses(10));
    add_thrash(data, 386, "vclip", misses(10 * without), "aos_f64 sharing=shared");
    add_thrash(data, 386, "vclip", misses(10 * without), "lean_f64");
    return data;
}

ReportData lines(double vclip) {
    ReportData data;
    add_thrash(data, 386, "vclip", {{"reuse.lines_per_query.warm", vclip}});
    add_thrash(data, 386, "gjk", {{"reuse.lines_per_query.warm", 1}});
    return data;
}

/// Limits: none, 80 MB, 40 MB, 20 MB; what is touched is 100 MB, so 40 MB are too little.
void add_paging(ReportData& data, const std::string& algorithm, double faults, double us) {
    data.paging.push_back(
        make_cell({"paging", "sphere386", algorithm}, {{"paging.touched_bytes", 100e6},
                                                       {"paging.limit_bytes.0", 0},
                                                       {"paging.limit_bytes.1", 80e6},
                                                       {"paging.limit_bytes.2", 40e6},
                                                       {"paging.limit_bytes.3", 20e6},
                                                       {"paging.faults_per_query.0", 0},
                                                       {"paging.faults_per_query.1", 1e-6},
                                                       {"paging.faults_per_query.2", faults},
                                                       {"paging.faults_per_query.3", 100},
                                                       {"paging.us_per_query.0", 1},
                                                       {"paging.us_per_query.1", 3},
                                                       {"paging.us_per_query.2", us},
                                                       {"paging.us_per_query.3", 5000}}));
}

ReportData paging(double vclip_faults, double gjk_faults, double us) {
    ReportData data;
    add_paging(data, "vclip", vclip_faults, us);
    add_paging(data, "gjk", gjk_faults, 1);
    return data;
}

}  // namespace

std::vector<ClaimCase> memory_cases() {
    return {
        {.id = "bytes_per_edge_double",
         .make = [](double x) { return slopes(x, 84); },
         .reproduced = 168,
         .not_reproduced = 200,
         .identifiable = false},
        {.id = "bytes_halved_in_single",
         .make = [](double x) { return slopes(168, x); },
         .reproduced = 84,
         .not_reproduced = 100,
         .identifiable = false},
        {"memory_linear_in_edges", bytes_by_size, 240, 400},
        {"memory_overhead_of_vclip", [](double x) { return table_bytes(1000 * x, 1000); }, 10, 1.2},
        {"hundreds_fill_memory", [](double x) { return table_bytes(x, 1); }, 268992, 1000},
        {"more_lines_than_gjk", lines, 3, 0.5},
        {"cache_misses_grow_at_386", misses_by_size, 5, 1},
        {"cache_misses_spare_gjk", misses_by_algorithm, 5, 1},
        {"thrash_caused_by_tables", misses_by_table, 0.1, 0.9},
        {"swapping_spares_gjk", [](double x) { return paging(1, x, 50); }, 0, 0.5},
        {"swapping_explains_figure_8", [](double x) { return paging(1, 0, x); }, 20, 2},
    };
}

}  // namespace edgewise::reports
