// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "cli_paths.hpp"
#include "edgewise/bench/drawings.hpp"
#include "edgewise/scene/shapes.hpp"
#include "frozen.hpp"

namespace edgewise::golden {

namespace {

using nlohmann::json;

std::string output_of(const cli_test::Arguments& arguments) {
    return golden::output_of(arguments, cli_test::Folder());
}

/// Leaves out blank lines, the program's folder, and the two lines that every command has.
std::string help_of(const cli_test::Arguments& arguments) {
    std::string help;
    for (std::string line : cli_test::lines_of(output_of(arguments))) {
        const std::string path = cli_test::program_path;
        if (const std::size_t at = line.find(path); at != std::string::npos)
            line.replace(at, path.size(), "edgewise");
        if (!line.empty() && !line.starts_with("  -h,--help ") && !line.starts_with("  --help-all "))
            help += line + "\n";
    }
    return help;
}

/// Help of the program and of each command. --help-all repeats these texts, so it is a hash.
std::string all_help() {
    std::string help = help_of({"--help"});
    for (const std::string& command : cli_test::listed_commands(cli_test::Folder()))
        help += fmt::format("== {}\n{}", command, help_of(cli_test::called(command, {"--help"})));
    return help + fmt::format("== --help-all\n{}\n", hash_of(help_of({"--help-all"})));
}

/// One line per element; short elements share a line.
std::string lines_of_array(const json& array) {
    constexpr std::size_t width = 1000;
    std::string lines, line;
    for (const json& element : array) {
        const std::string text = element.dump();
        const bool is_short = text.size() < 300;
        if (!line.empty() && (!is_short || line.size() + text.size() > width)) {
            lines += line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + text;
        if (is_short) continue;
        lines += line + "\n";
        line.clear();
    }
    return line.empty() ? lines : lines + line + "\n";
}

/// Names of all lists, from the message about an unknown list.
std::vector<std::string> names_of_lists() {
    const cli_test::Folder folder;
    const std::string said = cli_test::run({"list", "no_such_list"}, folder).err, mark = "known: ";
    std::vector<std::string> names;
    for (std::size_t at = said.find(mark) + mark.size(), end = at; end != std::string::npos; at = end + 2) {
        end = said.find(", ", at);
        names.push_back(said.substr(at, end == std::string::npos ? said.find('\n', at) - at : end - at));
    }
    return names;
}

std::string all_lists() {
    std::string lists;
    for (const std::string& name : names_of_lists()) {
        const json list = json::parse(output_of({"list", name, "--json"}));
        for (const auto& [key, elements] : list.items())
            lists += fmt::format("== {}: {}\n{}", name, key, lines_of_array(elements));
    }
    return lists;
}

/// Leaves out what allocators take, which depends on the C library.
std::string all_bytes() {
    json ledger = json::parse(output_of({"bytes", "--json"}));
    for (json& row : ledger["rows"]) row.erase("allocators");
    std::string lines;
    for (const auto& [key, elements] : ledger.items())
        lines += fmt::format("== {}\n{}", key, lines_of_array(elements));
    return lines;
}

}  // namespace

void add_drawings(Texts& texts) {
    constexpr const char* shape = "tetra4";
    for (const std::string name : {"aos_f64", "lean_f32", "points_soa_f64"})
        texts[fmt::format("{}_{}.svg", name, shape)] =
            bench::draw_layout(bench::table_type_called(name), shape, *scene::make_shape(shape));
}

void add_listings(Texts& texts) {
    texts["help.txt"] = all_help();
    texts["lists.txt"] = all_lists();
    texts["bytes.txt"] = all_bytes();
}

}  // namespace edgewise::golden
