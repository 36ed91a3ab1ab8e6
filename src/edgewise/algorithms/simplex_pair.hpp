// SPDX-License-Identifier: MIT
//
// State of GJK that a pair keeps from one query to the next: the vertices of its last simplex and the
// distance of the bodies, in 32 bytes where handles are whole numbers. Each of the four words holds two
// handles of 24 bits and 16 bits of a note: the number of vertices with a mark of the tables in the first
// two, the distance in the third.
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <concepts>
#include <cstdint>
#include <limits>

#include "edgewise/table/contract.hpp"
#include "edgewise/table/identity.hpp"

namespace edgewise {

/// Vertices of A and B; their difference is a point of a simplex.
template <SupportTable TableA, SupportTable TableB>
struct VertexPair {
    typename TableA::Vertex a;
    typename TableB::Vertex b;

    [[nodiscard]] bool operator==(const VertexPair&) const = default;
};

/// Four pairs of vertices and two notes, whatever the handles.
template <SupportTable TableA, SupportTable TableB>
class PlainCorners {
  public:
    [[nodiscard]] std::uint32_t note() const { return note_; }
    [[nodiscard]] std::uint16_t short_note() const { return short_note_; }
    [[nodiscard]] VertexPair<TableA, TableB> corner(std::uint32_t i) const { return corners_[i]; }
    [[nodiscard]] static bool fits(const VertexPair<TableA, TableB>&) { return true; }
    void set_note(std::uint32_t note) { note_ = note; }
    void set_short_note(std::uint16_t note) { short_note_ = note; }
    void set(std::uint32_t i, const VertexPair<TableA, TableB>& corner) { corners_[i] = corner; }

  private:
    std::array<VertexPair<TableA, TableB>, 4> corners_{};
    std::uint32_t note_ = 0;
    std::uint16_t short_note_ = 0;
};

/// Four pairs of vertices and two notes, for handles that are whole numbers below 2^24.
template <SupportTable TableA, SupportTable TableB>
class PackedCorners {
  public:
    [[nodiscard]] std::uint32_t note() const { return part(0) | std::uint32_t{part(1)} << 16; }
    [[nodiscard]] std::uint16_t short_note() const { return part(2); }
    [[nodiscard]] VertexPair<TableA, TableB> corner(std::uint32_t i) const {
        return {static_cast<typename TableA::Vertex>(words_[i] & handle),
                static_cast<typename TableB::Vertex>(words_[i] >> handle_bits & handle)};
    }
    [[nodiscard]] static bool fits(const VertexPair<TableA, TableB>& corner) {
        return corner.a <= handle && corner.b <= handle;
    }
    void set_note(std::uint32_t note) {
        set_part(0, static_cast<std::uint16_t>(note));
        set_part(1, static_cast<std::uint16_t>(note >> 16));
    }
    void set_short_note(std::uint16_t note) { set_part(2, note); }
    void set(std::uint32_t i, const VertexPair<TableA, TableB>& corner) {
        assert(fits(corner));
        words_[i] = (words_[i] & ~both_handles) | corner.a | std::uint64_t{corner.b} << handle_bits;
    }

  private:
    static constexpr int handle_bits = 24, note_at = 2 * handle_bits;
    static constexpr std::uint64_t handle = (std::uint64_t{1} << handle_bits) - 1,
                                   both_handles = (std::uint64_t{1} << note_at) - 1;

    [[nodiscard]] std::uint16_t part(std::uint32_t i) const {
        return static_cast<std::uint16_t>(words_[i] >> note_at);
    }
    void set_part(std::uint32_t i, std::uint16_t part) {
        words_[i] = (words_[i] & both_handles) | std::uint64_t{part} << note_at;
    }

    alignas(32) std::array<std::uint64_t, 4> words_{};  ///< within one cache line
};

template <class Table>
concept HasNumberedVertices = std::unsigned_integral<typename Table::Vertex> &&
                              sizeof(typename Table::Vertex) <= 4;

template <SupportTable TableA, SupportTable TableB>
struct CornersFor {
    using Type = PlainCorners<TableA, TableB>;
};
template <SupportTable TableA, SupportTable TableB>
requires HasNumberedVertices<TableA> && HasNumberedVertices<TableB>
struct CornersFor<TableA, TableB> {
    using Type = PackedCorners<TableA, TableB>;
};

/// Starts cold after a rebuild of its tables, and if their handles are too large to keep.
template <SupportTable TableA, SupportTable TableB>
class SimplexPair {
  public:
    using Corner = VertexPair<TableA, TableB>;

