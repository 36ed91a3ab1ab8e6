// SPDX-License-Identifier: MIT
//
// The Hilbert index follows Skilling ("Programming the Hilbert curve", AIP Conference Proceedings 707, 2004):
// undo the excess turns bit by bit, then encode in Gray code.
#include "edgewise/geometry/vertex_order.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "edgewise/geometry/aabb.hpp"
#include "edgewise/geometry/polyhedron_builder.hpp"

namespace edgewise {
namespace {

/// Returns the key that sorts vertices: fewest neighbours first, then by index.
auto degree_in(const Polyhedron& body) {
    return [&body](Index v) { return std::pair(body.ring_of_vertex(v).size(), v); };
}

/// Vertices in breadth-first order: neighbours of a vertex follow it by their degrees, or in ring order.
struct Levels {
    std::vector<Index> order;
    std::size_t count = 0, last_begins = 0;  ///< levels, and where the last one starts in `order`

    Levels(const Polyhedron& body, Index root, bool by_degree = true) : order{root} {
        std::vector<bool> met(body.vertex_count());
        met[root] = true;
        for (std::size_t begin = 0; begin < order.size(); ++count) {
            last_begins = begin;
            const std::size_t end = order.size();
            for (; begin < end; ++begin) append_neighbours(body, order[begin], by_degree, met);
        }
    }

  private:
    void append_neighbours(const Polyhedron& body, Index v, bool by_degree, std::vector<bool>& met) {
        const auto first = static_cast<std::ptrdiff_t>(order.size());
        for (const HalfEdge h : body.ring_of_vertex(v)) {
            const Index neighbour = body.head(h);
            if (met[neighbour]) continue;
            met[neighbour] = true;
            order.push_back(neighbour);
        }
        if (by_degree) std::ranges::sort(order.begin() + first, order.end(), {}, degree_in(body));
    }
};

/// Levels from a vertex that is as far as possible from some other vertex: they are many and narrow.
Levels longest_levels(const Polyhedron& body) {
    Levels best(body, 0);
    for (;;) {
        const auto last = best.order.begin() + static_cast<std::ptrdiff_t>(best.last_begins);
        const Index far = *std::ranges::min_element(last, best.order.end(), {}, degree_in(body));
        Levels tried(body, far);
        const bool longer = tried.count > best.count;
        best = std::move(tried);
        if (!longer) return best;
    }
}

constexpr std::array<std::string_view, 4> names = {"given", "bfs", "spatial", "rcm"};

constexpr unsigned curve_bits = 10;

using Cell = std::array<std::uint32_t, 3>;

/// Transforms a cell into its transposed Hilbert index.
void transpose(Cell& x) {
    for (std::uint32_t bit = 1U << (curve_bits - 1); bit > 1; bit >>= 1) {
        const std::uint32_t below = bit - 1;
        for (std::uint32_t& axis : x) {
            if (axis & bit) {
                x[0] ^= below;
            } else {
                const std::uint32_t exchanged = (x[0] ^ axis) & below;
                x[0] ^= exchanged;
                axis ^= exchanged;
            }
        }
    }
    for (std::size_t i = 1; i < x.size(); ++i) x[i] ^= x[i - 1];
    std::uint32_t turns = 0;
    for (std::uint32_t bit = 1U << (curve_bits - 1); bit > 1; bit >>= 1) {
        if (x[2] & bit) turns ^= bit - 1;
    }
    for (std::uint32_t& axis : x) axis ^= turns;
}

std::uint32_t hilbert_index(Cell cell) {
    transpose(cell);
    std::uint32_t index = 0;
    for (unsigned bit = curve_bits; bit-- > 0;) {
        for (const std::uint32_t axis : cell) index = index << 1 | (axis >> bit & 1);
    }
    return index;
}

std::vector<Index> along_curve(const Polyhedron& body) {
    const Aabb box = box_of(body.vertices);
    const double side = max_abs(box.sides());
    const double cells = (1U << curve_bits) - 1;
    std::vector<std::uint32_t> place;
    for (const Vec3d& v : body.vertices) {
        Cell cell{};
        for (int k = 0; k < 3; ++k)
            cell[k] = side > 0 ? static_cast<std::uint32_t>((v[k] - box.low[k]) / side * cells) : 0;
        place.push_back(hilbert_index(cell));
    }
    std::vector<Index> order(body.vertex_count());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return place[a] < place[b]; });
    return order;
}

/// Returns for each new index the index in the body.
std::vector<Index> order_of_vertices(const Polyhedron& body, VertexOrder order) {
    if (order == VertexOrder::rcm) return bandwidth_order(body);
    return order == VertexOrder::bfs ? Levels(body, 0, false).order : along_curve(body);
}

}  // namespace

std::vector<Index> bandwidth_order(const Polyhedron& body) {
    std::vector<Index> order = longest_levels(body).order;
    std::reverse(order.begin(), order.end());
    return order;
}

Index bandwidth(const Polyhedron& body) {
    Index widest = 0;
    for (const PolyhedronEdge& e : body.edges)
        widest = std::max(widest, std::max(e.tail, e.head) - std::min(e.tail, e.head));
    return widest;
}

std::string_view to_string(VertexOrder order) { return names[static_cast<std::size_t>(order)]; }

std::optional<VertexOrder> vertex_order_from(std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<VertexOrder>(found - names.begin());
}

Result<Polyhedron> reordered(const Polyhedron& body, VertexOrder order) {
    if (order == VertexOrder::given || body.face_count() <= 2) return Result<Polyhedron>::success(body);
    FaceRings input;
    std::vector<Index> place(body.vertex_count());
    for (const Index v : order_of_vertices(body, order)) {
        place[v] = static_cast<Index>(input.vertices.size());
        input.vertices.push_back(body.vertices[v]);
        input.input_index.push_back(body.input_index[v]);
    }
    for (Index f = 0; f < body.face_count(); ++f) {
        auto& ring = input.rings.emplace_back();
        for (const HalfEdge h : body.ring_of_face(f)) ring.push_back(place[body.tail(h)]);
    }
    return build_polyhedron(input);
}

}  // namespace edgewise
