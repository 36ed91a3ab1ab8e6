// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/decompositions.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace edgewise::reports {

namespace {

constexpr std::string_view known =
    R"(The paper says that "each additional edge requires 168 bytes of feature space information", that single precision
halves it, and that the prebuilt regions take "168 bytes for every edge in the model"; it does not list the terms.
Halving exactly asks for 21 real numbers and no pointer. The first reading, which the column "paper" shows, takes every
number of V-Clip's edge and the third of a vertex that an additional edge of a closed triangle mesh brings; against it
speaks that coordinates are hardly feature space. With list nodes and pointers allowed some 900 combinations reach 168,
so that a match alone proves nothing. Which one the authors meant cannot be told.
)";

}  // namespace

const std::vector<Decomposition>& decompositions() {
    static const std::vector<Decomposition> all = {
        {"4 planes (16) + direction (3) + length (1) + 1/3 vertex (1) reals", 168, 84,
         "every number of V-Clip's edge; leaves out face planes"},
        {"4 planes (16) + a face plane (4) + length (1) reals", 168, 84,
         "an edge that splits a face brings one; the direction is a plane's normal"},
        {"4 plane normals (12) + direction (3) + both ends' coordinates (6) reals", 168, 84,
         "offsets taken from the ends"},
        {"4 planes (16) + direction (3) + 1/2 face plane (2) reals", 168, 84, "quads: half a face per edge"},
        {"4 planes, direction, and 4 pointers of 32 bits", 168, 92, "does not halve"},
        {"4 planes, direction, length, and 2 pointers of 32 bits", 168, 88, "does not halve"},
        {"4 planes and 2 nodes of a face's list of 20 bytes", 168, 104, "does not halve"},
        {"4 planes, direction, length, 1/3 vertex, 2/3 face plane", 189.33, 94.67,
         "the first with face planes: aos without topology"},
        {"4 planes, direction, length", 160, 80, "the first without vertices"},
        {"4 planes", 128, 64, "Voronoi planes alone"},
        {"V-Clip's published edge structure, pointers of 32 bits", 184, 104,
         "by sizeof: two words more than the readings with pointers"},
    };
    return all;
}

nlohmann::json decompositions_json() {
    nlohmann::json result = nlohmann::json::array();
    for (const Decomposition& d : decompositions()) {
        result.push_back(
            {{"terms", d.terms}, {"f64", d.in_double}, {"f32", d.in_single}, {"remark", d.remark}});
    }
    return result;
}

std::string decompositions_text() {
    std::string text = fmt::format("{:<76}{:>8}{:>8}\n", "ways to 168 bytes per edge", "double", "single");
    for (const Decomposition& d : decompositions())
        text += fmt::format("{:<76}{:>8.4g}{:>8.4g}  {}\n", d.terms, d.in_double, d.in_single, d.remark);
    return text + std::string(known);
}

}  // namespace edgewise::reports
