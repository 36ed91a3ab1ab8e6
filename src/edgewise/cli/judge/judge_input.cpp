// SPDX-License-Identifier: MIT
//
// OBJ files are read here by their vertex lines, in double: Assimp reads coordinates as float, and a pair is
// judged as it was given to the last bit.
#include "edgewise/cli/judge/judge_input.hpp"

#include <fmt/format.h>

#include <functional>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "edgewise/cli/command.hpp"
#include "edgewise/input/count.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/scene/dumps/dump_text.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"

namespace edgewise::cli {

namespace {

constexpr std::uint64_t most_mesh_bytes = std::uint64_t{1} << 30;

std::vector<Vec3d> obj_vertices(const std::string& path) {
    std::istringstream file(input::read_file_text(path, most_mesh_bytes).or_throw());
    std::vector<Vec3d> vertices;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("v ") && !line.starts_with("v\t")) continue;
        const auto numbers = scene::numbers_from(line, 1, 3);
        if (numbers.size() != 3)
            throw std::invalid_argument(fmt::format("{}: '{}' is no vertex of three numbers", path, line));
        vertices.emplace_back(numbers[0], numbers[1], numbers[2]);
    }
    if (vertices.empty()) throw std::invalid_argument(fmt::format("{}: no vertices in it", path));
    return vertices;
}

scene::CaseBody mesh_body(const std::string& path) {
    if (path.ends_with(".obj") || path.ends_with(".OBJ")) return {path, obj_vertices(path), {}};
    auto bodies = scene::read_mesh_file(path, scene::MeshGrouping::one_hull);
    if (bodies && !bodies.warning.empty()) warn(bodies.warning);
    const std::vector<scene::MeshBody> read = std::move(bodies).or_throw();
    warn(path + ": coordinates are read in single precision; an OBJ file is read as it is written");
    return {path, read.front().body.vertices, {}};
}

/// 3 numbers: a translation; 12 or 16: rows of a matrix with the translation last.
Pose pose_from(const std::string& text, const char* option) {
    const auto numbers = input::parse_numbers(text);
    if (!numbers) throw std::invalid_argument(fmt::format("{} {}: {}", option, text, numbers.error));
    const std::vector<double>& m = *numbers;
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

std::function<void(std::string)> is_pose(const char* option) {
    return [option](const std::string& text) { static_cast<void>(pose_from(text, option)); };
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
    a->needs(b);
    b->needs(a);
    command.add_option("--pose-a", input.pose_a, "x,y,z, or a matrix of 12 or 16 numbers, row by row")
        ->type_name("NUMBERS")
        ->each(is_pose("--pose-a"))
        ->needs(a);
    command.add_option("--pose-b", input.pose_b, "likewise of the second body")
        ->type_name("NUMBERS")
        ->each(is_pose("--pose-b"))
        ->needs(b);
}

scene::PastedPair read_judge_input(const JudgeInput& input) {
    if (input.text.empty() && input.mesh_a.empty())
        throw std::invalid_argument("no pair: name a file or - for stdin, or --a and --b; --help shows one");
    if (!input.text.empty()) return scene::read_pasted(text_from(input.text), input.text).or_throw();
    return {{"meshes", mesh_body(input.mesh_a), mesh_body(input.mesh_b), pose_from(input.pose_a, "--pose-a"),
             pose_from(input.pose_b, "--pose-b")},
            "mesh files",
            std::nullopt};
}

}  // namespace edgewise::cli
