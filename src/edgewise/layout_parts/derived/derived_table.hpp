// SPDX-License-Identifier: MIT
//
// A feature table that stores no feature, and answers questions about whole rings (table/ring_questions.hpp)
// in one pass: each vertex is read once, no square root is computed, and where all faces are triangles no
// ring is searched for a known place.
#pragma once

#include <algorithm>
#include <cmath>

#include "edgewise/layout_parts/derived/derived_ends.hpp"
#include "edgewise/table/ring_questions.hpp"

namespace edgewise {

/// Points and RingPlaces: as in DerivedPlanes.
template <class Points, Precision P, class Loader, class RingPlaces = NarrowRingPlaces>
class DerivedTable : public DerivedEnds<Points, P, Loader, RingPlaces> {
    using Base = DerivedEnds<Points, P, Loader, RingPlaces>;

  public:
    using typename Base::Compute, typename Base::Edge, typename Base::Face, typename Base::Vertex;

    using Base::Base, Base::vertex;

    template <class Visit>
    void visit_vertex_planes(Vertex v, Visit visit) const {
        const Vec3<Compute> base = vertex(v);
        const Index last = rings().last(loader_, v);
        for (Index at = rings().first(loader_, v); at < last; ++at) {
            const Vec3<Compute> other = vertex(rings().neighbour(loader_, v, at));
            if (!visit(at, AnchoredPlane<Compute>{base - other, base})) return;
        }
    }
    template <class Visit>
    void visit_face_sides(const Face& f, Visit visit) const {
        if (!this->all_triangles()) return visit_ring_of_face(f, visit);
        const auto c = this->corners_of(f);
        const Vec3<Compute> first = vertex(c.first), second = vertex(c.second), third = vertex(c.third);
        if (visit(this->edge_at(c.first, f.at).edge, side_plane(c.first < c.second, first, second, third)) &&
            visit(this->edge_somewhere(c.second, c.third),
                  side_plane(c.second < c.third, second, third, first)))
            visit(this->edge_at(c.first, c.third_at).edge,
                  side_plane(c.third < c.first, third, first, second));
    }
    [[nodiscard]] Compute slope_along(const Edge& e, const Vec3<Compute>& normal) const {
        return slope_of(Vec3<Compute>(vertex(e.head) - vertex(e.tail)), normal);
    }
    /// First checks without a division that an edge descends at all: where V-Clip ends, none does.
    [[nodiscard]] Descent<Edge, Compute> steepest_descent(Vertex v, const Vec3<Compute>& normal) const {
        const Vec3<Compute> base = vertex(v);
        const Index first = rings().first(loader_, v), last = rings().last(loader_, v);
        const auto along = [&](Index at) -> Vec3<Compute> {
            return vertex(rings().neighbour(loader_, v, at)) - base;
        };
        bool descends = false;
        for (Index at = first; at < last; ++at) descends |= dot(along(at), normal) < 0;
        if (!descends) return {};
        Descent<Edge, Compute> result;
        Index worst = last;
        for (Index at = first; at < last; ++at) {
            const Compute slope = slope_of(along(at), normal);
            result.steepest = std::max(result.steepest, std::abs(slope));
            worst = slope < result.slope ? at : worst;
            result.slope = std::min(result.slope, slope);
        }
        if (worst != last) result.edge = this->edge_at(v, worst).edge;
        return result;
    }

  protected:
    using Base::loader_, Base::rings;

  private:
    using Base::side_plane;

    [[nodiscard]] static Compute slope_of(const Vec3<Compute>& along, const Vec3<Compute>& normal) {
        return squared_slope(dot(along, normal)) / squared_norm(along);
    }
    /// Reads each corner once, the last one twice. A side's plane is derived from the corner that
    /// edge_face_plane takes: the one before a side that rises, the one after a side that falls.
    template <class Visit>
    [[gnu::noinline]] void visit_ring_of_face(const Face& f, Visit visit) const {
        const auto corners = this->corners_of(f);
        const Vec3<Compute> first = vertex(corners.first), second = vertex(corners.second);
        Vec3<Compute> before = vertex(corners.third), from = first, to = second;
        DerivedSide side{f, corners.first, corners.second};
        bool goes_on = true;
        const auto end_side = [&](const Vec3<Compute>& after) {
            const bool rising = side.from < side.to;
            goes_on = visit(side.edge(), side_plane(rising, from, to, rising ? before : after));
            before = from;
            from = to;
            to = after;
        };
        this->visit_sides(f, [&](const DerivedSide& following) {
            if (following.from != corners.first) {
                end_side(following.to == corners.first ? first : vertex(following.to));
                side = following;
            }
            return goes_on;
        });
        if (goes_on) end_side(second);
    }
};

}  // namespace edgewise
