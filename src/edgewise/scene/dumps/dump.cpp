// SPDX-License-Identifier: MIT
#include "edgewise/scene/dumps/dump.hpp"

#include <fmt/format.h>

#include <array>

namespace edgewise::scene {

std::vector<Vec3d> box_corners(double x, double y, double z) {
    std::vector<Vec3d> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1 ? x / 2 : -x / 2, i & 2 ? y / 2 : -y / 2, i & 4 ? z / 2 : -z / 2);
    return corners;
}

std::string curved_shape(std::string_view text) {
    constexpr std::array names = {"Sphere", "Cylinder", "Capsule", "Cone", "Ellipsoid"};
    for (const char* name : names) {
        const std::size_t at = text.find(name);
        if (at == text.npos) continue;
        return fmt::format(
            "a {} is no polyhedron, and this judges polyhedra; give the vertices that stand for it", name);
    }
    return {};
}

Result<PastedPair> read_pasted(std::string_view text, const std::string& where) {
    using Pasted = Result<PastedPair>;
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == text.npos)
        return Pasted::failure(where +
                               ": nothing in it; paste a case line, an FCL or Drake message, or code");
    if (text[begin] == '{') {
        std::string line(text.substr(begin));
        std::string id;
        auto given = parse_case(line.substr(0, line.find('\n')), where, id);
        // A case may be pasted over several lines.
        if (!given) given = parse_case(line, where, id);
        if (!given) return Pasted::failure(given.error);
        return Pasted::success({*std::move(given), "case line", std::nullopt});
    }
    return text.find("Shape 1") != text.npos ? read_fcl_dump(text, where) : read_code_dump(text, where);
}

}  // namespace edgewise::scene
