// SPDX-License-Identifier: MIT
//
// GJK in single precision, as the search for a start: up to four pairs of vertices of two small bodies that
// most likely hold the closest points, or surround the origin. What it finds is proven in doubles
// (kept_simplex.hpp) or searched on from (gjk.hpp), so rounding costs time here and never an answer. It reads
// coordinates only: it is compiled once, not per table type, for the widest registers of the processor.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "edgewise/algorithms/support.hpp"
#include "edgewise/geometry/inlining.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// A table with handles that count the vertices from 0.
template <class Table>
concept NumberedTable = SupportTable<Table> && std::unsigned_integral<typename Table::Vertex> && requires {
    requires Table::counts_vertices;
};

/// Vertices of a body less its first one, in single precision, followed by copies of the last one up to a
/// whole number of rows.
struct SingleVertices {
    static constexpr std::size_t row = 8, most = most_scanned;

    alignas(32) std::array<float, most> x, y, z;
    std::size_t count = 0;  ///< with the copies
};

/// Two bodies as a search reads them: its result depends on these numbers alone.
struct SingleSearch {
    SingleVertices a, b;      ///< b: in B's frame
    Mat3<float> rotation;     ///< takes directions of B's frame to A's
    Vec3<float> translation;  ///< the first vertex of B less that of A, in A's frame
    Vec3<float> towards_b;    ///< the search starts with the vertices farthest along it and against it
    float cutoff;             ///< ends as soon as a direction shows that they are farther apart
};

/// Where a search ended: the first `count` of four pairs of vertices, by number. Four of them surround the
/// origin, in singles.
struct SingleSearchEnd {
    int count = 0, steps = 0;
    std::array<std::uint8_t, 4> a{}, b{};

    [[nodiscard]] std::uint32_t vertex_a(int i) const { return a[static_cast<std::size_t>(i)]; }
    [[nodiscard]] std::uint32_t vertex_b(int i) const { return b[static_cast<std::size_t>(i)]; }
    /// Adds a pair of vertices, as one word.
    [[gnu::always_inline]] void add(std::int32_t pair, bool is_held) {
        a[static_cast<std::size_t>(count)] = static_cast<std::uint8_t>(pair >> 8);
        b[static_cast<std::size_t>(count)] = static_cast<std::uint8_t>(pair);
        count += is_held ? 1 : 0;
    }
};

/// `end`: an empty one. (A returned one is read by words after stores of bytes, for which it waits.)
void run_single_search(const SingleSearch& search, SingleSearchEnd& end);

/// True on a processor with AVX2: its registers hold eight searches side by side. Only x86 was measured.
[[nodiscard]] bool has_lanes();

/// Where the lanes' searches come from and their ends go to.
class SearchSource {
  public:
    /// Writes the lane's next search; false if none is left.
    [[nodiscard]] virtual bool next(int lane, SingleSearch& search) = 0;
    /// Takes where the lane's search ended: as run_single_search says.
    virtual void take(int lane, const SingleSearchEnd& end) = 0;

  protected:
    ~SearchSource() = default;
};

/// Runs all searches of the source, side by side, on a processor that has_lanes().
void run_lane_searches(SearchSource& source);

/// Writes a table's vertices, less the first, times `scale`.
template <NumberedTable Table>
EDGEWISE_QUERY_LOOP void write_singles(const Table& table, ComputeOf<Table> scale, SingleVertices& to) {
    using Vertex = typename Table::Vertex;
    const std::size_t count = table.vertex_count();
    assert(count >= 1 && count <= SingleVertices::most);
    const auto origin = table.vertex(Vertex{0});
    for (std::size_t i = 0; i < count; ++i) {
        const auto point = table.vertex(static_cast<Vertex>(i));
        to.x[i] = static_cast<float>((point.x() - origin.x()) * scale);
        to.y[i] = static_cast<float>((point.y() - origin.y()) * scale);
        to.z[i] = static_cast<float>((point.z() - origin.z()) * scale);
    }
    to.count = (count + SingleVertices::row - 1) / SingleVertices::row * SingleVertices::row;
    for (std::size_t i = count; i < to.count; ++i) {
        to.x[i] = to.x[count - 1];
        to.y[i] = to.y[count - 1];
        to.z[i] = to.z[count - 1];
    }
}

/// The power of two that scales a length to about 1: products of six lengths stay within single precision.
[[nodiscard]] inline double scale_to_one(double length) {
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(length) >> 52 & 2047;
    return std::bit_cast<double>((2045 - std::min<std::uint64_t>(exponent, 2044)) << 52);
}

/// Writes two bodies with at most SingleVertices::most vertices each.
template <NumberedTable TableA, NumberedTable TableB>
void write_search(const TableA& a, const TableB& b, const Transform<ComputeOf<TableA>>& a_from_b,
                  ComputeOf<TableA> cutoff, SingleSearch& to) {
    using Scalar = ComputeOf<TableA>;
    const Vec3<Scalar> first_a = a.vertex(typename TableA::Vertex{0}),
                       last_a = a.vertex(static_cast<typename TableA::Vertex>(a.vertex_count() - 1)),
                       between = a_from_b.point(b.vertex(typename TableB::Vertex{0})) - first_a;
    const auto scale = static_cast<Scalar>(
        scale_to_one(std::max(max_abs(between), max_abs(Vec3<Scalar>(last_a - first_a)))));
    write_singles(a, scale, to.a);
    write_singles(b, scale, to.b);
    to.rotation = a_from_b.rotation.template cast<float>();
    to.translation = cast<float>(Vec3<Scalar>(between * scale));
    to.towards_b = cast<float>(Vec3<Scalar>(a_from_b.translation * scale));
    to.cutoff = static_cast<float>(cutoff * scale);
}

/// Writes a search and runs it. Not inlined: its arrays are not on the stack of a query that needs none.
template <NumberedTable TableA, NumberedTable TableB>
[[gnu::noinline]] void search_in_singles(const TableA& a, const TableB& b,
                                         const Transform<ComputeOf<TableA>>& a_from_b,
                                         ComputeOf<TableA> cutoff, SingleSearchEnd& end) {
    SingleSearch search;
    write_search(a, b, a_from_b, cutoff, search);
    run_single_search(search, end);
}

}  // namespace edgewise
