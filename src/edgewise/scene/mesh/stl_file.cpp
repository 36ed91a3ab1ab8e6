// SPDX-License-Identifier: MIT
#include "edgewise/scene/mesh/mesh_parts.hpp"

#include <bit>
#include <cstring>

#include "edgewise/geometry/message.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/scene/mesh/mesh_text.hpp"

namespace edgewise::scene {

namespace {

constexpr std::size_t head_bytes = 84, facet_bytes = 50;  ///< the head ends in the count of facets
static_assert(std::endian::native == std::endian::little, "binary STL is copied as it lies");

std::uint64_t announced_facets(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + head_bytes - sizeof count, sizeof count);
    return count;
}

bool is_exactly_binary(std::string_view bytes) {
    return bytes.size() >= head_bytes && bytes.size() == head_bytes + facet_bytes * announced_facets(bytes);
}

bool is_text(std::string_view bytes) {
    TextLines lines(bytes);
    while (lines.next()) {
        const auto words = words_of(lines.line());
        if (!words.empty())
            return lower_case(words[0]) == "solid" && bytes.find('\0') >= head_bytes + facet_bytes;
    }
    return false;
}

std::string size_error(std::string_view bytes) {
    // The count of a binary of less than 2^24 facets ends in a zero.
    if (bytes.size() < head_bytes || bytes.find('\0') >= head_bytes)
        return message(": cannot be read as a mesh: its ", bytes.size(),
                       " bytes are neither a text that begins with 'solid' nor a binary STL");
    const std::uint64_t facets = announced_facets(bytes), wanted = head_bytes + facet_bytes * facets;
    const bool more = bytes.size() > wanted;
    return message(": announces ", facets, " facets, which make ", wanted, " bytes, and has ", bytes.size(),
                   ": ", more ? bytes.size() - wanted : wanted - bytes.size(),
                   more ? " too many" : " too few", "; export it again");
}

Parts binary_parts(std::string_view bytes) {
    MeshPart part{"", {}, {}, true};
    for (std::size_t facet = 0; facet < announced_facets(bytes); ++facet) {
        float numbers[12];  // the normal, then three points
        std::memcpy(numbers, bytes.data() + head_bytes + facet * facet_bytes, sizeof numbers);
        for (int corner = 1; corner <= 3; ++corner) {
            const float* const at = numbers + 3 * corner;
            const Vec3d point(double{at[0]}, double{at[1]}, double{at[2]});
            if (!point.array().isFinite().all())
                return Parts::failure(message(": facet ", facet + 1, ": (", point.x(), ", ", point.y(), ", ",
                                              point.z(), "); every coordinate must be a finite number"));
            part.points.push_back(point);
        }
        const auto first = static_cast<Index>(3 * facet);
        part.triangles.push_back({first, first + 1, first + 2});
    }
    if (part.points.empty()) return Parts::failure(": has no mesh inside");
    return Parts::success({std::move(part)});
}

/// Reads text STL word by word: a facet may take one line or seven.
class StlText {
  public:
    explicit StlText(std::string_view text) : lines_(text) {}

    std::vector<MeshPart> read() {
        std::vector<MeshPart> parts;
        while (has_word()) {
            expect("solid");
            MeshPart part{rest_of_line(), {}, {}};
            while (!has_word() || lower_case(words_[at_]) != "endsolid") take_facet(part);
            static_cast<void>(rest_of_line());
            if (!part.points.empty()) parts.push_back(std::move(part));
        }
        return parts;
    }

  private:
    [[noreturn]] void fail(const std::string& what) const { throw MeshFault{lines_.number(), what}; }

    /// Returns true if a word is left, on this line or below.
    bool has_word() {
        while (at_ == words_.size()) {
            if (!lines_.next()) return false;
            words_ = words_of(lines_.line());
            at_ = 0;
        }
        return true;
    }

    std::string_view word(std::string_view wanted) {
        if (!has_word()) fail(message("the file ends where '", wanted, "' should be: it is cut short"));
        return words_[at_++];
    }

    void expect(std::string_view wanted) {
        if (const std::string_view found = word(wanted); lower_case(found) != wanted)
            fail(message("'", on_one_line(found), "' where '", wanted, "' should be"));
    }

    std::string rest_of_line() {
        std::string name;
        for (; at_ < words_.size(); ++at_) name += message(name.empty() ? "" : " ", words_[at_]);
        return name;
    }

    void take_facet(MeshPart& part) {
        for (const char* keyword : {"facet", "normal"}) expect(keyword);
        for (int k = 0; k < 3; ++k) static_cast<void>(word("a number of the normal"));
        for (const char* keyword : {"outer", "loop"}) expect(keyword);
        const auto first = static_cast<Index>(part.points.size());
        for (int corner = 0; corner < 3; ++corner) {
            expect("vertex");
            const std::string_view x = word("x"), y = word("y"), z = word("z");
            const auto point = point_from(x, y, z);
            if (!point) fail(point.error);
            part.points.push_back(*point);
        }
        for (const char* keyword : {"endloop", "endfacet"}) expect(keyword);
        part.triangles.push_back({first, first + 1, first + 2});
    }

    TextLines lines_;
    std::vector<std::string_view> words_;
    std::size_t at_ = 0;  ///< the next of them
};

}  // namespace

Parts stl_parts(std::string_view bytes) {
    if (is_exactly_binary(bytes)) return binary_parts(bytes);
    if (!is_text(bytes)) return Parts::failure(size_error(bytes));
    try {
        std::vector<MeshPart> parts = StlText(bytes).read();
        if (parts.empty()) return Parts::failure(": has no mesh inside");
        return Parts::success(std::move(parts));
    } catch (const MeshFault& fault) {
        return Parts::failure(fault.text());
    }
}

}  // namespace edgewise::scene
