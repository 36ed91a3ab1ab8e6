// SPDX-License-Identifier: MIT
//
// Format: include/fcl/narrowphase/detail/failed_at_this_configuration.h and the shapes' representation() of
// FCL.
#include <fmt/format.h>

#include "edgewise/scene/dumps/dump.hpp"
#include "edgewise/scene/dumps/dump_text.hpp"

namespace edgewise::scene {

namespace {

struct FclFault {
    std::string what;
};

/// Between two words; to the end where the second is not there.
std::string_view section(std::string_view text, std::string_view from, std::string_view to) {
    const std::size_t begin = text.find(from);
    if (begin == text.npos) throw FclFault{fmt::format("there is no '{}'", from)};
    const std::size_t end = text.find(to, begin);
    return text.substr(begin + from.size(), end == text.npos ? text.npos : end - begin - from.size());
}

/// Every Vector3<...>(x, y, z).
std::vector<Vec3d> convex_vertices(std::string_view text) {
    std::vector<Vec3d> vertices;
    for (std::size_t at = text.find("Vector3<"); at != text.npos; at = text.find("Vector3<", at + 1)) {
        const std::size_t open = text.find_first_of("(>", at + 8);
        if (open == text.npos || text.substr(open, 2) != ">(") continue;  // of the list's own type
        const auto numbers = numbers_from(text, open + 1, 3);
        if (numbers.size() == 3) vertices.emplace_back(numbers[0], numbers[1], numbers[2]);
    }
    return vertices;
}

std::vector<Vec3d> fcl_shape(std::string_view text) {
    if (const std::size_t box = text.find("Box"); box != text.npos) {
        const std::size_t type = text.find('<', box);
        const std::size_t begin = type == box + 3 ? text.find('>', box) + 1 : box + 3;
        const auto sides = numbers_from(text, begin, 3);
        if (sides.size() == 3) return box_corners(sides[0], sides[1], sides[2]);
        throw FclFault{"the box has no three sides"};
    }
    if (text.find("Convex") == text.npos) {
        const std::string curved = curved_shape(text);
        throw FclFault{curved.empty() ? "a shape is neither a Box nor a Convex" : curved};
    }
    std::vector<Vec3d> vertices = convex_vertices(text);
    if (vertices.empty())
        throw FclFault{
            "this message gives of a Convex the counts alone; add its vertices: FCL from 2023 on prints them"};
    return vertices;
}

Pose fcl_pose(std::string_view text, const char* name) {
    const auto m = numbers_from(text, 0, 16);
    if (m.size() < 12) throw FclFault{fmt::format("{} has {} numbers, wants 12 or 16", name, m.size())};
    Pose pose;
    pose.rotation << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
    pose.translation = {m[3], m[7], m[11]};
    return pose;
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

}  // namespace

Result<PastedPair> read_fcl_dump(std::string_view text, const std::string& where) {
    using Pasted = Result<PastedPair>;
    const std::string plain = without_quotes_and_comments(text);
    try {
        PastedPair result{{"pasted", {where + ": shape 1", {}, {}}, {where + ": shape 2", {}, {}}, {}, {}},
                          "FCL dump",
                          reported_in(plain)};
        result.pair.a.vertices = fcl_shape(section(plain, "Shape 1", "X_FS1"));
        result.pair.b.vertices = fcl_shape(section(plain, "Shape 2", "X_FS2"));
        result.pair.pose_a = fcl_pose(section(plain, "X_FS1", "Shape 2"), "X_FS1");
        result.pair.pose_b = fcl_pose(section(plain, "X_FS2", "Solver"), "X_FS2");
        return Pasted::success(std::move(result));
    } catch (const FclFault& fault) {
        return Pasted::failure(fmt::format("{}: {}", where, fault.what));
    }
}

}  // namespace edgewise::scene
