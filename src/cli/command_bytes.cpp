// SPDX-License-Identifier: MIT
//
// `edgewise bytes`: the bytes-per-edge ledger of tables that are really built. Tables hold all their parts
// here.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "edgewise/cli/command.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/mesh_file.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/sweep/table_bytes.hpp"

namespace edgewise::cli {

namespace {

struct Options {
    std::string shape = "sphere386";
    std::string mesh;
    std::vector<std::string> layouts = {"all"};
};

struct NamedBody {
    std::string name;
    Polyhedron body;
};

NamedBody chosen_body(const Options& options) {
    if (options.mesh.empty()) {
        auto body = make_shape(options.shape);
        if (!body) throw std::invalid_argument(body.error);
        return {options.shape, std::move(*body)};
    }
    auto bodies = read_mesh_file(options.mesh, MeshGrouping::one_hull);
    if (!bodies) throw std::invalid_argument(bodies.error);
    if (!bodies.warning.empty()) fmt::print(stderr, "edgewise: {}\n", bodies.warning);
    return {(*bodies)[0].name, std::move((*bodies)[0].body)};
}

const Probe& bytes_probe() {
    for (const auto& probe : registered_probes()) {
        if (probe->name() == "bytes") return *probe;
    }
    throw std::runtime_error("this program was built without the bytes probe (see probes/CMakeLists.txt)");
}

Polyhedron as_stored(const TableType& type, const Polyhedron& body) {
    auto stored = type.stored_body(body);
    if (!stored) throw std::invalid_argument(stored.error);
    return std::move(*stored);
}

nlohmann::json row_of(const TableType& type, const NamedBody& shape, SizeFamily& sizes) {
    const Polyhedron body = as_stored(type, shape.body);
    const bool walks =
        std::find(type.algorithms.begin(), type.algorithms.end(), "vclip") != type.algorithms.end();
    const Parts parts = walks ? Parts::features : Parts::support;
    Subject subject;
    subject.table = table_bytes(type.ledger(body, parts), body);
    subject.sizes = sizes.of(type, parts);
    nlohmann::json row = {
        {"layout", type.layout}, {"precision", type.precision},     {"table", type.name},
        {"shape", shape.name},   {"vertices", body.vertex_count()}, {"edges", body.edge_count()}};
    for (const Figure& figure : bytes_probe().figures(subject)) {
        const bool component =
            std::find(component_names.begin(), component_names.end(), figure.name) != component_names.end();
        (component ? row["components"] : row)[figure.name] =
            figure.value ? nlohmann::json(*figure.value) : nlohmann::json();
    }
    return row;
}

void print_table(const nlohmann::json& rows) {
    fmt::print("{:<12}{:>8}{:>8}{:>8}", "table", "paper", "total", "slope");
    for (const auto name : component_names) fmt::print("{:>20}", name);
    fmt::print("   (bytes per edge)\n");
    for (const auto& row : rows) {
        const auto cell = [&](const nlohmann::json& value, int width) {
            if (value.is_null()) {
                fmt::print("{:>{}}", "-", width);
            } else {
                fmt::print("{:>{}.2f}", value.get<double>(), width);
            }
        };
        fmt::print("{:<12}", row["table"].get<std::string>());
        for (const char* key : {"paper_bytes_per_edge", "total_bytes_per_edge", "slope_bytes_per_edge"}) {
            cell(row[key], 8);
        }
        for (const auto name : component_names) cell(row["components"][std::string(name)], 20);
        fmt::print("\n");
    }
}

int run(const Options& options, bool json) {
    const NamedBody shape = chosen_body(options);
    SizeFamily sizes;
    nlohmann::json rows = nlohmann::json::array();
    for (const TableType* type : select_table_types(options.layouts))
        rows.push_back(row_of(*type, shape, sizes));
    if (json) {
        fmt::print("{}\n", nlohmann::json{{"rows", rows}}.dump());
    } else {
        fmt::print("{}: {} vertices, {} edges\n", shape.name, shape.body.vertex_count(),
                   shape.body.edge_count());
        print_table(rows);
    }
    return exit_done;
}

}  // namespace

void add_bytes(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* command = add_command(app, context, "bytes", "The bytes-per-edge ledger");
    auto* shape = command->add_option("--shape", options->shape, "built-in shape")->capture_default_str();
    command->add_option("--mesh", options->mesh, "mesh file instead of a built-in shape")->excludes(shape);
    command->add_option("--layouts", options->layouts, "layouts or table types, e.g. aos soa_f32")
        ->delimiter(',');
    command->callback(
        [options, &context] { context.action = [=, &context] { return run(*options, context.json); }; });
}

}  // namespace edgewise::cli