    SimplexPair() = default;
    SimplexPair(const TableA& a, const TableB& b) { note(a, b, 0, std::numeric_limits<float>::infinity()); }

    /// Number of vertices held; 0: cold.
    [[nodiscard]] std::uint32_t count() const { return corners_.note() & most; }
    /// Distance of the bodies when these vertices held their closest points: 0 in contact, infinite where it
    /// is not known; up to a 128th too small.
    [[nodiscard]] float distance() const {
        return std::bit_cast<float>(std::uint32_t{corners_.short_note()} << 16);
    }
    [[nodiscard]] Corner corner(std::uint32_t i) const {
        assert(i < count());
        return corners_.corner(i);
    }

    /// All vertices of A, and of B: the first count() of four.
    [[nodiscard]] std::array<typename TableA::Vertex, 4> vertices_a() const {
        std::array<typename TableA::Vertex, 4> vertices{};
        for (std::uint32_t i = 0; i < count(); ++i) vertices[i] = corner(i).a;
        return vertices;
    }
    [[nodiscard]] std::array<typename TableB::Vertex, 4> vertices_b() const {
        std::array<typename TableB::Vertex, 4> vertices{};
        for (std::uint32_t i = 0; i < count(); ++i) vertices[i] = corner(i).b;
        return vertices;
    }

    /// Returns false after a rebuild: the handles may lead anywhere, and no query follows them.
    [[nodiscard]] bool belongs_to(const TableA& a, const TableB& b) const {
        return (corners_.note() & ~most) == tables_of(a, b);
    }
    /// Returns true if the next query of both tables starts from the held vertices.
    [[nodiscard]] bool starts_warm(const TableA& a, const TableB& b) const {
        return count() != 0 && belongs_to(a, b);
    }

    /// Adds one pair of vertices, up to four.
    void push(const Corner& corner) {
        const std::uint32_t before = count();
        assert(before < 4);
        if (!Corners::fits(corner)) return;
        corners_.set(before, corner);
        corners_.set_note(corners_.note() + 1);
    }
    /// Holds a simplex of two tables: vertex_a(i), vertex_b(i) of `count` points, with closest points at this
    /// distance from each other.
    template <class Points>
    void hold(const TableA& a, const TableB& b, const Points& simplex, double distance) {
        const auto corner_at = [&](int i) {
            return Corner{static_cast<typename TableA::Vertex>(simplex.vertex_a(i)),
                          static_cast<typename TableB::Vertex>(simplex.vertex_b(i))};
        };
        bool all_fit = true;
        for (int i = 0; i < simplex.count; ++i) all_fit = all_fit && Corners::fits(corner_at(i));
        // The notes first: g++ reads two of their words at once, which would wait for corners just stored.
        const int held = all_fit ? simplex.count : 0;
        note(a, b, static_cast<std::uint32_t>(held), static_cast<float>(distance));
        for (int i = 0; i < held; ++i) corners_.set(static_cast<std::uint32_t>(i), corner_at(i));
    }

    /// Changes the distance alone.
    void set_distance(double distance) { corners_.set_short_note(half_of(static_cast<float>(distance))); }

    /// Compares the vertices, the tables and the distance.
    [[nodiscard]] bool operator==(const SimplexPair& other) const {
        bool equal =
            corners_.note() == other.corners_.note() && corners_.short_note() == other.corners_.short_note();
        for (std::uint32_t i = 0; equal && i < count(); ++i) equal = corner(i) == other.corner(i);
        return equal;
    }

  private:
    using Corners = typename CornersFor<TableA, TableB>::Type;

    static constexpr std::uint32_t most = 7;  ///< bits of the note for the number of vertices

    [[nodiscard]] static std::uint32_t tables_of(const TableA& a, const TableB& b) {
        return identity_of(a, b) << 3;
    }
    /// The distance in a note: the upper half of its 32 bits, with eight binary digits, enough to detect
    /// large motion.
    [[nodiscard]] static std::uint16_t half_of(float distance) {
        return static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(distance) >> 16);
    }
    void note(const TableA& a, const TableB& b, std::uint32_t count, float distance) {
        corners_.set_note(tables_of(a, b) | count);
        corners_.set_short_note(half_of(distance));
    }

    Corners corners_;
};

}  // namespace edgewise
