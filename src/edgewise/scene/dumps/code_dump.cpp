// SPDX-License-Identifier: MIT
//
// No compiler: shapes are taken in the order in which the text makes them, poses by the names they are set
// on.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>

#include "edgewise/scene/dumps/dump.hpp"
#include "edgewise/scene/dumps/dump_text.hpp"

namespace edgewise::scene {

namespace {

struct CodeFault {
    std::string what;
};

struct Shape {
    std::size_t at;  ///< where the text makes it
    std::vector<Vec3d> vertices;
};

/// Calls use(position behind the word) for each place where the word stands by itself.
template <class Use>
void each_word(std::string_view text, std::string_view word, const Use& use) {
    const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if (at > 0 && is_word(text[at - 1])) continue;
        if (end < text.size() && is_word(text[end])) continue;
        use(at, end);
    }
}

/// Box(1, 2, 3), Box shape1(1, 2, 3), make_shared<coal::Box>(1, 2, 3), Box<double>{1, 2, 3}.
void add_boxes(std::string_view text, std::vector<Shape>& shapes) {
    each_word(text, "Box", [&](std::size_t at, std::size_t end) {
        const std::size_t open = text.find_first_of("({;\n", end);
        if (open == text.npos || text[open] == ';' || text[open] == '\n') return;
        const auto sides = numbers_from(text, open, 3);
        if (sides.size() == 3) shapes.push_back({at, box_corners(sides[0], sides[1], sides[2])});
    });
    each_word(text, "btBoxShape", [&](std::size_t at, std::size_t end) {
        const std::size_t vector = text.find("btVector3", end);
        if (vector == text.npos) return;
        const auto half = numbers_from(text, vector + 9, 3);
        if (half.size() == 3) shapes.push_back({at, box_corners(2 * half[0], 2 * half[1], 2 * half[2])});
    });
}

/// What a btVector3 is put into: "hullA" of hullA.addPoint(btVector3(...)) and of hullA[3] = btVector3(...).
std::string holder_of(std::string_view text, std::size_t vector) {
    const std::size_t line = text.find_last_of(";{}\n", vector);
    const std::size_t begin = text.find_first_not_of(" \t", line == text.npos ? 0 : line + 1);
    std::size_t end = begin;
    while (end < vector && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_'))
        ++end;
    const std::string_view rest = text.substr(end, vector - end);
    const bool is_point =
        rest.find("addPoint") != rest.npos || rest.find("push_back") != rest.npos || rest.starts_with("[");
    return is_point ? std::string(text.substr(begin, end - begin)) : "";
}

void add_bullet_hulls(std::string_view text, std::vector<Shape>& shapes) {
    std::map<std::string, std::size_t> places;  // of shapes, by what holds their points
    each_word(text, "btVector3", [&](std::size_t at, std::size_t end) {
        const std::string holder = holder_of(text, at);
        const auto numbers = numbers_from(text, end, 3);
        if (holder.empty() || numbers.size() < 3) return;
        const auto [place, is_new] = places.try_emplace(holder, shapes.size());
        if (is_new) shapes.push_back({at, {}});
        shapes[place->second].vertices.emplace_back(numbers[0], numbers[1], numbers[2]);
    });
}

/// [[x, y, z], [x, y, z], ...]: rows of three.
void add_arrays(std::string_view text, std::vector<Shape>& shapes) {
    for (std::size_t at = text.find("[["); at != text.npos; at = text.find("[[", at + 1)) {
        std::vector<Vec3d> rows;
        for (std::size_t row = at + 1; row < text.size() && text[row] == '[';) {
            const std::size_t end = text.find(']', row);
            const auto numbers = numbers_from(text.substr(0, end), row, 4);
            if (end == text.npos || numbers.size() != 3) break;
            rows.emplace_back(numbers[0], numbers[1], numbers[2]);
            row = text.find_first_not_of(" \t\r\n,", end + 1);
        }
        if (!rows.empty() && !(rows.size() == 3 && name_before(text, at) == "rotation"))
            shapes.push_back({at, std::move(rows)});
    }
}

Mat3d rotation_of(const std::vector<double>& numbers) {
    if (numbers.size() == 9) return Eigen::Map<const Mat3d>(numbers.data());
    const double x = numbers[0], y = numbers[1], z = numbers[2], w = numbers[3];
    const double s = 2 / (x * x + y * y + z * z + w * w);
    Mat3d r;
    r << 1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w), s * (x * y + z * w),
        1 - s * (x * x + z * z), s * (y * z - x * w), s * (x * z - y * w), s * (y * z + x * w),
        1 - s * (x * x + y * y);
    return r;
}

/// 1 or a: the first body; 2 or b: the second. By the last letter or figure that says so.
std::optional<int> body_of(const std::string& name) {
    for (auto c = name.rbegin(); c != name.rend(); ++c) {
        if (*c == '1' || *c == 'A') return 0;
        if (*c == '2' || *c == 'B') return 1;
    }
    if (name == "a" || name.ends_with("_a")) return 0;
    if (name == "b" || name.ends_with("_b")) return 1;
    return std::nullopt;
}

/// A word that sets a part of a pose, and how many numbers follow.
struct Setter {
    const char* word;
    bool turns;
};
constexpr std::array setters = {Setter{"setTranslation", false}, Setter{"translation", false},
                                Setter{"setOrigin", false},      Setter{"setRotation", true},
                                Setter{"rotation", true},        Setter{"setBasis", true}};

/// Numbers of a call, behind the name of a type if one stands there: (np.array([1, 2, 3])), (btVector3(1, 2,
/// 3)).
std::vector<double> call_numbers(std::string_view text, std::size_t from, std::size_t most) {
    const std::size_t end = text.find(';', from);
    const std::string_view call = text.substr(from, (end == text.npos ? text.size() : end) - from);
    constexpr std::array types = {"btVector3", "btMatrix3x3", "btQuaternion", "array",   "Vec3f",
                                  "Vec3s",     "Vector3<S>",  "Vector3d",     "Matrix3f"};
    std::size_t begin = 0;
    for (const std::string_view type : types) {
        const std::size_t at = call.find(type);
        if (at != call.npos && at < 40) begin = std::max(begin, at + type.size());
    }
    return numbers_from(call, begin == 0 ? call.find_first_of("(<=") : begin, most);
}

void set_poses(std::string_view text, std::array<Pose, 2>& poses) {
    for (const Setter& setter : setters) {
        each_word(text, setter.word, [&](std::size_t at, std::size_t end) {
            std::size_t from = end;
            if (text.substr(end, 2) == "()") from = end + 2;  // rotation() << ...
            const auto numbers = call_numbers(text, from, setter.turns ? 9 : 3);
            const bool right =
                setter.turns ? numbers.size() == 9 || numbers.size() == 4 : numbers.size() == 3;
            if (!right) return;
            std::size_t dot = at;
            while (dot > 0 && (text[dot - 1] == '.' || text[dot - 1] == '>' || text[dot - 1] == '-')) --dot;
            const std::string name = name_before(text, dot);
            const auto body = body_of(name);
            if (!body)
                throw CodeFault{fmt::format("it does not say which body '{}' places; call it {}1 or {}2",
                                            name, name, name)};
            Pose& pose = poses[static_cast<std::size_t>(*body)];
            if (setter.turns) {
                pose.rotation = rotation_of(numbers);
            } else {
                pose.translation = {numbers[0], numbers[1], numbers[2]};
            }
        });
    }
}

std::vector<Shape> shapes_in(std::string_view text) {
    std::vector<Shape> shapes;
    add_boxes(text, shapes);
    add_bullet_hulls(text, shapes);
    add_arrays(text, shapes);
    std::ranges::sort(shapes, {}, &Shape::at);
    if (shapes.size() == 2) return shapes;
    const std::string curved = curved_shape(text);
    throw CodeFault{
        fmt::format("{} shapes are in it, wants two: Box(x, y, z), btBoxShape(btVector3(...)), points as "
                    "btVector3 or rows [[x, y, z], ...]; or a case line, or an FCL message{}{}",
                    shapes.size(), curved.empty() ? "" : "; ", curved)};
}

}  // namespace

Result<PastedPair> read_code_dump(std::string_view text, const std::string& where) {
    using Pasted = Result<PastedPair>;
    const std::string plain = without_quotes_and_comments(text);
    try {
        std::vector<Shape> shapes = shapes_in(plain);
        std::array<Pose, 2> poses;
        set_poses(plain, poses);
        return Pasted::success({{"pasted",
                                 {where + ": first shape", std::move(shapes[0].vertices), {}},
                                 {where + ": second shape", std::move(shapes[1].vertices), {}},
                                 poses[0],
                                 poses[1]},
                                "code",
                                std::nullopt});
    } catch (const CodeFault& fault) {
        return Pasted::failure(fmt::format("{}: {}", where, fault.what));
    }
}

}  // namespace edgewise::scene
