// SPDX-License-Identifier: MIT
#include "edgewise/scene/mesh/mesh_parts.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

#include "edgewise/geometry/message.hpp"
#include "edgewise/scene/mesh/mesh_text.hpp"

namespace edgewise::scene {
namespace {

/// A header of a hundred elements of a hundred properties each has less.
constexpr std::size_t most_header_bytes = std::size_t{1} << 20;

/// The file's first bytes.
std::string head_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string head(most_header_bytes, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

/// Nothing for what is no count; the largest one for what is larger.
std::optional<std::uint64_t> count_in(const std::string& word) {
    if (word.empty() || word.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc::result_out_of_range ? std::numeric_limits<std::uint64_t>::max() : value;
}

std::string too_many(const std::string& what, std::uint64_t count, std::uint64_t bytes) {
    return message("announces ", count, " ", what, ", more than its ", bytes,
                   " bytes can hold: it is cut short or damaged");
}

/// The elements that a PLY header announces, and the least bytes that they take.
class PlyHeader {
  public:
    /// Takes a line; false at the header's end.
    bool take(const std::string& line) {
        std::istringstream words(line);
        std::string word, second, third;
        words >> word >> second >> third;
        if (word == "format") ascii_ = second == "ascii";
        if (word == "element") {
            finish_element();
            name_ = second;
            count_ = count_in(third);
            valid_ = valid_ && count_.has_value();
        }
        if (word == "property") each_ += ascii_ ? 2 : ply_bytes(second == "list" ? third : second);
        if (word == "end_header") finish_element();
        return word != "end_header";
    }
    /// `bytes`: what follows the header.
    [[nodiscard]] std::string error(std::uint64_t bytes) const {
        if (!valid_) return "cannot be read as a mesh: an element of its PLY header has no count";
        // A text's last number needs no blank behind it.
        return most_bytes_ <= bytes + 1 ? "" : too_many("of '" + most_name_ + "'", most_count_, bytes);
    }

  private:
    void finish_element() {
        const std::uint64_t count = count_.value_or(0), each = std::max<std::uint64_t>(each_, 1);
        const std::uint64_t bytes =
            count > std::numeric_limits<std::uint64_t>::max() / each ? UINT64_MAX : count * each;
        if (!name_.empty() && bytes > most_bytes_) {
            most_bytes_ = bytes;
            most_count_ = count;
            most_name_ = name_;
        }
        each_ = 0;
        count_.reset();
    }

    bool ascii_ = false, valid_ = true;
    std::string name_, most_name_;
    std::optional<std::uint64_t> count_;
    std::uint64_t each_ = 0, most_bytes_ = 0, most_count_ = 0;
};

std::string ply_error(const std::string& head, std::uint64_t file_bytes) {
    std::istringstream lines(head);
    std::string line;
    const auto next = [&] {
        if (!std::getline(lines, line)) return false;
        if (line.ends_with('\r')) line.pop_back();
        return true;
    };
    if (!next() || lowered(line) != "ply") return "cannot be read as a mesh: its first line is not 'ply'";
    PlyHeader header;
    while (next()) {
        if (header.take(line)) continue;
        const std::uint64_t used = lines.eof() ? head.size() : static_cast<std::uint64_t>(lines.tellg());
        return header.error(file_bytes - std::min(file_bytes, used));
    }
    return "cannot be read as a mesh: its PLY header does not end";
}

/// Checks the counts of vertices and faces in the first line that is not empty, a comment or the magic word;
/// a vertex takes at least "0 0 0\n", a face "0\n".
std::string off_error(const std::string& head, std::uint64_t file_bytes) {
    constexpr std::uint64_t vertex_bytes = 6, face_bytes = 2;
    std::istringstream lines(head);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line.substr(0, line.find('#')));
        std::string vertices, faces;
        words >> vertices;
        if (lowered(vertices).ends_with("off")) words >> vertices;
        if (vertices.empty() || lowered(vertices).ends_with("off")) continue;
        words >> faces;
        const auto vertex_count = count_in(vertices), face_count = count_in(faces);
        if (!vertex_count || !face_count) return {};  // the parser says what it wants there
        if (*vertex_count > (file_bytes + 1) / vertex_bytes)
            return too_many("vertices", *vertex_count, file_bytes);
        if (*face_count > (file_bytes + 1) / face_bytes) return too_many("faces", *face_count, file_bytes);
        return {};
    }
    return "cannot be read as a mesh: its OFF header has no counts";
}

}  // namespace

std::uint64_t ply_bytes(std::string_view type) {
    if (type == "double" || type == "float64") return 8;
    if (type.starts_with("int32") || type.starts_with("uint32") || type == "int" || type == "uint" ||
        type == "float" || type == "float32")
        return 4;
    return type == "short" || type == "ushort" || type == "int16" || type == "uint16" ? 2 : 1;
}

std::string mesh_header_error(const std::string& path) {
    std::error_code error;
    return mesh_header_error(std::filesystem::path(path).extension().string(), head_of(path),
                             std::filesystem::file_size(path, error));
}

std::string mesh_header_error(const std::string& ending, const std::string& head, std::uint64_t bytes) {
    const std::string format = lowered(ending), start = lowered(head.substr(0, head.find_first_of("\r\n")));
    if (format == ".ply" || start.starts_with("ply")) return ply_error(head, bytes);
    if (format == ".off" || start.starts_with("off")) return off_error(head, bytes);
    return {};
}

}  // namespace edgewise::scene
