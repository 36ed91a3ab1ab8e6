// SPDX-License-Identifier: MIT
//
// `edgewise draw`: pictures of tables. Here: `draw layout NAME`, one body's table to scale.
#include <fmt/format.h>

#include "edgewise/bench/drawings.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/input/output_file.hpp"

namespace edgewise::cli {

namespace {

struct DrawArguments {
    std::string layout, svg;
    BodyChoice body = {.shape = "cube8"};
};

int run_draw(const DrawArguments& options, bool json) {
    const scene::MeshBody body = chosen_body(options.body);
    nlohmann::json drawings = nlohmann::json::array();
    const std::string names[] = {options.layout};
    for (const bench::TableType* type : bench::select_table_types(names)) {
        const std::string svg = bench::draw_layout(*type, body.name, body.body);
        if (!options.svg.empty() && drawings.empty()) input::write_output(options.svg, svg);
        if (!json) {
            fmt::print("{}", options.svg.empty() ? svg : options.svg + "\n");
            return exit_done;
        }
        drawings.push_back({{"table", type->name}, {"shape", body.name}, {"svg", svg}});
    }
    print_json(nlohmann::json{{"drawings", drawings}});
    return exit_done;
}

}  // namespace

void add_draw(CLI::App& app, Context& context) {
    CLI::App& draw = add_group(app, "draw", "Pictures of tables, and of what queries touch of them");
    add_heat(draw, context);
    auto [command, options] =
        add_command(draw, context, "layout",
                    "One body's table to scale: cache lines, bytes coloured by component", run_draw);
    command
        ->add_option("name", options.layout,
                     "layout or table type; of a layout its first precision, with --json all")
        ->required();
    add_shape_option(*command, options.body.shape, options.body.as_stored);
    add_svg_option(*command, options.svg);
}

}  // namespace edgewise::cli
