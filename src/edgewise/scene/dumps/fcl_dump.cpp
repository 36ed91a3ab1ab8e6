// SPDX-License-Identifier: MIT
//
// Format: include/fcl/narrowphase/detail/failed_at_this_configuration.h and the shapes' representation() of
// FCL. Every word between "Shape 1" and the last row of X_FS2 is read.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <sstream>

#include "edgewise/scene/dumps/dump.hpp"

namespace edgewise::scene {

namespace {

struct FclFault {
    std::string what;
};

[[noreturn]] void refuse_next(WordReader& text, std::string_view in) {
    const std::string next = text.next();
    throw FclFault{next.empty() ? fmt::format("{} is cut off", in)
                                : fmt::format("{} cannot be read from '{}' on", in, next)};
}

double number_in(WordReader& text, std::string_view in) {
    const auto number = text.number();
    if (!number) refuse_next(text, in);
    return *number;
}

std::size_t count_in(WordReader& text, std::string_view in) {
    const double number = number_in(text, in);
    constexpr double most = 1e9;
    if (!(number >= 0 && number <= most) || number != std::floor(number))
        throw FclFault{fmt::format("{}: {} is no whole number", in, number)};
    return static_cast<std::size_t>(number);
}

/// The eight corners.
std::vector<Vec3d> box_corners(double x, double y, double z) {
    std::vector<Vec3d> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1 ? x / 2 : -x / 2, i & 2 ? y / 2 : -y / 2, i & 4 ? z / 2 : -z / 2);
    return corners;
}

/// Behind "Box": "0.5 1 2", "<double>(0.5, 1, 2);".
std::vector<Vec3d> box(WordReader& text) {
    if (text.take("<") && !text.take_all("# >")) refuse_next(text, "the box");
    const bool called = text.take("(");
    std::array<double, 3> sides{};
    for (std::size_t i = 0; i < 3; ++i) {
        if (i > 0) text.take(",");
        sides[i] = number_in(text, "the box");
        if (!(sides[i] > 0)) throw FclFault{fmt::format("the box has a side of {}", sides[i])};
    }
    if (called && !text.take(")")) refuse_next(text, "the box");
    text.take(";");
    return box_corners(sides[0], sides[1], sides[2]);
}

/// Vector3<double>(x, y, z), one after the other.
std::vector<Vec3d> vertices_in(WordReader& text) {
    constexpr std::string_view what = "a vertex of the Convex";
    std::vector<Vec3d> vertices;
    while (text.take("Vector3")) {
        if (!text.take_all("< # > (")) refuse_next(text, what);
        Vec3d v;
        for (int i = 0; i < 3; ++i) {
            if (i > 0 && !text.take(",")) refuse_next(text, what);
            v[i] = number_in(text, what);
        }
        if (!text.take(")")) refuse_next(text, what);
        text.take(",");
        vertices.push_back(v);
    }
    return vertices;
}

/// "3, 0, 1, 2, 4, ...}": the number of vertices before those of each face. They are not needed for the hull;
/// they show whether vertices are missing.
void check_faces(WordReader& text, std::size_t wanted, std::size_t vertices) {
    constexpr std::string_view what = "the list of faces";
    std::size_t faces = 0;
    for (; !text.take("}"); ++faces) {
        for (std::size_t left = count_in(text, what); left > 0; --left) {
            if (!text.take(",")) refuse_next(text, what);
            if (const std::size_t vertex = count_in(text, what); vertex >= vertices)
                throw FclFault{
                    fmt::format("a face of the Convex has vertex {}, counted from 0, but {} are given",
                                vertex, vertices)};
        }
        text.take(",");
    }
    if (faces != wanted)
        throw FclFault{fmt::format("the Convex says that it has {} faces, and {} are given", wanted, faces)};
}

/// Behind "Convex": the constructor that FCL prints from 2023 on. The text may end behind the vertices: they
/// are whole then.
std::vector<Vec3d> printed_convex(WordReader& text) {
    constexpr std::string_view what = "the Convex";
    if (!text.take_all("< # > ( std::make_shared < std::vector < Vector3 < # > > > (") ||
        !text.take_all("std::initializer_list < Vector3 < # > > {"))
        refuse_next(text, what);
    std::vector<Vec3d> vertices = vertices_in(text);
    if (!text.take_all("} ) ,")) refuse_next(text, what);
    const std::size_t faces = count_in(text, what);
    text.take(",");
    if (text.at_end()) return vertices;
    if (!text.take_all("std::make_shared < std::vector < int > > ( std::initializer_list < int > {"))
        refuse_next(text, what);
    check_faces(text, faces, vertices.size());
    if (!text.take_all(") ,") || !(text.take("false") || text.take("true")) || !text.take(")"))
        refuse_next(text, what);
    text.take(";");
    return vertices;
}

/// Behind "Convex": "(v count: 16, f count: 28)", perhaps with the vertices added by hand.
std::vector<Vec3d> counted_convex(WordReader& text) {
    const std::size_t wanted = count_in(text, "the Convex");
    if (!text.take_all(", f count:")) refuse_next(text, "the Convex");
    static_cast<void>(count_in(text, "the Convex"));
    if (!text.take(")")) refuse_next(text, "the Convex");
    std::vector<Vec3d> vertices = vertices_in(text);
    if (vertices.empty())
        throw FclFault{
            "this message gives of a Convex the counts alone; add its vertices: FCL from 2023 on prints them"};
    if (vertices.size() != wanted)
        throw FclFault{fmt::format("the Convex says that it has {} vertices, and {} are given", wanted,
                                   vertices.size())};
    return vertices;
}

void refuse_other_shape(std::string_view text) {
    for (const char* name : {"Sphere", "Ellipsoid", "Capsule", "Cone", "Cylinder"}) {
        if (text.starts_with(name))
            throw FclFault{fmt::format(
                "a {} is no polyhedron, and this judges polyhedra; give the vertices that stand for it",
                name)};
    }
    throw FclFault{fmt::format("the shape '{}' is neither a Box nor a Convex", text)};
}

std::vector<Vec3d> fcl_shape(std::string_view section) {
    WordReader text(section);
    text.take(":");
    std::vector<Vec3d> vertices;
    if (text.take("Box")) {
        vertices = box(text);
    } else if (text.take("Convex")) {
        vertices = text.take_all("( v count:") ? counted_convex(text) : printed_convex(text);
    } else {
        refuse_other_shape(text.next());
    }
    if (!text.at_end()) refuse_next(text, "the shape");
    return vertices;
}

/// Returns true if the line begins with a number, or with "nan" or "inf".
bool begins_row(const std::string& line) {
    std::string_view text = line;
    text.remove_prefix(std::min(text.find_first_not_of(" \t+-.,;["), text.size()));
    if (text.empty() || std::isdigit(static_cast<unsigned char>(text[0])) != 0) return true;
    return text.starts_with("nan") || text.starts_with("inf");
}

/// The rows of a matrix, one a line, or all in one line. Lines of prose may follow where the message is over.
std::vector<double> rows_in(std::string_view section, const std::string& name, bool prose_may_follow) {
    if (section.starts_with(':')) section.remove_prefix(1);
    std::istringstream lines{std::string(section)};
    std::vector<double> all;
    std::vector<std::size_t> sizes;
    for (std::string line; std::getline(lines, line);) {
        if (line.find_first_not_of(" \t\r") == line.npos) continue;
        if (prose_may_follow && !sizes.empty() && !begins_row(line)) break;
        const auto row = numbers_in(line);
        if (!row) throw FclFault{fmt::format("{}: {}", name, row.error)};
        sizes.push_back(row->size());
        all.insert(all.end(), row->begin(), row->end());
    }
    if (sizes.size() > 1 && (all.size() == 12 || all.size() == 16)) {
        for (std::size_t i = 0; i < sizes.size(); ++i)
            if (sizes[i] != 4)
                throw FclFault{fmt::format("row {} of {} has {} numbers, wants 4", i + 1, name, sizes[i])};
    }
    return all;
}

Pose fcl_pose(std::string_view section, const std::string& name, bool prose_may_follow, std::string& note) {
    const auto pose = pose_from_rows(rows_in(section, name, prose_may_follow), name);
    if (!pose) throw FclFault{pose.error};
    if (note.empty()) note = pose.warning;
    return *pose;
}

std::optional<ReportedAnswer> reported_in(std::string_view text) {
    constexpr std::string_view key = "Original error message:";
    const std::size_t at = text.find(key);
    if (at == text.npos) return std::nullopt;
    const std::size_t end = text.find('\n', at);
    std::string message(text.substr(at + key.size(), end - at - key.size()));
    // Without the path of the reporter's machine.
    if (const std::size_t function = message.find("): "); function != message.npos)
        message = message.substr(function + 3);
    return ReportedAnswer{"FCL, as reported", "threw: " + message, std::nullopt};
}

/// The texts behind each of these words, up to the next word; each word occurs in the text once.
template <std::size_t Count>
std::array<std::string_view, Count> sections_of(std::string_view text,
                                                const std::array<std::string_view, Count>& words) {
    std::array<std::size_t, Count> places{};
    std::array<std::string_view, Count> sections;
    for (std::size_t i = 0; i < Count; ++i) {
        places[i] = text.find(words[i], i == 0 ? 0 : places[i - 1]);
        if (places[i] == text.npos) throw FclFault{fmt::format("there is no '{}'", words[i])};
        if (text.find(words[i]) != places[i] || text.rfind(words[i]) != places[i])
            throw FclFault{fmt::format("'{}' is in it twice; judge takes one message", words[i])};
    }
    for (std::size_t i = 0; i < Count; ++i) {
        const std::size_t begin = places[i] + words[i].size();
        sections[i] = text.substr(begin, i + 1 < Count ? places[i + 1] - begin : text.npos);
    }
    return sections;
}

}  // namespace

Result<PastedPair> read_fcl_dump(std::string_view text, const std::string& where) {
    using Pasted = Result<PastedPair>;
    const std::string plain = without_quotes(text);
    try {
        const auto [shape_1, x_1, shape_2, x_2] =
            sections_of<4>(plain, {"Shape 1", "X_FS1", "Shape 2", "X_FS2"});
        PastedPair result{{"pasted", {where + ": shape 1", {}, {}}, {where + ": shape 2", {}, {}}, {}, {}},
                          "FCL dump",
                          reported_in(plain)};
        std::string note;
        result.pair.a.vertices = fcl_shape(shape_1);
        result.pair.b.vertices = fcl_shape(shape_2);
        result.pair.pose_a = fcl_pose(x_1, "X_FS1", false, note);
        result.pair.pose_b = fcl_pose(x_2.substr(0, x_2.find("Solver")), "X_FS2", true, note);
        return Pasted::success(std::move(result), note);
    } catch (const FclFault& fault) {
        return Pasted::failure(fmt::format("{}: {}", where, fault.what));
    }
}

}  // namespace edgewise::scene
