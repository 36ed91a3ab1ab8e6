// SPDX-License-Identifier: MIT
#include "edgewise/scene/mesh/mesh_parts.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "edgewise/geometry/message.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/scene/mesh/mesh_text.hpp"

namespace edgewise::scene {

namespace {

using Words = std::vector<std::string_view>;

/// Statements that do not change the points: normals, textures, shading and levels of detail.
constexpr std::string_view passed_over[] = {"vt",        "vn",    "vp",       "s",        "mg",
                                            "lod",       "bevel", "c_interp", "d_interp", "shadow_obj",
                                            "trace_obj", "ctech", "stech",    "usemap"};

/// A face, line or point: places of its vertices in the file.
struct ObjElement {
    std::vector<Index> vertices;
    bool is_face = false;
};

struct ObjPart {
    std::string name;
    std::size_t first_vertex = 0;  ///< number of vertices before it
    std::vector<ObjElement> elements;
};

/// Returns the statement that begins on this line: without comments, and with the lines that a backslash
/// joins.
std::string whole_statement(TextLines& lines) {
    std::string statement;
    for (;;) {
        const std::string_view line = lines.line();
        statement += line.substr(0, line.find('#'));
        statement.resize(statement.find_last_not_of(" \t") + 1);
        if (!statement.ends_with('\\')) return statement;
        statement.back() = ' ';
        if (!lines.next()) return statement;
    }
}

/// x y z, then nothing, a weight of 1, or a colour of three numbers.
Result<Vec3d> vertex_from(const Words& words) {
    using Vertex = Result<Vec3d>;
    const std::size_t count = words.size() - 1;
    if (count != 3 && count != 4 && count != 6)
        return Vertex::failure(message(count, count == 1 ? " number" : " numbers",
                                       "; a vertex is x y z, with a weight of 1 or a colour r g b behind"));
    for (std::size_t k = 4; k < words.size(); ++k) {
        const auto more = coordinate_from(words[k]);
        if (!more) return Vertex::failure(more.error);
        if (count == 4 && *more != 1)
            return Vertex::failure(message("a weight of ", *more, "; only vertices of weight 1 are read"));
    }
    return point_from(words[1], words[2], words[3]);
}

class ObjReader {
  public:
    void read(std::string_view text) {
        TextLines lines(text);
        while (lines.next()) {
            line_ = lines.number();
            if (lines.line().find('\0') != std::string_view::npos) fail("a zero byte; OBJ files are text");
            const Words words = words_of(lines.line());
            if (words.empty() || words[0].starts_with('#') || words[0] == "mtllib") continue;
            if (words[0] == "o" || words[0] == "g" || words[0] == "usemtl") {
                take_name(words);  // which may hold # and a backslash
            } else {
                const std::string statement = whole_statement(lines);
                take(words_of(statement));
            }
        }
        line_ = farthest_line_;
        if (farthest_ > vertices_.size())
            fail(message("no vertex ", farthest_, ": the file has ", vertices_.size()));
    }

    Parts parts() const {
        std::vector<MeshPart> parts;
        const bool has_elements =
            std::ranges::any_of(parts_, [](const ObjPart& part) { return !part.elements.empty(); });
        std::vector<bool> used(vertices_.size(), !has_elements);
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            MeshPart part = has_elements ? with_elements(parts_[k], used) : points_of(k);
            if (!part.points.empty()) parts.push_back(std::move(part));
        }
        if (parts.empty()) return Parts::failure(": has no mesh inside");
        const auto unused = std::ranges::count(used, false);
        return Parts::success(std::move(parts),
                              unused == 0
                                  ? ""
                                  : message(unused, " of ", used.size(), " vertices ",
                                            unused == 1 ? "is" : "are", " named by no face and left out"));
    }

  private:
    [[noreturn]] void fail(const std::string& what) const { throw MeshFault{line_, what}; }

    void take(const Words& words) {
        if (words.empty()) return;
        if (words[0] == "v") {
            const auto vertex = vertex_from(words);
            if (!vertex) fail(vertex.error);
            vertices_.push_back(*vertex);
        } else if (words[0] == "f" || words[0] == "fo") {
            take_element(words, true);
        } else if (words[0] == "l" || words[0] == "p") {
            take_element(words, false);
        } else if (std::ranges::find(passed_over, words[0]) == std::end(passed_over)) {
            fail(message(
                "'", on_one_line(words[0]),
                "' is not a statement that is read from OBJ files; only points, lines and polygons are"));
        }
    }

