// SPDX-License-Identifier: MIT
//
// The format of a message: include/fcl/narrowphase/detail/failed_at_this_configuration.h and the shapes'
// representation() of FCL. Every word between "Shape 1" and the last row of X_FS2 is read.
#include "edgewise/scene/dumps/dump.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>

#include "edgewise/input/json_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/scene/nearest_rotation.hpp"

namespace edgewise::scene {
namespace {

constexpr std::string_view white_space = " \t\r\n";

constexpr const char* what_is_read =
    "judge reads a case line of JSON, a message of FCL or Drake (Shape 1, X_FS1, Shape 2, X_FS2), or body files "
    "(--a, --b, --pose-a, --pose-b); edgewise judge --template prints a case to fill in";

/// Says why a text of several lines is refused if its first line alone is a case.
std::string behind_first_case(std::string_view text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const bool more = text.find_first_not_of(white_space, end) != text.npos;
    if (!more || !input::parse_json(text.substr(0, end))) return {};
    return "; judge takes one case, and there is more text after the first line (edgewise query answers all of a file)";
}

/// Shortens a text for use in a message.
std::string shown(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(white_space), text.size()));
    return on_one_line(text.substr(0, std::min<std::size_t>(30, text.find('\n'))));
}

/// Removes the number that the text begins with, and returns it; nothing if the text begins with no number or
/// with one that is not finite.
std::optional<double> take_number(std::string_view& text) {
    std::string_view digits = text;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
    double value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    return value;
}

/// A text read word by word, blanks between them passed over.
class WordReader {
  public:
    explicit WordReader(std::string_view text) : rest_(text) {}

    /// Returns true if the word comes next; then it is skipped.
    bool take(std::string_view word) {
        skip_blanks();
        if (!rest_.starts_with(word)) return false;
        rest_.remove_prefix(word.size());
        return true;
    }
    /// Skips these words, which blanks separate here; # is any name. Returns false at the first that is
    /// missing.
    bool take_all(std::string_view words) {
        for (WordReader wanted(words); !wanted.at_end();) {
            const std::string_view word = wanted.rest_.substr(0, wanted.rest_.find(' '));
            if (!(word == "#" ? take_name() : take(word))) return false;
            wanted.rest_.remove_prefix(word.size());
        }
        return true;
    }
    [[nodiscard]] std::optional<double> number() {
        skip_blanks();
        return take_number(rest_);
    }
    [[nodiscard]] bool at_end() {
        skip_blanks();
        return rest_.empty();
    }
    /// The beginning of what is left, for a message.
    [[nodiscard]] std::string next() const { return shown(rest_); }

  private:
    void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(white_space), rest_.size())); }
    bool take_name() {
        skip_blanks();
        const auto end =
            std::ranges::find_if_not(rest_, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
        const auto size = static_cast<std::size_t>(end - rest_.begin());
        rest_.remove_prefix(size);
        return size > 0;
    }

    std::string_view rest_;
};

/// Without the '>' before the lines that a mail quotes.
std::string without_quotes(std::string_view text) {
    std::istringstream lines{std::string(text)};
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        std::size_t start = line.find_first_not_of(" \t");
        while (start != line.npos && line[start] == '>') start = line.find_first_not_of(" \t", start + 1);
        result += (start == line.npos ? "" : line.substr(start)) + "\n";
    }
    return result;
}

struct FclFault {
    std::string what;
};

[[noreturn]] void refuse_next(WordReader& text, std::string_view in) {
    const std::string next = text.next();
    throw FclFault{next.empty() ? fmt::format("{} is cut off", in)
                                : fmt::format("{} cannot be read from '{}' on", in, next)};
}

void expect(WordReader& text, std::string_view words, std::string_view in) {
    if (!text.take_all(words)) refuse_next(text, in);
}

double number_in(WordReader& text, std::string_view in) {
    const auto number = text.number();
    if (!number) refuse_next(text, in);
    return *number;
}

std::size_t count_in(WordReader& text, std::string_view in) {
    const double number = number_in(text, in);
    if (!(number >= 0 && number <= 1e9) || number != std::floor(number))
        throw FclFault{fmt::format("{}: {} is no whole number", in, number)};
    return static_cast<std::size_t>(number);
}

/// Behind "Box": "0.5 1 2", "<double>(0.5, 1, 2);".
std::vector<Vec3d> box(WordReader& text) {
    if (text.take("<")) expect(text, "# >", "the box");
    const bool called = text.take("(");
    Vec3d sides;
    for (int i = 0; i < 3; ++i) {
        if (i > 0) text.take(",");
        sides[i] = number_in(text, "the box");
        if (!(sides[i] > 0)) throw FclFault{fmt::format("the box has a side of {}", sides[i])};
    }
    if (called) expect(text, ")", "the box");
    text.take(";");
    std::vector<Vec3d> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(Vec3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1).cwiseProduct(sides / 2));
    return corners;
}

