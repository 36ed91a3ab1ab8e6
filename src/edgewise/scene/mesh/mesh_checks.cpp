// SPDX-License-Identifier: MIT
//
// Checks of PLY and OFF files before Assimp reads them: what the header announces, then every row.
#include "edgewise/scene/mesh/mesh_parts.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>

#include "edgewise/geometry/message.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/scene/mesh/mesh_text.hpp"

namespace edgewise::scene {
namespace {

using Words = std::vector<std::string_view>;

/// A header of a hundred elements of a hundred properties each has less.
constexpr std::size_t most_header_bytes = std::size_t{1} << 20;
constexpr std::uint64_t largest_count = std::uint64_t{1} << 62;

/// Returns a word of digits as a number, at most largest_count; no value for any other word.
std::optional<std::uint64_t> count_in(std::string_view word) {
    if (word.empty() || word.find_first_not_of("0123456789") != word.npos) return std::nullopt;
    std::uint64_t value = 0;
    const auto error = std::from_chars(word.data(), word.data() + word.size(), value).ec;
    return error == std::errc{} ? std::min(value, largest_count) : largest_count;
}

std::string too_many(const std::string& what, std::uint64_t count, std::uint64_t bytes) {
    return message("announces ", count, " ", what, ", more than its ", bytes,
                   " bytes can hold: it is cut short or damaged");
}

struct PlyProperty {
    std::string_view count_type, type, name;  ///< no count_type: one number
};

struct PlyElement {
    std::string_view name;
    std::optional<std::uint64_t> announced;
    std::vector<PlyProperty> properties = {};

    [[nodiscard]] std::uint64_t count() const { return announced.value_or(0); }
};

struct Ply {
    bool is_text = false, is_big_endian = false, ends = false;
    std::vector<PlyElement> elements;

    [[nodiscard]] std::uint64_t vertices() const {
        const auto found = std::ranges::find(elements, "vertex", &PlyElement::name);
        return found == elements.end() ? 0 : found->count();
    }
    /// The least bytes that the rows of an element take.
    [[nodiscard]] std::uint64_t least_bytes(const PlyElement& element) const {
        std::uint64_t each = 0;
        for (const auto& [count_type, type, name] : element.properties)
            each += is_text ? 2 : ply_bytes(count_type.empty() ? type : count_type);
        each = std::max<std::uint64_t>(each, 1);
        return element.count() > largest_count / each ? largest_count : element.count() * each;
    }
};

/// Reads the header, and leaves the lines behind it.
Ply ply_header(TextLines& lines) {
    Ply ply;
    while (!ply.ends && lines.next()) {
        Words words = words_of(lines.line());
        ply.ends = !words.empty() && words[0] == "end_header";
        if (words.size() < 2) continue;
        const bool is_list = words[1] == "list" && words.size() == 5;
        words.resize(std::max<std::size_t>(words.size(), 3));
        if (words[0] == "format") {
            ply.is_text = words[1] == "ascii";
            ply.is_big_endian = words[1] == "binary_big_endian";
        } else if (words[0] == "element") {
            ply.elements.push_back({words[1], count_in(words[2])});
        } else if (words[0] == "property" && !ply.elements.empty()) {
            ply.elements.back().properties.push_back(is_list ? PlyProperty{words[2], words[3], words[4]}
                                                             : PlyProperty{"", words[1], words[2]});
        }
    }
    return ply;
}

std::string ply_error(std::string_view head, std::uint64_t file_bytes) {
    std::string first = lower_case(head.substr(0, head.find('\n')));
    if (first.ends_with('\r')) first.pop_back();
    if (first != "ply") return "cannot be read as a mesh: its first line is not 'ply'";
    TextLines lines(head);
    const Ply ply = ply_header(lines);
    if (!ply.ends) return "cannot be read as a mesh: its PLY header does not end";
    for (const PlyElement& element : ply.elements)
        if (!element.announced) return "cannot be read as a mesh: an element of its PLY header has no count";
    const std::uint64_t left = file_bytes - std::min(file_bytes, head.size() - lines.rest().size());
    const auto most = std::ranges::max_element(
        ply.elements, {}, [&](const PlyElement& element) { return ply.least_bytes(element); });
    // A text's last number needs no blank behind it.
    if (most == ply.elements.end() || ply.least_bytes(*most) <= left + 1) return {};
    return too_many(message("of '", most->name, "'"), most->count(), left);
}

/// The lines of a text that have words; comments and empty lines are passed over.
class TextRows {
  public:
    TextRows(TextLines lines, bool has_comments) : lines_(lines), has_comments_(has_comments) {}

