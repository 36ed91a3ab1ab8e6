// SPDX-License-Identifier: MIT
#include "edgewise/scene/dumps/dump.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "edgewise/input/json_text.hpp"
#include "edgewise/scene/nearest_rotation.hpp"

namespace edgewise::scene {

namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

constexpr const char* what_is_read =
    "judge reads a case line of JSON, a message of FCL or Drake (Shape 1, X_FS1, Shape 2, X_FS2), or body files "
    "(--a, --b, --pose-a, --pose-b); edgewise judge --template prints a case to fill in";

/// Why a text of several lines is no case, if its first line is one.
std::string behind_first_case(std::string_view text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const bool more = text.find_first_not_of(" \t\r\n", end) != text.npos;
    if (!more || !input::parse_json(text.substr(0, end))) return {};
    return "; judge takes one case, and more stands behind the first line (edgewise query answers all of a file)";
}

}  // namespace

Result<PastedPair> read_pasted(std::string_view text, const std::string& where) {
    using Pasted = Result<PastedPair>;
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == text.npos) return Pasted::failure(fmt::format("{}: nothing in it; {}", where, what_is_read));
    if (text[begin] == '{' || text[begin] == '[') {
        text.remove_prefix(begin);
        std::string id;
        auto given = parse_case(text, where, id);
        if (!given) return Pasted::failure(given.error + behind_first_case(text));
        return Pasted::success({*std::move(given.value), "case line", std::nullopt}, given.warning);
    }
    if (text.find("X_FS1") != text.npos || text.find("Shape 1") != text.npos)
        return read_fcl_dump(text, where);
    return Pasted::failure(fmt::format("{}: is none of what is read; {}", where, what_is_read));
}

Result<Pose> pose_from_rows(const std::vector<double>& m, const std::string& name) {
    using Failure = Result<Pose>;
    if (m.size() != 12 && m.size() != 16)
        return Failure::failure(fmt::format("{} has {} numbers, wants 12 or 16", name, m.size()));
    const bool affine = m.size() == 12 || (m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1);
    if (!affine) return Failure::failure(fmt::format("the fourth row of {} is not 0 0 0 1", name));
    Mat3d given;
    given << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
    const auto rotation = nearest_rotation(given);
    if (!rotation) return Failure::failure(fmt::format("the matrix of {} {}", name, rotation.error));
    std::string note;
    if (!rotation.warning.empty()) note = fmt::format("the matrix of {} {}", name, rotation.warning);
    return Result<Pose>::success({*rotation, {m[3], m[7], m[11]}}, note);
}

}  // namespace edgewise::scene
