// SPDX-License-Identifier: MIT
//
// Checks that a body ends at a feature along a direction, or that an edge pierces a face, for a table that
// stores no feature: each corner next to the feature is read once, and no plane is made except a face's own
// (vclip/still_closest.hpp).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "edgewise/layout_parts/derived/derived_planes.hpp"

namespace edgewise {

/// Points and RingPlaces: as in DerivedPlanes.
template <class Points, Precision P, class Loader, class RingPlaces = NarrowRingPlaces>
class DerivedEnds : public DerivedPlanes<Points, P, Loader, RingPlaces> {
    using Base = DerivedPlanes<Points, P, Loader, RingPlaces>;

  public:
    using typename Base::Compute, typename Base::Edge, typename Base::Face, typename Base::Vertex;

    using Base::Base, Base::vertex;

    /// True if all edges of the body turn outwards: then no corner lies higher behind a neighbour that is not
    /// higher.
    [[nodiscard]] bool neighbours_decide() const { return facts_.climbable && facts_.face_count > 0; }

    /// Returns true if no neighbour lies farther along the direction, which is off by the rounding of `size`.
    [[nodiscard]] bool ends_at_vertex(Vertex v, const Vec3<Compute>& direction, Compute size) const {
        const Vec3<Compute> base = vertex(v);
        const Compute level = highest_allowed(direction, size);
        const Index last = rings().last(loader_, v);
        bool rises = false;
        for (Index at = rings().first(loader_, v); at < last; ++at) {
            rises |= height_of(rings().neighbour(loader_, v, at), base, direction) > level;
        }
        return !rises;
    }

    /// Returns true if no corner next to the edge (one of either face; faces are plane), in the ring that
    /// knows the edge's place, lies farther along the direction, which is normal to the edge.
    [[nodiscard]] bool ends_at_edge(const Edge& e, const Vec3<Compute>& direction, Compute size) const {
        const HalfEdgeAt h = this->half_edge_of(e);
        const Vec3<Compute> base = vertex(h.vertex);
        const Compute level = highest_allowed(direction, size);
        const Index before = rings().before(loader_, h.vertex, h.at);
        const Index after = rings().after(loader_, h.vertex, h.at);
        return height_of(rings().neighbour(loader_, h.vertex, before), base, direction) <= level &&
               height_of(rings().neighbour(loader_, h.vertex, after), base, direction) <= level;
    }

    /// The plane of the face, unscaled, if the point lies above it and within the face's prism, and the plane
    /// is known to full precision; else nothing.
    [[nodiscard]] std::optional<AnchoredPlane<Compute>> plane_below(const Face& f,
                                                                    const Vec3<Compute>& point) const {
        if (!this->all_triangles()) return polygon_below(f, point);
        const auto c = this->corners_of(f);
        const Vec3<Compute> first = vertex(c.first), second = vertex(c.second), third = vertex(c.third);
        const Vec3<Compute> p = second - first, q = third - first, normal = cross(p, q);
        const bool above = dot(normal, Vec3<Compute>(point - first)) > 0 && is_fair(p, q, normal);
        if (!above || is_beside(normal, first, second, point) || is_beside(normal, second, third, point) ||
            is_beside(normal, third, first, point))
            return std::nullopt;
        return AnchoredPlane<Compute>{normal, first};
    }

    /// Returns true if the piece from tail to head crosses the face, farther than `noise` from its sides, and
    /// both ends are farther than that from its plane. False for a face with more than most_corners.
    [[nodiscard]] bool is_pierced(const Face& f, const Vec3<Compute>& tail, const Vec3<Compute>& head,
                                  Compute noise) const {
        std::array<Vec3<Compute>, most_corners> corners;
        const std::size_t count = read_corners(f, corners);
        return count > 0 && crosses(std::span(corners).first(count), tail, head, noise);
    }

  protected:
    using Base::facts_, Base::loader_, Base::rings;

  private:
    /// Limit for a face that is tried: boxes have 4 corners, hulls with merged faces rarely more than 6.
    static constexpr std::size_t most_corners = 8;