    bool next() {
        while (lines_.next()) {
            const std::string_view line = lines_.line();
            words_ = words_of(has_comments_ ? line.substr(0, line.find('#')) : line);
            if (!words_.empty()) return true;
        }
        return false;
    }
    void need(std::string_view element, std::uint64_t row, std::uint64_t count) {
        if (!next())
            throw MeshFault{0, message("ends after ", row, " of ", count, " rows of '", element,
                                       "' that its header announces")};
    }
    void end() {
        if (next()) fail("more rows than the header announces");
    }
    [[nodiscard]] const Words& words() const { return words_; }
    [[noreturn]] void fail(const std::string& what) const { throw MeshFault{lines_.number(), what}; }

    void check_width(std::string_view element, std::size_t wanted) const {
        if (words_.size() != wanted)
            fail(message(words_.size(), " numbers, and a row of '", element, "' has ", wanted,
                         " here: is a count of the header wrong?"));
    }
    [[nodiscard]] std::uint64_t count_at(std::size_t place) const {
        const auto count = count_in(words_[place]);
        if (!count) fail(message("'", on_one_line(words_[place]), "' is no count"));
        return *count;
    }
    void check_coordinate(std::string_view word) const {
        if (const auto value = coordinate_from(word); !value) fail(value.error);
    }
    /// `count` words from `first` on are numbers of vertices.
    void check_corners(std::size_t first, std::size_t count, std::uint64_t vertices) const {
        for (std::size_t k = first; k < first + count && k < words_.size(); ++k) {
            const auto index = count_in(words_[k]);
            if (!index || *index >= vertices)
                fail(message("no vertex ", on_one_line(words_[k]), ": they are counted from 0 to ",
                             vertices - std::min<std::uint64_t>(vertices, 1)));
        }
    }

