// SPDX-License-Identifier: MIT
//
// Structure of arrays: the same scalars as `aos`, each in an array of its own: twenty for an edge, three for
// a vertex, four for a face. Made for passes over all edges; V-Clip jumps from edge to edge, and reads a
// cache line per scalar. With more parallel arrays than a cache has ways, conflict misses may be added.
#pragma once

#include <cstddef>
#include <string_view>

#include "edgewise/layout_parts/stored_table.hpp"

namespace edgewise {

/// Distance between the starts of neighbouring arrays, if they take a line or more: back to back in whole
/// lines, or an odd number of lines.
enum class Spacing : bool { back_to_back, odd_lines };

template <class Stored, Spacing spacing>
struct SoaArrays {
    Strided<Stored> vertices;
    Strided<Stored> voronoi;   // tail, head, left, right plane: normal and offset each
    Strided<Stored> geometry;  // direction, length
    Strided<Stored> faces;     // normal and offset
    Strided<Index> all_ends;   // tail, head, left, right

    void place(BlockPlan& plan, const BodyFacts& n) {
        place_rows(plan, vertices, 3, n.vertex_count, Component::vertex_coordinates);
        place_rows(plan, voronoi, 16, n.edge_count(), Component::voronoi_planes);
        place_rows(plan, geometry, 4, n.edge_count(), Component::edge_geometry);
        place_rows(plan, faces, 4, n.face_count, Component::face_planes);
        place_rows(plan, all_ends, 4, n.edge_count(), Component::topology);
    }

    [[nodiscard]] auto vertex(Index v) const { return vertices.from(0, v); }
    [[nodiscard]] auto vertex_edge_plane(Index e, End end) const {
        return voronoi.from(4 * static_cast<std::size_t>(end), e);
    }
    [[nodiscard]] auto edge_face_plane(Index e, Side side) const {
        return voronoi.from(8 + 4 * static_cast<std::size_t>(side), e);
    }
    [[nodiscard]] auto direction(Index e) const { return geometry.from(0, e); }
    [[nodiscard]] auto& length(Index e) const { return geometry.from(3, e)[0]; }
    [[nodiscard]] auto ends(Index e) const { return all_ends.from(0, e); }
    [[nodiscard]] auto face_plane(Index f) const { return faces.from(0, f); }

  private:
    template <class Scalar>
    static void place_rows(BlockPlan& plan, Strided<Scalar>& to, int rows, std::size_t length,
                           Component use) {
        constexpr std::size_t line = BlockPlan::alignment;
        const std::size_t bytes = length * sizeof(Scalar), lines = (bytes + line - 1) / line;
        const bool gap = spacing == Spacing::odd_lines && length > 0 && lines % 2 == 0;
        for (int row = 0; row < rows; ++row) {
            Scalar* start = nullptr;
            std::byte* nothing = nullptr;
            plan.array(start, length, {{use, sizeof(Scalar)}});
            if (gap) plan.array(nothing, line, {});
            if (row == 0) to.first = start;
        }
        to.step = bytes < line ? length : (lines + (gap ? 1 : 0)) * line / sizeof(Scalar);
    }
};

template <Precision P, class Loader = Direct>
class soa : public StoredTable<SoaArrays<typename P::Stored, Spacing::back_to_back>, P, Loader> {
    using Base = StoredTable<SoaArrays<typename P::Stored, Spacing::back_to_back>, P, Loader>;

  public:
    static constexpr std::string_view name = "soa";
    static constexpr std::string_view stores = "the scalars of aos, each in an array of its own";

    using Base::Base;
};

}  // namespace edgewise
