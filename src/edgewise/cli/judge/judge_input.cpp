// SPDX-License-Identifier: MIT
#include "edgewise/cli/judge/judge_input.hpp"

#include <fmt/format.h>

#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "edgewise/cli/command.hpp"
#include "edgewise/cli/parts/chosen_body.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/scene/dumps/dump_text.hpp"

namespace edgewise::cli {

namespace {

/// Every point of the mesh, since a pair is judged as it was given to the last bit.
scene::CaseBody body_from_mesh(const std::string& path, bool as_stored) {
    return {path, mesh_body(path, as_stored, true).points, {}};
}

/// 3 numbers: a translation; 12 or 16: rows of a matrix with the translation last.
Pose pose_from(const std::string& text, const char* option) {
    const auto m = scene::numbers_from(text, 0, 17);
    Pose pose;
    if (m.size() == 3) {
        pose.translation = {m[0], m[1], m[2]};
    } else if (m.size() == 12 || m.size() == 16) {
        pose.rotation << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
        pose.translation = {m[3], m[7], m[11]};
    } else if (!text.empty()) {
        throw std::invalid_argument(
            fmt::format("{}: {} numbers; write x,y,z, or the 12 (or 16) numbers of a matrix, row by row",
                        option, m.size()));
    }
    return pose;
}

std::string text_from(const std::string& file) {
    if (file != "-") return input::read_file_text(file).or_throw();
    return {std::istreambuf_iterator<char>(std::cin), {}};
}

}  // namespace

void add_judge_input(CLI::App& command, JudgeInput& input) {
    CLI::Option* const text = command.add_option(
        "pair", input.text,
        "a file, or - for stdin: a case line, what FCL or Drake printed, code for Coal, FCL or Bullet");
    CLI::Option* const a =
        command.add_option("--a", input.mesh_a, "mesh file of the first body")->excludes(text);
    CLI::Option* const b = command.add_option("--b", input.mesh_b, "mesh file of the second body");
    add_as_stored_option(command, input.as_stored)->needs(a);
    a->needs(b);
    b->needs(a);
    command.add_option("--pose-a", input.pose_a, "x,y,z, or a matrix of 12 or 16 numbers, row by row")
        ->needs(a);
    command.add_option("--pose-b", input.pose_b, "likewise of the second body")->needs(b);
}

scene::PastedPair read_judge_input(const JudgeInput& input) {
    if (input.text.empty() && input.mesh_a.empty())
        throw std::invalid_argument("no pair: name a file or - for stdin, or --a and --b; --help shows one");
    if (!input.text.empty()) return scene::read_pasted(text_from(input.text), input.text).or_throw();
    return {{"meshes", body_from_mesh(input.mesh_a, input.as_stored),
             body_from_mesh(input.mesh_b, input.as_stored), pose_from(input.pose_a, "--pose-a"),
             pose_from(input.pose_b, "--pose-b")},
            "mesh files",
            std::nullopt};
}

}  // namespace edgewise::cli
