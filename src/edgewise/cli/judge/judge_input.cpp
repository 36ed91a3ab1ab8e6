// SPDX-License-Identifier: MIT
#include "edgewise/cli/judge/judge_input.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <functional>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "edgewise/cli/options.hpp"
#include "edgewise/geometry/aabb.hpp"
#include "edgewise/input/count.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/scene/case_text.hpp"
#include "edgewise/scene/dumps/dump.hpp"

namespace edgewise::cli {

namespace {

/// Every point of a mesh file, because a pair is judged as it was given to the last bit; or a built-in body's
/// vertices.
scene::CaseBody body_called(const std::string& name, bool as_stored) {
    return {name, chosen_body({name, as_stored && scene::names_mesh_file(name)}, true).points, {}};
}

/// 3 numbers: a translation; 12 or 16: rows of a matrix with the translation last.
std::vector<double> pose_numbers(const std::string& text, const std::string& option) {
    auto numbers = input::parse_numbers(text);
    if (!numbers) throw std::invalid_argument(fmt::format("{} {}: {}", option, text, numbers.error));
    const std::size_t count = numbers->size();
    if (count != 3 && count != 12 && count != 16)
        throw std::invalid_argument(fmt::format(
            "{}: {} numbers; write x,y,z, or the 12 (or 16) numbers of a matrix, row by row", option, count));
    return *std::move(numbers);
}

Pose pose_from(const std::string& text, const std::string& option) {
    if (text.empty()) return {};
    const std::vector<double> m = pose_numbers(text, option);
    if (m.size() == 3) return {Mat3d::Identity(), {m[0], m[1], m[2]}};
    auto pose = scene::pose_from_rows(m, option);
    if (!pose.warning.empty()) warn(pose.warning + "; the nearest rotation is used");
    return std::move(pose).or_throw();
}

/// Refused on the command line already.
std::function<void(std::string)> is_pose(const char* option) {
    return [option](const std::string& text) { static_cast<void>(pose_numbers(text, option)); };
}

std::string text_from(const std::string& file) {
    if (file != "-") return input::read_file_text(file).or_throw();
    std::string text;
    char buffer[65536];
    while (std::cin.read(buffer, sizeof buffer), std::cin.gcount() > 0) {
        text.append(buffer, static_cast<std::size_t>(std::cin.gcount()));
        if (text.size() > input::most_text_bytes)
            throw std::invalid_argument(
                fmt::format("-: more than the {} bytes that are read of a text", input::most_text_bytes));
    }
    return text;
}

using Json = nlohmann::json;

Json json_of(const Vec3d& v) { return {v.x(), v.y(), v.z()}; }

Json json_of(const scene::CaseBody& body) {
    const Aabb box = box_of(body.vertices);
    return {{"vertices", body.vertices.size()},
            {"faces", body.faces ? Json(body.faces->size()) : Json()},
            {"low", json_of(box.low)},
            {"high", json_of(box.high)},
            {"extent", json_of(box.sides())}};
}

Json json_of(const Pose& pose) {
    const scene::Turn turn = scene::turn_of(pose.rotation);
    return {{"translation", json_of(pose.translation)},
            {"axis", turn.degrees == 0 ? Json() : json_of(turn.axis)},
            {"degrees", turn.degrees}};
}

}  // namespace

void add_judge_input(CLI::App& command, JudgeInput& input) {
    CLI::Option* const text = command.add_option(
        "pair", input.text, "a file, or - for stdin: a case line, or what FCL or Drake printed");
    CLI::Option* const a = add_shape_option(command, input.body_a, input.as_stored, "--a")->excludes(text);
    CLI::Option* const b = add_shape_option(command, input.body_b, input.as_stored, "--b");
    command.get_option("--as-stored")->needs(a);
    a->needs(b);
    b->needs(a);
    command.add_option("--pose-a", input.pose_a, "x,y,z, or a matrix of 12 or 16 numbers, row by row")
        ->type_name("NUMBERS")
        ->each(is_pose("--pose-a"))
        ->needs(a);
    command.add_option("--pose-b", input.pose_b, "x,y,z, or a matrix of 12 or 16 numbers, row by row")
        ->type_name("NUMBERS")
        ->each(is_pose("--pose-b"))
        ->needs(b);
}

scene::PastedPair read_judge_input(const JudgeInput& input) {
    if (input.text.empty() && input.body_a.empty())
        throw std::invalid_argument(
            "no pair: name a file or - for stdin, or --a and --b; --template prints a case to fill in");
    if (!input.text.empty()) {
        auto pasted = scene::read_pasted(text_from(input.text), input.text);
        if (!pasted.warning.empty())
            warn(fmt::format("{}: {}; the nearest rotation is used", input.text, pasted.warning));
        return std::move(pasted).or_throw();
    }
    return {{"meshes", body_called(input.body_a, input.as_stored), body_called(input.body_b, input.as_stored),
             pose_from(input.pose_a, "--pose-a"), pose_from(input.pose_b, "--pose-b")},
            scene::names_mesh_file(input.body_a) && scene::names_mesh_file(input.body_b) ? "mesh files"
                                                                                         : "named bodies",
            std::nullopt};
}

nlohmann::json read_json(const scene::PastedPair& pasted) {
    const scene::Case& pair = pasted.pair;
    return {{"a", json_of(pair.a)},
            {"pose_a", json_of(pair.pose_a)},
            {"b", json_of(pair.b)},
            {"pose_b", json_of(pair.pose_b)}};
}

void print_read(const scene::PastedPair& pasted) {
    const scene::Case& pair = pasted.pair;
    fmt::print("read: {}\n  A: {}\n     {}\n  B: {}\n     {}\n", pasted.format, scene::text_of(pair.a),
               scene::text_of(pair.pose_a), scene::text_of(pair.b), scene::text_of(pair.pose_b));
    std::fflush(stdout);  // before the verdict, and also where there is none
}

}  // namespace edgewise::cli
