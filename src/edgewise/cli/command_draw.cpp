// SPDX-License-Identifier: MIT
//
// `edgewise draw layout NAME`: a picture of one body's table, as SVG on standard output.
#include <fmt/format.h>

#include <memory>

#include "edgewise/bench/drawings.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::cli {

namespace {

struct DrawArguments {
    std::string layout;
    std::string shape = "cube8";
};

int run_draw(const DrawArguments& options, bool json) {
    const Polyhedron body = scene::make_shape(options.shape).or_throw();
    nlohmann::json drawings = nlohmann::json::array();
    const std::string names[] = {options.layout};
    for (const bench::TableType* type : bench::select_table_types(names)) {
        const std::string svg = bench::draw_layout(*type, options.shape, body);
        if (!json) {
            fmt::print("{}", svg);
            return exit_done;
        }
        drawings.push_back({{"table", type->name}, {"shape", options.shape}, {"svg", svg}});
    }
    print_json(nlohmann::json{{"drawings", drawings}});
    return exit_done;
}

}  // namespace

void add_draw(CLI::App& app, Context& context) {
    CLI::App* draw = app.add_subcommand("draw", "Pictures: draw layout NAME");
    draw->require_subcommand(1);
    auto [command, options] =
        add_command(*draw, context, "layout",
                    "One body's table to scale: cache lines, bytes coloured by component", run_draw);
    command
        ->add_option("name", options.layout,
                     "layout or table type; of a layout its first precision, with --json all")
        ->required();
    command->add_option("--shape", options.shape, "built-in shape")->capture_default_str();
}

}  // namespace edgewise::cli
