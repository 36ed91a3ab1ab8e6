// SPDX-License-Identifier: MIT
//
// `edgewise bytes`: the bytes-per-edge ledger of tables that are really built. Tables hold all their parts
// here.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/bench/probe.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/reports/additions.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/studies/table_memory_cost.hpp"

namespace edgewise::cli {

namespace {

struct BytesArguments {
    BodyChoice body;
    std::vector<std::string> layouts = {"all"};
    bool slopes = false, footnotes = false;
};

const bench::Probe& bytes_probe() {
    for (const bench::Probe& probe : bench::registered_probes()) {
        if (probe.name == "bytes") return probe;
    }
    throw std::runtime_error("this program was built without the bytes probe (see probes/CMakeLists.txt)");
}

/// Beside the table's own bytes: allocators, pages, and lines that queries touch.
void add_costs(const bench::TableType& type, const Polyhedron& body, Parts parts, nlohmann::json& row) {
    row["allocators"] =
        json_rows(studies::allocator_costs(type, body, parts), [](const studies::AllocatorCost& cost) {
            nlohmann::json entry = {{"name", cost.allocator},
                                    {"taken_bytes", or_null(cost.taken)},
                                    {"by_its_statistics", or_null(cost.by_statistics)},
                                    {"resident_bytes", or_null(cost.resident)}};
            if (!cost.reason.empty()) entry["reason"] = cost.reason;
            return entry;
        });
    row["queries"] = nlohmann::json::array();
    for (const std::string& algorithm : type.algorithms) {
        const Result<measure::LinesTouched> touched = studies::lines_in_tumble(type, algorithm, body);
        const auto mean = [&](std::uint64_t sum) {
            return touched ? nlohmann::json(static_cast<double>(sum) / static_cast<double>(touched->queries))
                           : nlohmann::json();
        };
        const measure::LinesTouched sums = touched ? *touched : measure::LinesTouched{};
        row["queries"].push_back({{"algorithm", algorithm},
                                  {"lines_per_query", mean(sums.lines)},
                                  {"line_bytes_per_query", mean(sums.lines * measure::cache_line)},
                                  {"read_bytes_per_query", mean(sums.bytes)}});
        if (!touched) row["queries"].back()["reason"] = touched.error;
    }
}

void add_slopes(const bench::TableType& type, Parts parts, nlohmann::json& row) {
    row["slopes_by_index_width"] = nlohmann::json::array();
    for (const studies::WidthSlope& slope : studies::slopes_by_width(type, parts)) {
        row["slopes_by_index_width"].push_back({{"offset_bits", slope.offset_bits},
                                                {"neighbour_bits", slope.neighbour_bits},
                                                {"least_vertices", slope.least_vertices},
                                                {"most_vertices", slope.most_vertices},
                                                {"bytes_per_edge", or_null(slope.bytes_per_edge)}});
        if (!slope.reason.empty()) row["slopes_by_index_width"].back()["reason"] = slope.reason;
    }
}

/// Bytes of a table with all its parts.
std::vector<measure::Figure> bytes_of(const bench::TableType& type, const Polyhedron& body) {
    const char* const algorithm = type.all_parts() == Parts::features ? "vclip" : "gjk";
    const auto runner = type.make_runner(algorithm);
    if (const std::string error = runner->load(std::vector{body}); !error.empty())
        throw std::invalid_argument(error);
    const scene::Workload no_queries;
    return bytes_probe()
        .measure({.type = type,
                  .algorithm = bench::algorithm_called(algorithm),
                  .runner = *runner,
                  .workload = no_queries})
        .figures;
}

nlohmann::json row_of(const bench::TableType& type, const scene::MeshBody& shape, bool slopes) {
    const Polyhedron body = type.stored_body(shape.body).or_throw();
    const Parts parts = type.all_parts();
    nlohmann::json row = {
        {"layout", type.layout}, {"precision", type.precision},     {"table", type.name},
        {"shape", shape.name},   {"vertices", body.vertex_count()}, {"edges", body.edge_count()}};
    for (const measure::Figure& figure : bytes_of(type, body)) {
        const bool component =
            std::find(component_names.begin(), component_names.end(), figure.name) != component_names.end();
        (component ? row["components"] : row)[figure.name] = or_null(figure.value);
    }
    row["input_order_bytes_per_edge"] =
        type.input_order_bytes ? nlohmann::json(static_cast<double>(type.input_order_bytes(body)) /
                                                static_cast<double>(body.edge_count()))
                               : nlohmann::json();
    row["bytes_per_vertex"] = row["table_bytes"].get<double>() / static_cast<double>(body.vertex_count());
    add_costs(type, body, parts, row);
    if (slopes) add_slopes(type, parts, row);
    return row;
}

void print_input_orders(const nlohmann::json& rows) {
    for (const auto& row : rows) {
        if (row["input_order_bytes_per_edge"].is_null()) continue;
        fmt::print(
            "{}: numbers vertices in an order of its own; {:.2f} more where it keeps the user's indices\n",
            row["table"].get<std::string>(), row["input_order_bytes_per_edge"].get<double>());
    }
}

/// Under the names that the report gives them; components that some table has.
void print_table(const nlohmann::json& rows) {
    std::string columns =
        "table type = table|#total = total_bytes_per_edge 1 2|"
        "#paper's subtotal (slope) = paper_bytes_per_edge 1 2|#total (slope) = slope_bytes_per_edge 1 2";
    for (const std::string_view component : component_names) {
        const std::string name(component);
        const auto has = [&](const auto& row) { return row["components"].value(name, 0.0) > 0; };
        if (std::any_of(rows.begin(), rows.end(), has))
            columns += fmt::format("|#{} = components/{} 1 2", reports::in_words(name), name);
    }
    fmt::print("bytes per edge; components that no table here has are left out\n{}",
               reports::rows_text(rows, columns));
    print_input_orders(rows);
}

void print_costs(nlohmann::json rows) {
    for (auto& row : rows)
        for (const auto& entry : row["queries"])
            row["lines"][entry["algorithm"].get<std::string>()] = entry["lines_per_query"];
    fmt::print(
        "\n{}{}\n",
        reports::rows_text(rows,
                           "table|#bytes = table_bytes 1 0|#object = object_bytes 1 0|"
                           "#constant = constant_bytes 1 0|#arena = allocators/0/taken_bytes|"
                           "#jemalloc = allocators/1/taken_bytes|#libc = allocators/2/taken_bytes|"
                           "#resident = allocators/0/resident_bytes|#vclip = lines/vclip 1 1|"
                           "#gjk = lines/gjk 1 1"),
        reports::wrapped("bytes: the table's own; its object beside it; what a body of these index widths "
                         "costs before its first edge, object included; what the table takes in each "
                         "allocator; pages in memory in the arena; distinct cache lines that a query of "
                         "V-Clip and of GJK touches in both tables, tumble at 0.1 rad per step"));
}

void print_slopes(const nlohmann::json& rows) {
    std::string columns = "table";
    for (std::size_t i = 0; i < rows[0]["slopes_by_index_width"].size(); ++i) {
        const auto& slope = rows[0]["slopes_by_index_width"][i];
        columns += fmt::format("|#{}/{} = slopes_by_index_width/{}/bytes_per_edge 1 2",
                               slope["offset_bits"].get<int>(), slope["neighbour_bits"].get<int>(), i);
    }
    fmt::print("\nbytes per additional edge, by bits of ring offsets and of neighbours at that size\n{}",
               reports::rows_text(rows, columns));
}

/// A row of each; of a layout that cannot hold the body a line on stderr, unless none can.
nlohmann::json rows_of(const BytesArguments& options, const scene::MeshBody& shape) {
    nlohmann::json rows = nlohmann::json::array();
    std::string refused;
    for (const bench::TableType* type : bench::select_table_types(options.layouts)) {
        if (const auto stored = type->stored_body(shape.body); !stored) {
            refused = fmt::format("{}: {}", type->name, stored.error);
            fmt::print(stderr, "left out: {}\n", refused);
        } else {
            rows.push_back(row_of(*type, shape, options.slopes));
        }
    }
    if (rows.empty()) throw std::invalid_argument(refused);
    return rows;
}

int run_bytes(const BytesArguments& options, bool json) {
    const scene::MeshBody shape = chosen_body(options.body);
    const nlohmann::json rows = rows_of(options, shape);
    if (json) {
        nlohmann::json out;
        out["rows"] = rows;
        for (const reports::Addition& addition : reports::additions())
            out["decompositions"] = addition.decompositions();
        print_json(out);
    } else {
        fmt::print("{}: {} vertices, {} edges\n", shape.name, shape.body.vertex_count(),
                   shape.body.edge_count());
        print_table(rows);
        print_costs(rows);
        if (options.slopes) print_slopes(rows);
        if (!options.footnotes) return exit_done;
        for (const reports::Addition& addition : reports::additions())
            fmt::print("\n{}", addition.decompositions_text());
    }
    return exit_done;
}

}  // namespace

void add_bytes(CLI::App& app, Context& context) {
    auto [command, options] = add_command(app, context, "bytes", "The bytes-per-edge ledger", run_bytes);
    add_shape_option(*command, options.body.shape, options.body.as_stored);
    add_layouts_option(*command, options.layouts);
    command->add_flag(
        "--slopes", options.slopes,
        "also the slope at every index width, over bodies of 8 to 100 000 vertices; takes a while");
    command->add_flag("--footnotes", options.footnotes,
                      "also the ways to reach the paper's 168 bytes per edge, which it gives as a sum");
}

}  // namespace edgewise::cli
