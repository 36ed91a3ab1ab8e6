// SPDX-License-Identifier: MIT
//
// Whether a body ends at a feature along a direction, of a table that stores no feature: each corner next to
// the feature is read once, and no plane is made but a face's own (vclip/still_closest.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "edgewise/layout_parts/derived/derived_planes.hpp"

namespace edgewise {

/// Points and RingPlaces: as of DerivedPlanes.
template <class Points, Precision P, class Loader, class RingPlaces = NarrowRingPlaces>
class DerivedEnds : public DerivedPlanes<Points, P, Loader, RingPlaces> {
    using Base = DerivedPlanes<Points, P, Loader, RingPlaces>;

  public:
    using typename Base::Compute;
    using typename Base::Edge;
    using typename Base::Face;
    using typename Base::Vertex;

    using Base::Base;
    using Base::vertex;

    /// Of a body whose edges all turn outwards: where one corner is no higher than the next, none behind it
    /// is.
    [[nodiscard]] bool neighbours_decide() const { return facts_.climbable && facts_.face_count > 0; }

    /// No neighbour lies farther along the direction, which is off by the rounding of `size`.
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

    /// No corner beside the edge, in the ring where its place is known, lies farther along the direction,
    /// which is across the edge: one of either face, whose other corners lie in the plane of these three.
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
    /// is known to full precision.
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

  protected:
    using Base::facts_;
    using Base::loader_;
    using Base::rings;

  private:
    /// Of a face that is proven: boxes have 4, hulls with merged faces seldom more than 6.
    static constexpr std::size_t most_corners = 8;

    /// Over a corner along a direction.
    [[nodiscard]] Compute height_of(Vertex v, const Vec3<Compute>& base,
                                    const Vec3<Compute>& direction) const {
        return dot(Vec3<Compute>(vertex(v) - base), direction);
    }
    /// What no neighbour's height may exceed. A direction that is a little off turns what lies behind a fair
    /// corner by as much, behind a thin one by that over its sine; and where edges hardly turn, the body may
    /// go on behind a neighbour that is as high (support.hpp). There it must be lower, by more than rounding;
    /// and so it must along a short direction, which is off by the rounding of the points that it is between
    /// over its length: closest points further along a level edge are nearer by that times the edge. Short is
    /// what single precision calls close, in any.
    [[nodiscard]] Compute highest_allowed(const Vec3<Compute>& direction, Compute size) const {
        const bool is_short = max_abs(direction) < static_cast<Compute>(Tolerance<float>::close) * size;
        const bool level_decides = facts_.strictly_convex && !facts_.thin_corners && !is_short;
        const Compute rounding = Tolerance<Compute>::level * static_cast<Compute>(facts_.reach) * size;
        return level_decides ? Compute(0) : -rounding;
    }
    /// Whether the normal of two sides of a face is as good as they are.
    [[nodiscard]] bool is_fair(const Vec3<Compute>& p, const Vec3<Compute>& q,
                               const Vec3<Compute>& normal) const {
        const Compute fair = Tolerance<Compute>::fair_corner * squared_norm(p) * squared_norm(q);
        return !facts_.thin_corners || squared_norm(normal) > fair;
    }
    /// Outside of the side from one corner of a face to the next.
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
    /// All corners of a face in order, from its first; none if it has too many. The ring of the first knows
    /// the last: the way around ends there.
    [[nodiscard]] std::size_t read_corners(const Face& f,
                                           std::array<Vec3<Compute>, most_corners>& corners) const {
        const Index last = this->corners_of(f).third;
        corners[0] = vertex(f.vertex);
        HalfEdgeAt h = f;
        for (std::size_t count = 1; count < corners.size(); h = this->next(h)) {
            const Index to = rings().neighbour(loader_, h.vertex, h.at);
            corners[count++] = vertex(to);
            if (to == last) return count;
        }
        return 0;
    }
};

}  // namespace edgewise
