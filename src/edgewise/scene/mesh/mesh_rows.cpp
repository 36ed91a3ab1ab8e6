// SPDX-License-Identifier: MIT

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <vector>

#include "edgewise/geometry/message.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/scene/mesh/mesh_parts.hpp"
#include "edgewise/scene/mesh/mesh_text.hpp"

namespace edgewise::scene {

namespace {

using Words = std::vector<std::string_view>;

struct PlyProperty {
    std::string_view count_type, type, name;  ///< no count: one number
};

struct PlyElement {
    std::string_view name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

/// Digits alone; none of anything else.
std::optional<std::uint64_t> count_of_word(std::string_view word) {
    std::uint64_t value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || stop != word.data() + word.size()) return std::nullopt;
    return value;
}

/// TextRows of text, each with some words; comments and empty lines are passed over.
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
    void check_coordinate(std::string_view word) const {
        if (const auto value = coordinate_from(word); !value) fail(value.error);
    }
    /// `count` words from `first` on are numbers of vertices.
    void check_corners(std::size_t first, std::size_t count, std::uint64_t vertices) const {
        for (std::size_t k = first; k < first + count && k < words_.size(); ++k) {
            const auto index = count_of_word(words_[k]);
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

struct Ply {
    bool is_text = false, is_big_endian = false;
    std::vector<PlyElement> elements;

    [[nodiscard]] std::uint64_t vertices() const {
        const auto found = std::ranges::find(elements, "vertex", &PlyElement::name);
        return found == elements.end() ? 0 : found->count;
    }
};

Ply ply_header(TextLines& lines) {
    Ply ply;
    while (lines.next()) {
        const Words words = words_of(lines.line());
        if (!words.empty() && words[0] == "end_header") break;
        if (words.size() < 3) continue;
        if (words[0] == "format") {
            ply.is_text = words[1] == "ascii";
            ply.is_big_endian = words[1] == "binary_big_endian";
        } else if (words[0] == "element") {
            ply.elements.push_back({words[1], count_of_word(words[2]).value_or(0), {}});
        } else if (words[0] == "property" && !ply.elements.empty()) {
            const bool is_list = words[1] == "list" && words.size() == 5;
            ply.elements.back().properties.push_back(is_list ? PlyProperty{words[2], words[3], words[4]}
                                                             : PlyProperty{"", words[1], words[2]});
        }
    }
    return ply;
}

void check_ply_row(const PlyElement& element, const TextRows& rows, std::uint64_t vertices) {
    std::size_t at = 0;
    for (const PlyProperty& property : element.properties) {
        const bool is_list = !property.count_type.empty();
        std::uint64_t count = 1;
        if (is_list && at < rows.words().size()) {
            const auto announced = count_of_word(rows.words()[at++]);
            if (!announced || *announced > rows.words().size())
                rows.check_width(element.name, at + announced.value_or(1));
            count = announced.value_or(1);
        }
        if (is_list && property.name.starts_with("vertex_ind")) rows.check_corners(at, count, vertices);
        const bool is_coordinate = property.name == "x" || property.name == "y" || property.name == "z";
        if (is_coordinate && at < rows.words().size()) rows.check_coordinate(rows.words()[at]);
        at += count;
    }
    rows.check_width(element.name, at);
}

/// Steps over rows of binary numbers.
class BinaryRows {
  public:
    BinaryRows(std::string_view bytes, bool is_big_endian) : rest_(bytes), is_big_endian_(is_big_endian) {}

    /// False where the bytes end before the row does.
    bool pass(const PlyElement& element) {
        for (const PlyProperty& property : element.properties) {
            std::uint64_t count = 1;
            if (!property.count_type.empty()) {
                const std::size_t width = ply_bytes(property.count_type);
                if (width > rest_.size()) return false;
                count = number(rest_.substr(0, width));
                rest_.remove_prefix(width);
            }
            const std::uint64_t width = ply_bytes(property.type);
            if (count > rest_.size() / width) return false;
            rest_.remove_prefix(count * width);
        }
        return true;
    }
    [[nodiscard]] std::string_view rest() const { return rest_; }

  private:
    [[nodiscard]] std::uint64_t number(std::string_view bytes) const {
        std::uint64_t value = 0;
        for (std::size_t k = 0; k < bytes.size(); ++k)
            value = value << 8 | static_cast<unsigned char>(bytes[is_big_endian_ ? k : bytes.size() - 1 - k]);
        return value;
    }

    std::string_view rest_;
    bool is_big_endian_;
};

void check_binary(const Ply& ply, std::string_view bytes) {
    BinaryRows rows(bytes, ply.is_big_endian);
    for (const PlyElement& element : ply.elements) {
        for (std::uint64_t row = 0; row < element.count; ++row) {
            if (!rows.pass(element))
                throw MeshFault{0, message("ends after ", row, " of ", element.count, " rows of '",
                                           element.name, "' that its header announces")};
        }
    }
    if (rows.rest().find_first_not_of("\r\n") != std::string_view::npos)
        throw MeshFault{0, message("has ", rows.rest().size(), " bytes more than its header announces")};
}

void check_ply(std::string_view bytes) {
    TextLines lines(bytes);
    const Ply ply = ply_header(lines);
    if (!ply.is_text) return check_binary(ply, lines.rest());
    TextRows rows(lines, false);
    for (const PlyElement& element : ply.elements) {
        for (std::uint64_t row = 0; row < element.count; ++row) {
            rows.need(element.name, row, element.count);
            check_ply_row(element, rows, ply.vertices());
        }
    }
    rows.end();
}

/// Checks OFF rows. With normals or colours a vertex has more than three numbers; a face may end in a colour.
void check_off(std::string_view text) {
    TextRows rows(TextLines(text), true);
    if (!rows.next()) return;
    Words counts = rows.words();
    const std::string magic = lowered(counts[0]);
    const bool is_plain = magic == "off", has_magic = magic.ends_with("off");
    if (magic == "4off" || magic == "noff4" || (counts.size() > 1 && lowered(counts[1]) == "binary")) return;
    if (has_magic) counts.erase(counts.begin());
    if (counts.empty() && rows.next()) counts = rows.words();
    const auto vertices = count_of_word(counts.empty() ? "" : counts[0]);
    const auto faces = count_of_word(counts.size() < 2 ? "" : counts[1]);
    if (!vertices || !faces) rows.fail("the numbers of vertices and faces should stand here");
    for (std::uint64_t row = 0; row < *vertices; ++row) {
        rows.need("vertices", row, *vertices);
        if (is_plain || !has_magic || rows.words().size() < 3) rows.check_width("vertices", 3);
        for (std::size_t axis = 0; axis < 3; ++axis) rows.check_coordinate(rows.words()[axis]);
    }
    for (std::uint64_t row = 0; row < *faces; ++row) {
        rows.need("faces", row, *faces);
        const auto corners = count_of_word(rows.words()[0]);
        if (!corners || *corners + 1 > rows.words().size())
            rows.check_width("faces", 1 + static_cast<std::size_t>(corners.value_or(3)));
        rows.check_corners(1, static_cast<std::size_t>(corners.value_or(0)), *vertices);
    }
    rows.end();
}

std::string error_of(void (*check)(std::string_view), std::string_view text) {
    try {
        check(text);
        return {};
    } catch (const MeshFault& fault) {
        return fault.line == 0 ? ": " + fault.what : message(":", fault.line, ": ", fault.what);
    }
}

}  // namespace

std::string ply_rows_error(std::string_view bytes) { return error_of(check_ply, bytes); }
std::string off_rows_error(std::string_view text) { return error_of(check_off, text); }

}  // namespace edgewise::scene