  private:
    TextLines lines_;
    bool has_comments_;
    Words words_;
};

struct OffHeader {
    std::string magic;  ///< "off", "coff" ...; none in some files
    Words counts;       ///< of vertices and faces; empty: the file has none
};

/// Reads the magic word and the counts, which may follow it on a line of their own.
OffHeader off_header(TextRows& rows) {
    OffHeader header;
    while (header.counts.empty() && rows.next()) {
        header.counts = rows.words();
        if (const std::string first = lower_case(header.counts[0]); first.ends_with("off")) {
            header.magic = first;
            header.counts.erase(header.counts.begin());
        }
    }
    header.counts.resize(header.counts.empty() ? 0 : std::max<std::size_t>(header.counts.size(), 2));
    return header;
}

/// Checks the counts of vertices and faces; a vertex takes at least "0 0 0\n", a face "0\n".
std::string off_error(std::string_view head, std::uint64_t file_bytes) {
    constexpr std::uint64_t vertex_bytes = 6, face_bytes = 2;
    TextRows rows(TextLines(head), true);
    const OffHeader header = off_header(rows);
    if (header.counts.empty()) return "cannot be read as a mesh: its OFF header has no counts";
    const auto vertices = count_in(header.counts[0]), faces = count_in(header.counts[1]);
    if (!vertices || !faces) return {};  // the check of the rows says what should be there
    if (*vertices > (file_bytes + 1) / vertex_bytes) return too_many("vertices", *vertices, file_bytes);
    if (*faces > (file_bytes + 1) / face_bytes) return too_many("faces", *faces, file_bytes);
    return {};
}

void check_ply_row(const PlyElement& element, const TextRows& rows, std::uint64_t vertices) {
    std::size_t at = 0;
    for (const PlyProperty& property : element.properties) {
        const bool is_list = !property.count_type.empty();
        std::uint64_t count = 1;
        if (is_list && at < rows.words().size()) {
            count = rows.count_at(at++);
            if (count > rows.words().size()) rows.check_width(element.name, at + count);
        }
        if (is_list && property.name.starts_with("vertex_ind")) rows.check_corners(at, count, vertices);
        const bool is_coordinate = property.name == "x" || property.name == "y" || property.name == "z";
        if (is_coordinate && at < rows.words().size()) rows.check_coordinate(rows.words()[at]);
        at += count;
    }
    rows.check_width(element.name, at);
}

/// Steps over a row of binary numbers. False where the bytes end before the row does.
bool pass_row(const PlyElement& element, bool is_big_endian, std::string_view& rest) {
    for (const PlyProperty& property : element.properties) {
        std::uint64_t count = 1;
        if (!property.count_type.empty()) {
            const std::size_t width = ply_bytes(property.count_type);
            if (width > rest.size()) return false;
            count = 0;
            for (std::size_t k = 0; k < width; ++k)
                count = count << 8 | static_cast<unsigned char>(rest[is_big_endian ? k : width - 1 - k]);
            rest.remove_prefix(width);
        }
        const std::uint64_t width = ply_bytes(property.type);
        if (count > rest.size() / width) return false;
        rest.remove_prefix(count * width);
    }
    return true;
}

void check_binary(const Ply& ply, std::string_view rest) {
    for (const PlyElement& element : ply.elements) {
        for (std::uint64_t row = 0; row < element.count(); ++row) {
            if (!pass_row(element, ply.is_big_endian, rest))
                throw MeshFault{0, message("ends after ", row, " of ", element.count(), " rows of '",
                                           element.name, "' that its header announces")};
        }
    }
    if (rest.find_first_not_of("\r\n") != std::string_view::npos)
        throw MeshFault{0, message("has ", rest.size(), " bytes more than its header announces")};
}

void check_ply(std::string_view bytes) {
    TextLines lines(bytes);
    const Ply ply = ply_header(lines);
    if (!ply.is_text) return check_binary(ply, lines.rest());
    TextRows rows(lines, false);
    for (const PlyElement& element : ply.elements) {
        for (std::uint64_t row = 0; row < element.count(); ++row) {
            rows.need(element.name, row, element.count());
            check_ply_row(element, rows, ply.vertices());
        }
    }
    rows.end();
}

/// Checks OFF rows. With normals or colours a vertex has more than three numbers; a face may end in a colour.
void check_off(std::string_view text) {
    TextRows rows(TextLines(text), true);
    const auto [magic, counts] = off_header(rows);
    const bool is_plain = magic == "off" || magic.empty();
    if (counts.empty() && magic.empty()) return;
    if (magic == "4off" || magic == "noff4" || (!counts.empty() && lower_case(counts[0]) == "binary")) return;
    const auto vertices = counts.empty() ? std::nullopt : count_in(counts[0]);
    const auto faces = counts.empty() ? std::nullopt : count_in(counts[1]);
    if (!vertices || !faces) rows.fail("the numbers of vertices and faces should be here");
    for (std::uint64_t row = 0; row < *vertices; ++row) {
        rows.need("vertices", row, *vertices);
        if (is_plain || rows.words().size() < 3) rows.check_width("vertices", 3);
        for (std::size_t axis = 0; axis < 3; ++axis) rows.check_coordinate(rows.words()[axis]);
    }
    for (std::uint64_t row = 0; row < *faces; ++row) {
        rows.need("faces", row, *faces);
        const std::uint64_t corners = rows.count_at(0);
        if (corners >= rows.words().size()) rows.check_width("faces", 1 + corners);
        rows.check_corners(1, corners, *vertices);
    }
    rows.end();
}

std::string error_of(void (*check)(std::string_view), std::string_view text) {
    try {
        check(text);
        return {};
    } catch (const MeshFault& fault) {
        return fault.text();
    }
}

}  // namespace

std::string ply_rows_error(std::string_view bytes) { return error_of(check_ply, bytes); }
std::string off_rows_error(std::string_view text) { return error_of(check_off, text); }

std::uint64_t ply_bytes(std::string_view type) {
    if (type == "double" || type == "float64") return 8;
    if (type.starts_with("int32") || type.starts_with("uint32") || type == "int" || type == "uint" ||
        type == "float" || type == "float32")
        return 4;
    return type == "short" || type == "ushort" || type == "int16" || type == "uint16" ? 2 : 1;
}

std::string mesh_header_error(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string head(most_header_bytes, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    std::error_code error;
    return mesh_header_error(std::filesystem::path(path).extension().string(), head,
                             std::filesystem::file_size(path, error));
}

std::string mesh_header_error(const std::string& ending, const std::string& head, std::uint64_t bytes) {
    const std::string format = lower_case(ending),
                      start = lower_case(head.substr(0, head.find_first_of("\r\n")));
    if (format == ".ply" || start.starts_with("ply")) return ply_error(head, bytes);
    if (format == ".off" || start.starts_with("off")) return off_error(head, bytes);
    return {};
}

}  // namespace edgewise::scene