/// Vector3<double>(x, y, z), one after the other.
std::vector<Vec3d> vertices_in(WordReader& text) {
    constexpr std::string_view what = "a vertex of the Convex";
    std::vector<Vec3d> vertices;
    while (text.take("Vector3")) {
        expect(text, "< # > (", what);
        Vec3d v;
        for (int i = 0; i < 3; ++i) {
            if (i > 0) expect(text, ",", what);
            v[i] = number_in(text, what);
        }
        expect(text, ")", what);
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
            expect(text, ",", what);
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
    expect(text, "< # > ( std::make_shared < std::vector < Vector3 < # > > > (", what);
    expect(text, "std::initializer_list < Vector3 < # > > {", what);
    std::vector<Vec3d> vertices = vertices_in(text);
    expect(text, "} ) ,", what);
    const std::size_t faces = count_in(text, what);
    text.take(",");
    if (text.at_end()) return vertices;
    expect(text, "std::make_shared < std::vector < int > > ( std::initializer_list < int > {", what);
    check_faces(text, faces, vertices.size());
    expect(text, ") ,", what);
    if (!text.take("false")) expect(text, "true", what);
    expect(text, ")", what);
    text.take(";");
    return vertices;
}

/// Behind "Convex": "(v count: 16, f count: 28)", perhaps with the vertices added by hand.
std::vector<Vec3d> counted_convex(WordReader& text) {
    const std::size_t wanted = count_in(text, "the Convex");
    expect(text, ", f count:", "the Convex");
    static_cast<void>(count_in(text, "the Convex"));
    expect(text, ")", "the Convex");
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
                "a {} is no polyhedron; judge checks polyhedra only, so give vertices that approximate it",
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
                throw FclFault{fmt::format("row {} of {} has {} numbers and needs 4", i + 1, name, sizes[i])};
    }
    return all;
}

Pose fcl_pose(std::string_view section, const std::string& name, bool prose_may_follow, std::string& note) {
    const auto pose = pose_from_rows(rows_in(section, name, prose_may_follow), name);
    if (!pose) throw FclFault{pose.error};
    if (note.empty()) note = pose.warning;
    return *pose;
}

/// The message of FCL, without the path of the reporter's machine.
std::optional<ReportedAnswer> reported_in(std::string_view text) {
    constexpr std::string_view key = "Original error message:";
    const std::size_t at = text.find(key);
    if (at == text.npos) return std::nullopt;
    text = text.substr(at + key.size(), text.find('\n', at) - at - key.size());
    if (const std::size_t function = text.find("): "); function != text.npos)
        text.remove_prefix(function + 3);
    return ReportedAnswer{"FCL, as reported", fmt::format("threw: {}", text), std::nullopt};
}

/// Returns the text after each word of `words`, up to the next word. Throws if a word is missing or repeated.
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

/// Reads "Shape 1: ... X_FS1 ... Shape 2: ... X_FS2 ...", as FCL's ThrowDetailedConfiguration prints it:
/// since 2019 with columns apart by blanks, since 2023 as C++ with commas.
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

}  // namespace

Result<PastedPair> read_pasted(std::string_view text, const std::string& where) {
    using Pasted = Result<PastedPair>;
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // a byte order mark
    const std::size_t begin = text.find_first_not_of(white_space);
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
    return Pasted::failure(fmt::format("{}: cannot be read as a pair; {}", where, what_is_read));
}

Result<Pose> pose_from_rows(const std::vector<double>& m, const std::string& name) {
    using Failure = Result<Pose>;
    if (m.size() != 12 && m.size() != 16)
        return Failure::failure(fmt::format("{} has {} numbers and needs 12 or 16", name, m.size()));
    const bool affine = m.size() == 12 || (m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1);
    if (!affine) return Failure::failure(fmt::format("the fourth row of {} is not 0 0 0 1", name));
    Mat3d given;
    given << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
    const auto rotation = nearest_rotation(given);
    if (!rotation) return Failure::failure(fmt::format("the matrix of {} {}", name, rotation.error));
    const std::string& far = rotation.warning;
    return Result<Pose>::success({*rotation, {m[3], m[7], m[11]}},
                                 far.empty() ? "" : fmt::format("the matrix of {} {}", name, far));
}

Result<std::vector<double>> numbers_in(std::string_view text) {
    using Numbers = Result<std::vector<double>>;
    constexpr std::string_view separators = " \t\r\n,;[]";
    std::vector<double> numbers;
    for (;;) {
        const std::size_t next = std::min(text.find_first_not_of(separators), text.size());
        const std::string_view between = text.substr(0, next);
        const auto commas = std::ranges::count_if(between, [](char c) { return c == ',' || c == ';'; });
        const bool apart = numbers.empty() || next > 0 || next == text.size();
        if (commas > (numbers.empty() ? 0 : 1) || !apart)
            return Numbers::failure(fmt::format("'{}' has no number where one is wanted", shown(text)));
        text.remove_prefix(next);
        if (text.empty()) return Numbers::success(std::move(numbers));
        const std::string_view before = text;
        const auto number = take_number(text);
        if (!number) return Numbers::failure(fmt::format("'{}' is no number", shown(before)));
        numbers.push_back(*number);
    }
}

}  // namespace edgewise::scene
