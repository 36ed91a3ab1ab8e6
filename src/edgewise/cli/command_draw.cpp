// SPDX-License-Identifier: MIT
//
// `edgewise draw`: pictures of tables. `draw layout NAME`: one body's table to scale. `draw heat`: what one
// cell's queries touch of its tables: by field, by line, by component, and which vertices, edges and faces;
// as text, JSON or a picture.
#include <fmt/format.h>

#include "edgewise/bench/drawings.hpp"
#include "edgewise/bench/trace/touched_tables.hpp"
#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/measure/cache/heat_map.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::cli {

namespace {

struct HeatArguments {
    studies::CellChoice cell;
    std::string svg;
};

/// Lines of the tables alone: what follows them is the scene's.
std::span<const std::uint32_t> lines_of_tables(const measure::HeatMap& heat,
                                               const studies::SingleCell& cell) {
    const std::size_t lines = (cell.runner().table_allocator().taken() + 63) / 64;
    return std::span(heat.accesses_by_line()).first(std::min(lines, heat.accesses_by_line().size()));
}

/// Features of the first table, in the order in which the layout stores them.
nlohmann::json features(const bench::TableMap& map, const measure::TouchedBytes& touched) {
    nlohmann::json json = nlohmann::json::object();
    const std::pair<const char*, FeatureKind> kinds[] = {
        {"vertices", FeatureKind::vertex}, {"edges", FeatureKind::edge}, {"faces", FeatureKind::face}};
    for (const auto& [name, kind] : kinds) json[name] = or_null(bench::touched_features(map, touched, kind));
    return json;
}

/// A dash where there are none.
std::string mean_text(std::uint64_t sum, std::uint64_t queries) {
    if (queries == 0) return "-";
    return fmt::format("{:.2f}", static_cast<double>(sum) / static_cast<double>(queries));
}

void print(const measure::HeatMap& heat, const measure::TouchedTables& tables) {
    fmt::print("{} queries; {} lines accessed, {} take half of all accesses, {} take 90 %\n",
               heat.queries().all, heat.lines(), heat.lines_taking(0.5), heat.lines_taking(0.9));
    fmt::print("tables: {} of {} bytes touched, {:.1f} %\n", tables.bytes, tables.of_bytes,
               tables.of_bytes == 0
                   ? 0
                   : 100.0 * static_cast<double>(tables.bytes) / static_cast<double>(tables.of_bytes));
    reports::TextGrid parts{"", reports::columns_of("component or feature|#touched, %")};
    for (const auto& [component, part] : tables.by_component)
        parts.add(component, fmt::format("{:.2f}", 100 * part));
    const std::pair<const char*, std::optional<double>> features[] = {
        {"vertices", tables.vertices}, {"edges", tables.edges}, {"faces", tables.faces}};
    for (const auto& [name, part] : features)
        parts.add(name, part ? fmt::format("{:.2f}", 100 * *part) : "not apart");
    fmt::print(
        "\n{}of a component's bytes, those that any query read; of the features, those of which any byte "
        "was read\n",
        grid_text(parts));
    reports::TextGrid reads{"", reports::columns_of("per query that starts|#any way|#cold|#warm")};
    const auto add = [&](std::string_view what, const measure::ByStart<std::uint64_t>& sums) {
        reads.add(what, mean_text(sums.all, heat.queries().all), mean_text(sums.cold, heat.queries().cold),
                  mean_text(sums.warm, heat.queries().warm));
    };
    add("lines of tables", heat.lines_of_queries());
    const auto& by_field = heat.accesses_by_field();
    for (std::size_t i = 0; i < bench::field_names().size(); ++i)
        if (by_field.all[i] > 0)
            add(bench::field_names()[i], {by_field.all[i], by_field.cold[i], by_field.warm[i]});
    fmt::print("\n{}mean reads of a field, and lines of 64 bytes\n", grid_text(reads));
}

nlohmann::json by_start(const measure::ByStart<std::uint64_t>& counts) {
    return {{"all", counts.all}, {"cold", counts.cold}, {"warm", counts.warm}};
}

nlohmann::json json_of(const measure::HeatMap& heat, const measure::TouchedTables& tables,
                       const studies::SingleCell& cell) {
    nlohmann::json fields = nlohmann::json::object();
    for (std::size_t i = 0; i < bench::field_names().size(); ++i)
        if (const auto count = heat.accesses_by_field().all[i]; count > 0)
            fields[std::string(bench::field_names()[i])] = count;
    return {{"queries", heat.queries().all},
            {"queries_by_start", by_start(heat.queries())},
            {"lines_of_queries", by_start(heat.lines_of_queries())},
            {"accesses_by_field", fields},
            {"accesses_by_line", lines_of_tables(heat, cell)},
            {"touched_bytes", tables.bytes},
            {"table_bytes", tables.of_bytes},
            {"touched_by_component", tables.by_component},
            {"touched_parts",
             {{"vertices", or_null(tables.vertices)},
              {"edges", or_null(tables.edges)},
              {"faces", or_null(tables.faces)}}},
            {"touched_of_first_table", features(cell.runner().memory_maps().front(), heat.touched())}};
}

int run_heat(const HeatArguments& options, bool json) {
    const studies::SingleCell cell(options.cell);
    measure::HeatMap heat(bench::field_names().size(), bench::step_names().size());
    cell.runner().trace(bench::TraceExtent::everything(), heat);
    const measure::TouchedTables tables = bench::touched_tables(cell.runner().memory_maps(), heat.touched());
    if (!options.svg.empty()) {
        const std::string title =
            fmt::format("{} {}, {} {}, {} queries", options.cell.table, options.cell.algorithm,
                        options.cell.scene, bodies_of(options.cell), heat.queries().all);
        input::write_output(options.svg, bench::draw_heat(title, lines_of_tables(heat, cell)));
    }
    if (json) {
        print_json(json_of(heat, tables, cell));
    } else {
        fmt::print("{} {}, scene {}, shape {}\n", options.cell.table, options.cell.algorithm,
                   options.cell.scene, bodies_of(options.cell));
        print(heat, tables);
    }
    return exit_done;
}

void add_heat(CLI::App& draw, Context& context) {
    auto [command, options] = add_command(
        draw, context, "heat", "What one cell's queries touch of its tables, and how often", run_heat);
    add_cell_options(*command, options.cell);
    add_svg_option(*command, options.svg);
}

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
