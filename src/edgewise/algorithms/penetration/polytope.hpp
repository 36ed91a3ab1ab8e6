// SPDX-License-Identifier: MIT
//
// The polytope that EPA expands: the convex hull of some points of the Minkowski difference, as triangles,
// and a heap of them by their distance from the origin.
//
// A new point replaces all faces it lies strictly above, exactly decided. Exactness keeps the surface closed:
// the faces strictly below a point are one patch whatever the points, an edge of its rim (the horizon) is
// never in line with the point, and coplanar neighbours simply stay. So no face without area is ever made, no
// hole opens, and the hull is that of the points as rounded. Its depth is off by no more than the rounding of
// the points.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "edgewise/algorithms/penetration/expansion.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise::epa {

using Id = std::uint32_t;

struct Face {
    SmallArray<Id, 3> vertex;     ///< counter-clockwise from outside
    SmallArray<Id, 3> neighbour;  ///< across the edge from vertex[i] to the next
    Vec3d normal;                 ///< unit, outward
    double distance;              ///< of its plane from the origin; negative if the origin is outside
    bool live = true;             ///< still on the surface
};

class Polytope {
  public:
    void reserve(std::size_t faces) {
        points_.reserve(faces);
        rim_face_.reserve(faces);
        faces_.reserve(faces);
        heap_.reserve(faces);
        patch_.reserve(faces);
        rim_.reserve(faces);
    }

    /// Starts with a tetrahedron that has its fourth corner below the triangle of the first three.
    void start(const SmallArray<Vec3d, 4>& corner) {
        assert(side(corner[0], corner[1], corner[2], corner[3]) < 0);
        constexpr std::array<SmallArray<Id, 3>, 4> vertex{{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
        constexpr std::array<SmallArray<Id, 3>, 4> neighbour{{{1, 2, 3}, {3, 2, 0}, {1, 3, 0}, {2, 1, 0}}};
        points_.assign(corner.begin(), corner.end());
        rim_face_.assign(4, 0);
        faces_.clear();
        heap_.clear();
        for (Id f = 0; f < 4; ++f) faces_[add_face(vertex[f])].neighbour = neighbour[f];
    }

    [[nodiscard]] std::size_t faces_made() const { return faces_.size(); }
    [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
    [[nodiscard]] const Vec3d& point(Id v) const {
        assert(v < points_.size());
        return points_[v];
    }

    [[nodiscard]] bool is_above(const Vec3d& point, const Face& face) const {
        return side_of(face, point) > 0;
    }
    [[nodiscard]] int side_of(const Face& face, const Vec3d& point) const {
        return side(points_[face.vertex[0]], points_[face.vertex[1]], points_[face.vertex[2]], point);
    }

    /// The face nearest to the origin; stays on the heap until it is replaced.
    [[nodiscard]] Id nearest() {
        assert(!heap_.empty());
        while (!faces_[heap_.front().face].live) {
            std::pop_heap(heap_.begin(), heap_.end());
            heap_.pop_back();
            assert(!heap_.empty() && "some face is always live");
        }
        return heap_.front().face;
    }

    /// Adds a point above the face.
    void expand(const Vec3d& point, Id above) {
        const Id apex = static_cast<Id>(points_.size());
        points_.push_back(point);
        rim_face_.push_back(0);
        assert(faces_[above].live);
        remove_patch(point, above);
        assert(rim_.size() >= 3 && "the horizon is a closed line");
        for (const RimEdge& edge : rim_) {
            const Id made = add_face({edge.from, edge.to, apex});
            faces_[made].neighbour[0] = edge.beyond;
            faces_[edge.beyond].neighbour[edge_from(edge.beyond, edge.to)] = made;
            rim_face_[edge.from] = made;
        }
        for (const RimEdge& edge : rim_) {
            const Id made = rim_face_[edge.from], next = rim_face_[edge.to];
            faces_[made].neighbour[1] = next;
            faces_[next].neighbour[2] = made;
        }
    }

  private:
    /// An edge between a removed face, which has it in this direction, and one that stays.
    struct RimEdge {
        Id from, to;
        Id beyond;  ///< the face that stays
    };

    struct HeapEntry {
        double distance;
        Id face;

        /// Least distance on top; ties by age, so that the order is the same everywhere.
        [[nodiscard]] bool operator<(const HeapEntry& other) const {
            return distance != other.distance ? distance > other.distance : face > other.face;
        }
    };

    /// Removes the faces below the point, found outward from one of them; leaves their rim in rim_.
    void remove_patch(const Vec3d& point, Id above) {
        rim_.clear();
        faces_[above].live = false;
        patch_.assign(1, above);
        while (!patch_.empty()) {
            const Face& face = faces_[patch_.back()];
            patch_.pop_back();
            for (int i = 0; i < 3; ++i) {
                const Id other = face.neighbour[i];
                if (!faces_[other].live) continue;
                if (is_above(point, faces_[other])) {
                    faces_[other].live = false;
                    patch_.push_back(other);
                } else {
                    rim_.push_back({face.vertex[i], face.vertex[(i + 1) % 3], other});
                }
            }
        }
    }

    Id add_face(const SmallArray<Id, 3>& vertex) {
        const Id id = static_cast<Id>(faces_.size());
        const Vec3d &a = points_[vertex[0]], &b = points_[vertex[1]], &c = points_[vertex[2]];
        const Vec3d normal = triangle_normal(a, b, c);
        faces_.push_back({vertex, {}, normal, dot(normal, a)});
        heap_.push_back({faces_.back().distance, id});
        std::push_heap(heap_.begin(), heap_.end());
        return id;
    }

    /// Position of the face's edge that starts at the vertex.
    [[nodiscard]] int edge_from(Id face, Id vertex) const {
        const auto& ring = faces_[face].vertex;
        assert(ring[0] == vertex || ring[1] == vertex || ring[2] == vertex);
        return ring[0] == vertex ? 0 : ring[1] == vertex ? 1 : 2;
    }

    std::vector<Vec3d> points_;
    std::vector<Id> rim_face_;  ///< a vertex's new face while the rim is closed
    std::vector<Face> faces_;   ///< includes removed faces
    std::vector<HeapEntry> heap_;
    std::vector<Id> patch_;
    std::vector<RimEdge> rim_;
};

}  // namespace edgewise::epa
