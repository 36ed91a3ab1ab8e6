// SPDX-License-Identifier: MIT
//
// golden_drawings FOLDER | --update FOLDER
//
// The pictures of three tables of a tetrahedron, beside the files they are kept in. A difference means that a
// layout or its drawing has changed; if it was meant to, --update, look at them, and commit them with it.
#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "edgewise/bench/drawings.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise {
namespace {

constexpr const char* drawn[] = {"aos_f64", "lean_f32", "points_soa_f64"};
constexpr const char* shape = "tetra4";

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

int run(const std::filesystem::path& folder, bool update) {
    int different = 0;
    for (const char* name : drawn) {
        const std::string names[] = {name};
        const std::string svg =
            bench::draw_layout(*bench::select_table_types(names).front(), shape, *scene::make_shape(shape));
        const std::filesystem::path file = folder / fmt::format("{}_{}.svg", name, shape);
        if (update) std::ofstream(file, std::ios::binary) << svg;
        if (text_of(file) == svg) continue;
        ++different;
        fmt::print(stderr, "{} is not what is drawn now\n", file.string());
    }
    fmt::print("{} of {} drawings differ\n", different, std::size(drawn));
    return different > 0 ? 1 : 0;
}

}  // namespace
}  // namespace edgewise

int main(int count, char** values) {
    const bool update = count == 3 && std::string(values[1]) == "--update";
    if (count != 2 && !update) {
        fmt::print(stderr, "usage: golden_drawings FOLDER | --update FOLDER\n");
        return 2;
    }
    return edgewise::run(values[count - 1], update);
}
