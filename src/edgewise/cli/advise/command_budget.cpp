// SPDX-License-Identifier: MIT
//
// `edgewise budget`: how few vertices a body can have. Hulls of some of its vertices, each with the exact
// worst error of any distance to it, and what it takes in time, bytes and lines.
#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "edgewise/cli/command.hpp"
#include "edgewise/cli/parts/chosen_body.hpp"
#include "edgewise/cli/terminal/text_table.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/studies/advise/body_cost.hpp"
#include "edgewise/studies/advise/vertex_budget.hpp"

namespace edgewise::cli {

namespace {

using studies::advise::BodyCost;
using studies::advise::SmallerBody;

struct BudgetArguments {
    std::string mesh, shape = "sphere386", table = "lean_f32", algorithm = "vclip";
    std::optional<double> tolerance;
};

constexpr std::size_t counts[] = {4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024};

struct Row {
    SmallerBody body;
    BodyCost cost;
    bool of_tolerance = false;
};

/// By vertices; the whole body last, with no error.
std::vector<Row> rows_of(const BudgetArguments& options, const Polyhedron& body,
                         const bench::TableType& type) {
    std::vector<Row> rows;
    for (SmallerBody& smaller : studies::advise::smaller_bodies(body, {std::begin(counts), std::end(counts)}))
        rows.push_back({std::move(smaller), {}});
    if (options.tolerance) {
        SmallerBody fitting = studies::advise::within_tolerance(body, *options.tolerance);
        const auto place = std::ranges::find_if(
            rows, [&](const Row& row) { return row.body.vertices.size() >= fitting.vertices.size(); });
        if (fitting.vertices.size() < body.vertex_count()) rows.insert(place, {std::move(fitting), {}, true});
    }
    rows.push_back({{body.vertices, 0}, {}});
    std::vector<Polyhedron> bodies;
    for (const Row& row : rows) bodies.push_back(convex_hull(row.body.vertices).or_throw());
    const std::vector<BodyCost> costs = studies::advise::costs_of(bodies, type, options.algorithm);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].cost = costs[i];
    return rows;
}

void print_rows(const std::vector<Row>& rows, double size) {
    TextTable table({"#vertices", "#worst error", "#of size", "#ns", "#bytes", "#lines", ""});
    for (const Row& row : rows)
        table.add({std::to_string(row.body.vertices.size()), fmt::format("{:.6g}", row.body.worst_error),
                   fmt::format("{:.2g}", row.body.worst_error / size), fmt::format("{:.0f}", row.cost.ns),
                   fmt::format("{:.0f}", row.cost.table_bytes), fmt::format("{:.1f}", row.cost.lines),
                   row.of_tolerance ? "<- the tolerance" : ""});
    fmt::print("{}", table.text());
    fmt::print(
        "{}\n",
        folded("worst error: exact, of any distance to the smaller body, in the body's unit. It is a "
               "hull of some of the vertices and does not contain the full body: distances are never "
               "too short, and too long by no more than that. ns: per query of cold pairs of two such "
               "bodies, the shortest of some rounds in one process; lines: of 64 bytes, per warm query "
               "at 0.1 rad per step.",
               widest_line));
}

nlohmann::json json_of(const BudgetArguments& options, const scene::MeshBody& body,
                       const std::vector<Row>& rows) {
    nlohmann::json json = {{"body", body.name},
                           {"vertices", body.body.vertex_count()},
                           {"size", extent(body.body.vertices)},
                           {"table", options.table},
                           {"algorithm", options.algorithm},
                           {"contains", false},
                           {"tolerance", or_null(options.tolerance)},
                           {"rows", nlohmann::json::array()},
                           {"answer", nullptr}};
    for (const Row& row : rows) {
        json["rows"].push_back({{"vertices", row.body.vertices.size()},
                                {"worst_error", row.body.worst_error},
                                {"ns", row.cost.ns},
                                {"bytes", row.cost.table_bytes},
                                {"lines_per_query", row.cost.lines},
                                {"of_tolerance", row.of_tolerance}});
        if (!row.of_tolerance) continue;
        nlohmann::json points = nlohmann::json::array();
        for (const Vec3d& v : row.body.vertices) points.push_back({v.x(), v.y(), v.z()});
        json["answer"] = {{"vertices", row.body.vertices.size()},
                          {"worst_error", row.body.worst_error},
                          {"points", points}};
    }
    return json;
}

int run_budget(const BudgetArguments& options, bool json) {
    const scene::MeshBody body = chosen_body(options.shape, options.mesh);
    const std::string names[] = {options.table};
    const auto types = bench::select_table_types(names);
    if (types.size() != 1 || !types.front()->serves(options.algorithm))
        throw std::invalid_argument(
            fmt::format("--table {}: wants one table type that {} runs on, such as {}", options.table,
                        options.algorithm, types.front()->name));
    const std::vector<Row> rows = rows_of(options, body.body, *types.front());
    if (json) {
        print_json(json_of(options, body, rows));
        return exit_done;
    }
    fmt::print("{}: {} vertices, {:.6g} in size, {} on {}\n", body.name, body.body.vertex_count(),
               extent(body.body.vertices), options.algorithm, options.table);
    print_rows(rows, extent(body.body.vertices));
    if (!options.tolerance) return exit_done;
    const auto fitting = std::ranges::find_if(rows, &Row::of_tolerance);
    if (fitting == rows.end()) {
        fmt::print("at {}: all {} vertices\n", *options.tolerance, body.body.vertex_count());
    } else {
        fmt::print("at {}: {} vertices do, with a worst error of {:.6g} (--json has them; fewer may exist)\n",
                   *options.tolerance, fitting->body.vertices.size(), fitting->body.worst_error);
    }
    return exit_done;
}

}  // namespace

void add_budget(CLI::App& app, Context& context) {
    auto [command, options] = add_command(
        app, context, "budget",
        "How few vertices a body can have, and the exact worst error of distances then", run_budget);
    CLI::Option* const mesh = command->add_option("--mesh", options.mesh, "mesh file of the body");
    command->add_option("--shape", options.shape, "built-in shape")->capture_default_str()->excludes(mesh);
    command->add_option("--tolerance", options.tolerance, "largest error of any distance, in the body's unit")
        ->check(CLI::PositiveNumber);
    command->add_option("--table", options.table, "table type that is timed")->capture_default_str();
    command->add_option("--algorithm", options.algorithm, "vclip or gjk")->capture_default_str();
}

}  // namespace edgewise::cli