    /// Height of a corner over `base` along a direction.
    [[nodiscard]] Compute height_of(Vertex v, const Vec3<Compute>& base,
                                    const Vec3<Compute>& direction) const {
        return dot(Vec3<Compute>(vertex(v) - base), direction);
    }
    /// Highest level that a neighbour may reach. A small error of the direction turns the body behind a fair
    /// corner by as much, behind a thin one by the error over its sine. Where edges hardly turn, the body may
    /// go on behind a neighbour that is as high (support.hpp). There the neighbour must be lower, by more
    /// than rounding. The same holds along a short direction, which is off by the rounding of its points over
    /// its length: closest points further along a level edge are nearer by that times the edge. Short means
    /// `close` in single.
    [[nodiscard]] Compute highest_allowed(const Vec3<Compute>& direction, Compute size) const {
        const bool is_short = max_abs(direction) < static_cast<Compute>(Tolerance<float>::close) * size;
        const bool level_decides = facts_.strictly_convex && !facts_.thin_corners && !is_short;
        const Compute rounding = Tolerance<Compute>::level * static_cast<Compute>(facts_.reach) * size;
        return level_decides ? Compute(0) : -rounding;
    }
    /// Returns true if the normal of two sides of a face is as accurate as the sides.
    [[nodiscard]] bool is_fair(const Vec3<Compute>& p, const Vec3<Compute>& q,
                               const Vec3<Compute>& normal) const {
        const Compute fair = Tolerance<Compute>::fair_corner * squared_norm(p) * squared_norm(q);
        return !facts_.thin_corners || squared_norm(normal) > fair;
    }
    /// Returns true if the point is outside of the side from one corner of a face to the next.
    [[nodiscard]] static bool is_beside(const Vec3<Compute>& normal, const Vec3<Compute>& from,
                                        const Vec3<Compute>& to, const Vec3<Compute>& point) {
        return dot(cross(normal, Vec3<Compute>(to - from)), Vec3<Compute>(point - from)) < 0;
    }
    [[nodiscard]] [[gnu::noinline]] std::optional<AnchoredPlane<Compute>> polygon_below(
        const Face& f, const Vec3<Compute>& point) const {
        std::array<Vec3<Compute>, most_corners> corners;
        const std::size_t count = read_corners(f, corners);
        PlainNewellSum<Compute> sum;
        for (std::size_t i = 1; i < count; ++i) sum.add(Vec3<Compute>(corners[i] - corners[0]));
        const Vec3<Compute>& normal = sum.normal();
        if (count == 0 || !sum.is_fair() || !(dot(normal, Vec3<Compute>(point - corners[0])) > 0))
            return std::nullopt;
        for (std::size_t i = 0; i < count; ++i) {
            if (is_beside(normal, corners[i], corners[i + 1 < count ? i + 1 : 0], point)) return std::nullopt;
        }
        return AnchoredPlane<Compute>{normal, corners[0]};
    }
    /// A piece crosses a convex polygon if its ends lie on either side of the plane, and the volumes that it
    /// spans with the sides all have one sign: the line then passes within all of them.
    [[nodiscard]] static bool crosses(std::span<const Vec3<Compute>> corners, const Vec3<Compute>& tail,
                                      const Vec3<Compute>& head, Compute noise) {
        const Vec3<Compute> along = head - tail, p = corners[1] - corners[0], q = corners[2] - corners[0];
        const Vec3<Compute> normal = cross(p, q);
        const Compute rise = dot(normal, along), height = dot(normal, Vec3<Compute>(corners[0] - tail)),
                      to_plane = rise > 0 ? height : -height;
        const Compute least_height = noise * norm(p) * norm(q), least_volume = noise * norm(along);
        bool within = to_plane > least_height && std::abs(rise) - to_plane > least_height;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3<Compute> side = corners[i + 1 < corners.size() ? i + 1 : 0] - corners[i];
            const Compute volume = dot(along, cross(Vec3<Compute>(corners[i] - tail), side));
            within &= (rise > 0 ? volume : -volume) > least_volume * norm(side);
        }
        return within;
    }
    /// Reads all corners of a face in order, from its first; none if it has too many.
    [[nodiscard]] std::size_t read_corners(const Face& f,
                                           std::array<Vec3<Compute>, most_corners>& corners) const {
        std::size_t count = 0;
        bool fits = true;
        this->visit_sides(f, [&](const DerivedSide& side) {
            fits = count < most_corners;
            if (fits) corners[count++] = vertex(side.from);
            return fits;
        });
        return fits ? count : 0;
    }
};

}  // namespace edgewise
