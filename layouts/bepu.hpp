// SPDX-License-Identifier: MIT
//
// The convex hull of bepuphysics2 (revision 956a679f, Collidables/ConvexHull.cs): vertices in bundles of
// eight, x, y and z of all eight side by side; bounding planes in bundles of eight too; for each face the
// start of its list of vertices, and in the lists each vertex as its bundle and its lane, 16 bits each. 25.4
// bytes per edge in single at 386 vertices; a scan reads 4.1 of them. Only the structure is the engine's,
// from its published list of fields, in either precision; the algorithms are ours. For GJK only: no face
// knows its neighbours.
//
// A scan over all bundles with a best vertex per lane finds support points, as in the engine. Planes and
// faces are always stored, also in a table for GJK (keeps_faces, table/contract.hpp), which does not read
// them. Lanes of the last bundle that no vertex fills repeat the last vertex.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "edgewise/layout_parts/block_table.hpp"
#include "edgewise/layout_parts/lane_scan.hpp"

namespace edgewise {

/// `Rows` scalars of each of eight elements, side by side.
template <class Stored, std::size_t Rows>
struct BepuBundle {
    static constexpr std::size_t lanes = 8;
    Stored row[Rows][lanes];
};

/// A vertex of a face, by bundle and lane.
struct BepuCorner {
    std::uint16_t bundle, lane;
};

/// The start of each array, in bytes from the block's start.
template <class Stored>
struct BepuPlaces {
    using Points = BepuBundle<Stored, 3>;
    using Planes = BepuBundle<Stored, 4>;

    std::uint32_t points = 0, planes = 0, corners = 0, starts = 0;

    void place(BlockPlan& plan, const BodyFacts& n) {
        points = place_bundles<Points>(plan, n.vertex_count, 3, Component::vertex_coordinates);
        planes = place_bundles<Planes>(plan, n.face_count, 4, Component::face_planes);
        corners = plan.array_at<BepuCorner>(n.face_ring_count(), {{Component::topology, sizeof(BepuCorner)}});
        starts = plan.array_at<Index>(n.face_count, {{Component::topology, sizeof(Index)}});
    }

  private:
    /// Places bundles; a last bundle that is not full goes row by row: its free lanes are padding.
    template <class Bundle>
    static std::uint32_t place_bundles(BlockPlan& plan, std::size_t count, std::size_t rows, Component use) {
        constexpr std::size_t lanes = Bundle::lanes;
        const std::uint32_t start = plan.array_at<Bundle>(count / lanes, {{use, sizeof(Bundle)}});
        const std::size_t rest = count % lanes;
        for (std::size_t row = 0; rest > 0 && row < rows; ++row)
            plan.append(lanes * sizeof(Stored), {{use, rest * sizeof(Stored)}});
        return start;
    }
};

template <Precision P, class Loader = Direct>
class bepu : public PlacedTable<BepuPlaces<typename P::Stored>, P, Loader> {
    using Base = PlacedTable<BepuPlaces<typename P::Stored>, P, Loader>;
    using Base::facts_, Base::load, Base::places_;

  public:
    using typename Base::Compute, typename Base::Stored, typename Base::Vertex;

    static constexpr std::string_view name = "bepu";
    static constexpr std::string_view stores =
        "bepuphysics2's hull (956a679f): vertices and planes in bundles of eight, faces; scanned wide";
    static constexpr std::string_view derives = "support points, by scans";
    static constexpr bool keeps_faces = true;
    /// 16 bits count bundles. Each vertex has at least three neighbours, so this many neighbours always fit.
    static constexpr std::size_t most_neighbours = 3 * 8 * std::size_t{0x10000};

    /// Both kinds of parts are the same here: the engine keeps everything.
    bepu(const Polyhedron& body, Parts /*parts*/, Loader loader = {}) : Base(body, Parts::features, loader) {
        for (Index f = 0; f < facts_.face_count; ++f) starts()[f] = body.face_offset[f];
        for (Index i = 0; i < facts_.face_ring_count(); ++i) {
            const Index v = body.tail(body.face_ring[i]);
            corners()[i] = {static_cast<std::uint16_t>(v / lanes), static_cast<std::uint16_t>(v % lanes)};
        }
        write_geometry(*this, body);
    }

    using Base::Base;

    /// Writes a vertex; the last vertex also fills the free lanes behind it.
    void write_vertex(Index v, const Vec3d& point) {
        const std::size_t lane = v % lanes, end = v + 1 == facts_.vertex_count ? lanes : lane + 1;
        for (int k = 0; k < 3; ++k)
            std::fill(points()[v / lanes].row[k] + lane, points()[v / lanes].row[k] + end,
                      static_cast<Stored>(point[k]));
    }
    void write_face(Index f, const Plane<double>& plane) {
        auto& to = planes()[f / lanes].row;
        for (int k = 0; k < 3; ++k) to[k][f % lanes] = static_cast<Stored>(plane.normal[k]);
        to[3][f % lanes] = static_cast<Stored>(plane.offset);
    }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v < facts_.vertex_count);
        const auto& bundle = points()[v / lanes];
        return {read(bundle.row[0][v % lanes]), read(bundle.row[1][v % lanes]),
                read(bundle.row[2][v % lanes])};
    }

    /// Plane of a face, as stored.
    [[nodiscard]] Plane<Compute> face_plane(Index f) const {
        const auto& bundle = planes()[f / lanes].row;
        const auto number = [&](std::size_t k) {
            return static_cast<Compute>(load(bundle[k][f % lanes], Field::face_plane));
        };
        return {{number(0), number(1), number(2)}, number(3)};
    }
    /// A face's vertices in ring order.
    [[nodiscard]] auto face_vertices(Index f) const {
        const Index first = load(starts()[f], Field::face_ring);
        const Index last =
            f + 1 == facts_.face_count ? facts_.face_ring_count() : load(starts()[f + 1], Field::face_ring);
        return IndexedRing(first, last, [this](Index at) {
            const BepuCorner corner = load(corners()[at], Field::face_ring);
            return static_cast<Index>(corner.bundle * lanes + corner.lane);
        });
    }

    /// Returns the vertex farthest along the direction, the first of equals.
    [[nodiscard]] Vertex scan_support(const Vec3<Compute>& direction) const {
        const std::size_t bundles = (facts_.vertex_count + lanes - 1) / lanes;
        return farthest_in_lanes<lanes>(bundles, direction,
                                        [this](int k, std::size_t bundle, std::size_t lane) {
                                            return read(points()[bundle].row[k][lane]);
                                        });
    }

  private:
    using Places = BepuPlaces<Stored>;
    static constexpr std::size_t lanes = 8;

    Compute read(const Stored& location) const { return static_cast<Compute>(load(location, Field::vertex)); }
    [[nodiscard]] auto* points() const {
        return this->template array<typename Places::Points>(places_.points);
    }
    [[nodiscard]] auto* planes() const {
        return this->template array<typename Places::Planes>(places_.planes);
    }
    [[nodiscard]] BepuCorner* corners() const { return this->template array<BepuCorner>(places_.corners); }
    [[nodiscard]] Index* starts() const { return this->template array<Index>(places_.starts); }
};

}  // namespace edgewise
