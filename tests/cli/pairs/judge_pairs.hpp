// SPDX-License-Identifier: MIT
//
// Pairs for `edgewise judge`, and how its tests ask.
#pragma once

#include <nlohmann/json.hpp>

#include "cli_paths.hpp"
#include "program.hpp"

namespace edgewise::cli_test {

using nlohmann::json;

inline std::string dump(const std::string& name) { return text_of(std::string(dumps_folder) + "/" + name); }

/// Runs judge on the pair in a file, with a few table types; tests/corpus has all.
inline Outcome judge(const std::string& text, const Arguments& more = {}) {
    const Folder folder;
    folder.write("pair.txt", text);
    return run(with({"judge", "pair.txt", "--json", "--layouts", "aos_f64,lean_f64,points_soa_f64"}, more),
               folder);
}

inline json box(double x, double y, double z) {
    json corners = json::array();
    for (int i = 0; i < 8; ++i)
        corners.push_back({i & 1 ? x / 2 : -x / 2, i & 2 ? y / 2 : -y / 2, i & 4 ? z / 2 : -z / 2});
    return {{"vertices", corners}};
}

/// Two boxes, as reported to Coal (issues 144 and 685).
inline const std::string coal144 =
    json{{"id", "coal144"}, {"a", box(2, 2, 2)}, {"b", box(2, 2, 2)}, {"pose_b", {{"t", {1.9999, 0, 0}}}}}
        .dump();
inline const std::string coal685 = json{
    {"id", "coal685"},
    {"a", box(0.16, 0.27, 0.37)},
    {"b", box(5.898, 0.06, 2.69)},
    {"pose_a", {{"R", {{0, -1, 0}, {0, 0, 1}, {-1, 0, 0}}}, {"t", {1.490670, 0.845416, -0.194226}}}},
    {"pose_b",
     {{"t", {0, 1.075, 0.555}}}}}.dump();

}  // namespace edgewise::cli_test