    void take_element(const Words& words, bool is_face) {
        const std::size_t least = is_face ? 3 : words[0] == "l" ? 2 : 1;
        if (words.size() <= least)
            fail(message("'", words[0], "' with ", words.size() - 1, " vertices, and at least ", least,
                         " are needed"));
        ObjElement element{{}, is_face};
        for (std::size_t k = 1; k < words.size(); ++k) element.vertices.push_back(vertex_in(words[k]));
        parts_.back().elements.push_back(std::move(element));
    }

    /// Vertex named by 7, 7/1, 7/1/3 or 7//3: counted from 1, or, if negative, back from the last vertex.
    Index vertex_in(std::string_view word) {
        std::int64_t number = 0;
        const char* const end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), end, number);
        const std::string_view rest(stop, static_cast<std::size_t>(end - stop));
        const bool whole = rest.empty() || rest.starts_with('/');
        if (error != std::errc{} || !whole || rest.find_first_not_of("/-0123456789") != rest.npos)
            fail(message("'", on_one_line(word), "' is no vertex of a face; write 7, 7/1, 7/1/3 or 7//3"));
        if (number == 0) fail("vertex 0: OBJ counts vertices from 1");
        const auto known = static_cast<std::int64_t>(vertices_.size());
        if (number < -known)
            fail(message("no vertex ", number, ": ", known, known == 1 ? " vertex comes" : " vertices come",
                         " before this line"));
        if (number > std::numeric_limits<Index>::max())
            fail(message("no vertex ", number, ": too many for any mesh"));
        if (number > static_cast<std::int64_t>(farthest_)) {
            farthest_ = static_cast<std::size_t>(number);
            farthest_line_ = line_;
        }
        return static_cast<Index>(number < 0 ? known + number : number - 1);
    }

    /// A repeated name does not begin a part; nor does the first material, or a material after a part without
    /// elements.
    void take_name(const Words& words) {
        std::string name;
        for (std::size_t k = 1; k < words.size(); ++k) name += message(k > 1 ? " " : "", words[k]);
        const bool is_material = words[0] == "usemtl";
        std::string& current = is_material ? material_ : words[0] == "o" ? object_ : group_;
        const bool begins =
            name != current && !(is_material && (current.empty() || parts_.back().elements.empty()));
        current = name;
        if (begins) parts_.push_back({is_material ? parts_.back().name : name, vertices_.size(), {}});
    }

    /// Marks the vertices that it uses.
    MeshPart with_elements(const ObjPart& part, std::vector<bool>& used) const {
        std::vector<Index> places;
        for (const ObjElement& element : part.elements)
            places.insert(places.end(), element.vertices.begin(), element.vertices.end());
        std::ranges::sort(places);
        places.erase(std::unique(places.begin(), places.end()), places.end());
        MeshPart mesh{part.name, {}, {}};
        for (const Index place : places) {
            mesh.points.push_back(vertices_[place]);
            used[place] = true;
        }
        const auto here = [&](Index place) {
            return static_cast<Index>(std::ranges::lower_bound(places, place) - places.begin());
        };
        for (const ObjElement& element : part.elements) {
            const std::vector<Index>& ring = element.vertices;
            for (std::size_t k = 1; element.is_face && k + 1 < ring.size(); ++k)
                mesh.triangles.push_back({here(ring[0]), here(ring[k]), here(ring[k + 1])});
        }
        return mesh;
    }

    MeshPart points_of(std::size_t k) const {
        const std::size_t end = k + 1 < parts_.size() ? parts_[k + 1].first_vertex : vertices_.size();
        const auto at = [&](std::size_t i) { return vertices_.begin() + static_cast<std::ptrdiff_t>(i); };
        return {parts_[k].name, {at(parts_[k].first_vertex), at(end)}, {}};
    }

    std::vector<Vec3d> vertices_;
    std::vector<ObjPart> parts_ = std::vector<ObjPart>(1);
    std::string object_, group_, material_;
    std::size_t farthest_ = 0, farthest_line_ = 0;  ///< the largest number of a vertex that a face names
    std::size_t line_ = 0;                          ///< of the statement in hand, its first
};

}  // namespace

Parts obj_parts(std::string_view text) {
    ObjReader reader;
    try {
        reader.read(text);
        return reader.parts();
    } catch (const MeshFault& fault) {
        return Parts::failure(fault.text());
    }
}

}  // namespace edgewise::scene
