// SPDX-License-Identifier: MIT
//
// Parses JSON with nlohmann-json and checks its content. Inside, the first fault is thrown as a JsonFault and
// caught once per line, so that checks read as plain statements.
#include "edgewise/scene/case_file.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/hull/point_set.hpp"
#include "edgewise/input/json_text.hpp"
#include "edgewise/scene/json_fields.hpp"
#include "edgewise/scene/mesh/mesh_text.hpp"
#include "edgewise/scene/nearest_rotation.hpp"

namespace edgewise::scene {
namespace {

void refuse_unknown(const Json& object, const std::string& what, const std::vector<std::string>& known) {
    if (!object.is_object()) return;
    if (const std::string unknown = input::unknown_member(object, what, known); !unknown.empty())
        throw JsonFault{unknown};
}

/// The members that a case is made of come first. The others are carried along and not read: sources, notes,
/// and what an answer should be (`expect`).
void refuse_unknown_members(const Json& line) {
    static const auto words = words_of(
        "id a b pose_a pose_b source expect note kind tags shapes offset max_extent ortho_err "
        "input_precision thread_says agrees_with_thread disagreement");
    static const std::vector<std::string> of_line(words.begin(), words.end()),
        of_body = {"vertices", "faces"}, of_pose = {"R", "t"};
    refuse_unknown(line, "a case line", of_line);
    for (const char* body : {"a", "b"})
        refuse_unknown(member(line, body), std::string("body ") + body, of_body);
    for (const char* pose : {"pose_a", "pose_b"}) refuse_unknown(member(line, pose), pose, of_pose);
}

/// Reports all members that a line lacks at once, so that the user need not fix them one by one.
void check_members(const Json& line) {
    std::vector<std::string> missing;
    if (member(line, "id").is_null()) missing.emplace_back("id");
    for (const char* body : {"a", "b"}) {
        const Json& value = member(line, body);
        if (value.is_null()) {
            missing.emplace_back(body);
        } else if (value.is_object() && member(value, "vertices").is_null()) {
            missing.push_back(std::string(body) + ".vertices");
        }
    }
    if (missing.empty()) return;
    if (missing.size() == 1) throw JsonFault{missing.front() + " is missing"};
    throw JsonFault{
        fmt::format("{} are missing; a case is {}", fmt::join(missing, ", "),
                    R"({"id": "1", "a": {"vertices": [[0,0,0], ...]}, "b": {"vertices": [...]}})")};
}

CaseBody body_of(const Json& line, const char* key, const std::string& where) {
    const std::string name = key;
    const Json& object = object_at(line, key, name);
    CaseBody body{fmt::format("{}: {}", where, name), {}, std::nullopt};
    const std::string field = name + ".vertices";
    const Json& vertices = array_at(object, "vertices", field);
    if (vertices.empty()) throw JsonFault{field + " is empty"};
    for (const Json& vertex : vertices) {
        body.vertices.push_back(point(vertex, fmt::format("{}[{}]", field, body.vertices.size())));
    }
    const Json& faces = member(object, "faces");
    if (!faces.is_null()) body.faces = faces_of(faces, body.vertices.size(), name + ".faces");
    return body;
}

/// Nine numbers, or three rows of three.
Mat3d matrix_of(const Json& list, const std::string& field) {
    if (!list.is_array()) throw JsonFault{fmt::format("{} is not an array", field)};
    const bool in_rows = std::ranges::any_of(list, [](const Json& row) { return row.is_array(); });
    if (!in_rows) return Eigen::Map<const Mat3d>(numbers<9>(list, field).data());
    if (list.size() != 3) throw JsonFault{fmt::format("{} has {} rows and needs 3", field, list.size())};
    Mat3d matrix;
    for (int i = 0; i < 3; ++i)
        matrix.row(i) = point(list[static_cast<std::size_t>(i)], fmt::format("{}[{}]", field, i));
    return matrix;
}

/// Pose of a body; members that are left out are the identity. `note` says if the matrix was replaced.
Pose pose_of(const Json& line, const char* key, std::string& note) {
    const std::string name = key;
    if (member(line, key).is_null()) return {};
    const Json& object = object_at(line, key, name);
    const Json &r = member(object, "R"), &t = member(object, "t");
    if (r.is_null() && t.is_null())
        throw JsonFault{name + " has neither R nor t; leave it out for the identity"};
    Pose pose;
    if (!t.is_null()) pose.translation = point(t, name + ".t");
    if (r.is_null()) return pose;
    const auto rotation = nearest_rotation(matrix_of(r, name + ".R"));
    if (!rotation) throw JsonFault{fmt::format("{}.R {}", name, rotation.error)};
    pose.rotation = *rotation;
    if (note.empty() && !rotation.warning.empty()) note = fmt::format("{}.R {}", name, rotation.warning);
    return pose;
}

/// Names text that begins as JSON but is no case line: a part of a longer text, or a list of cases.
std::string other_json(std::string_view text) {
    const bool opens = text.starts_with('{') || text.starts_with('[');
    if (!opens || !input::ends_inside(text)) return {};
    return "; the text ends inside an object or list: write each case on one line";
}

Json parse_line(std::string_view line) {
    auto parsed = input::parse_json(line);
    if (!parsed) throw JsonFault{parsed.error + other_json(line)};
    const bool list_of_cases = parsed->is_array() && !parsed->empty() && parsed->front().is_object();
    if (list_of_cases)
        throw JsonFault{
            fmt::format("the line is a list of {} cases: write each on a line of its own, without "
                        "the brackets and commas of the list",
                        parsed->size())};
    if (!parsed->is_object()) throw JsonFault{"the line is not a JSON object"};
    return *std::move(parsed.value);
}

}  // namespace

Result<Case> parse_case(std::string_view line, const std::string& where, std::string& id) {
    id.clear();
    try {
        const Json object = parse_line(line);
        const Json& name = member(object, "id");
        if (!name.is_null() && !name.is_string() && !name.is_number_integer())
            throw JsonFault{"id is neither a string nor a whole number"};
        if (!name.is_null()) id = name.is_string() ? name.get<std::string>() : name.dump();
        refuse_unknown_members(object);
        check_members(object);
        Case read{id, body_of(object, "a", where), body_of(object, "b", where), {}, {}};
        std::string note;
        read.pose_a = pose_of(object, "pose_a", note);
        read.pose_b = pose_of(object, "pose_b", note);
        return Result<Case>::success(std::move(read), note);
    } catch (const JsonFault& fault) {
        return Result<Case>::failure(fmt::format("{}: {}", where, fault.what));
    }
}

std::optional<Result<Case>> CaseReader::next() {
    std::string text;
    while (read_line(text)) {
        ++line_;
        const std::string where = fmt::format("{}:{}", name_, line_);
        if (text.size() > most_line_bytes) {
            id_.clear();
            stream_.setstate(std::ios::eofbit | std::ios::failbit);  // it may never end
            return Result<Case>::failure(fmt::format("{}: longer than {} bytes; nothing is read from here on",
                                                     where, most_line_bytes));
        }
        if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
        auto read = parse_case(text, where, id_);
        if (!read.warning.empty() && replaced_++ == 0)
            first_replaced_ = fmt::format("line {}: {}", line_, read.warning);
        return read;
    }
    return std::nullopt;
}

std::string CaseReader::rotation_note() const {
    if (replaced_ == 0) return {};
    return fmt::format("{}: {} {} a matrix that is nearly a rotation; the nearest rotation is used ({}{})",
                       name_, replaced_, replaced_ == 1 ? "line has" : "lines have",
                       replaced_ == 1 ? "" : "first ", first_replaced_);
}

bool CaseReader::read_line(std::string& line) {
    using Traits = std::istream::traits_type;
    line.clear();
    if (!stream_) return false;
    for (auto c = stream_.rdbuf()->sbumpc(); c != Traits::to_int_type('\n'); c = stream_.rdbuf()->sbumpc()) {
        if (c == Traits::eof()) {
            stream_.setstate(std::ios::eofbit);
            return !line.empty();
        }
        line += Traits::to_char_type(c);
        if (line.size() > most_line_bytes) return true;
    }
    return true;
}

Result<Polyhedron> body_from_case(const CaseBody& body) {
    const bool solid = flatness_error(body.vertices, distinct_points(body.vertices)).empty();
    Result<Polyhedron> result =
        body.faces && solid ? polyhedron_from_faces(body.vertices, *body.faces) : hull_of_any(body.vertices);
    if (!result) result.error = fmt::format("{}: {}", body.where, result.error);
    return result;
}

}  // namespace edgewise::scene
