// SPDX-License-Identifier: MIT
//
// A convex polytope on points of A - B that holds the origin, grown a point at a time, exactly: the polytope
// of EPA (van den Bergen, "Proximity queries and penetration depth computation on 3D game objects", 2001).
//
// Faces are triangles; a flat facet may be several of them. A new point removes the faces it lies strictly
// above and leaves the coplanar ones: what is removed is then one disc, and no new face is ever degenerate.
// Faces are never erased, only marked, so indices stay valid, and the heap drops removed faces when they
// reach its top.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "edgewise/truth/integer_vector.hpp"
#include "edgewise/truth/minimum_norm.hpp"

namespace edgewise::truth {

struct DifferencePoint {
    VertexPair pair;
    IntegerVec point;
};

class ExpandingPolytope {
  public:
    /// The plane is normal.x = height: normal outward, not unit, height not negative. The distance from the
    /// origin is sqrt(squared_height / squared_normal).
    struct Face {
        std::array<std::uint32_t, 3> corner;  ///< counter-clockwise from outside
        IntegerVec normal;
        mpz_class height, squared_height, squared_normal;
        bool removed = false;
    };

    /// Returns true if the plane of f is strictly nearer to the origin than that of g.
    [[nodiscard]] static bool is_nearer(const Face& f, const Face& g) {
        return f.squared_height * g.squared_normal < g.squared_height * f.squared_normal;
    }

    /// Four points that span space, the origin in their hull.
    explicit ExpandingPolytope(std::vector<DifferencePoint> tetrahedron) : points_(std::move(tetrahedron)) {
        const IntegerVec& corner = points_[0].point;
        const IntegerVec normal = cross(points_[1].point - corner, points_[2].point - corner);
        if (sgn(dot(normal, points_[3].point - corner)) < 0) std::swap(points_[1], points_[2]);
        add_face(0, 2, 1);
        add_face(0, 1, 3);
        add_face(0, 3, 2);
        add_face(1, 2, 3);
    }

    /// Returns the face with its plane nearest to the origin; ties go to the oldest face.
    [[nodiscard]] std::uint32_t nearest() {
        while (faces_[heap_.front()].removed) {
            std::pop_heap(heap_.begin(), heap_.end(), std::bind_front(&ExpandingPolytope::comes_later, this));
            heap_.pop_back();
        }
        return heap_.front();
    }

    /// Takes in a point strictly above that face.
    void expand(std::uint32_t face, DifferencePoint point) {
        const std::uint32_t apex = static_cast<std::uint32_t>(points_.size());
        points_.push_back(std::move(point));
        for (const Edge& edge : remove_below(face, points_[apex].point)) add_face(edge.tail, edge.head, apex);
    }

    [[nodiscard]] const std::vector<DifferencePoint>& points() const { return points_; }
    [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }  ///< the removed ones as well

  private:
    struct Edge {
        std::uint32_t tail, head;
    };

    static std::uint64_t key(std::uint32_t tail, std::uint32_t head) {
        return std::uint64_t{tail} << 32 | head;
    }
    /// Orders the heap: returns true if f is farther from the origin than g, or as far and younger.
    [[nodiscard]] bool comes_later(std::uint32_t f, std::uint32_t g) const {
        if (g < f) return !is_nearer(faces_[f], faces_[g]);
        return is_nearer(faces_[g], faces_[f]);
    }
    void add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const std::uint32_t index = static_cast<std::uint32_t>(faces_.size());
        const IntegerVec& p = points_[a].point;
        Face face;
        face.corner = {a, b, c};
        face.normal = cross(points_[b].point - p, points_[c].point - p);
        face.height = dot(face.normal, p);
        face.squared_height = face.height * face.height;
        face.squared_normal = dot(face.normal, face.normal);
        faces_.push_back(std::move(face));
        for (int i = 0; i < 3; ++i) {
            left_[key(faces_[index].corner[i], faces_[index].corner[(i + 1) % 3])] = index;
        }
        heap_.push_back(index);
        std::push_heap(heap_.begin(), heap_.end(), std::bind_front(&ExpandingPolytope::comes_later, this));
    }
    /// Removes the faces strictly below the point, which are connected; gives the edges around them.
    std::vector<Edge> remove_below(std::uint32_t face, const IntegerVec& point) {
        std::vector<Edge> horizon;
        std::vector<std::uint32_t> open = {face};
        faces_[face].removed = true;
        while (!open.empty()) {
            const std::array<std::uint32_t, 3> corner = faces_[open.back()].corner;
            open.pop_back();
            for (int i = 0; i < 3; ++i) {
                const Edge edge = {corner[i], corner[(i + 1) % 3]};
                const std::uint32_t other = left_.at(key(edge.head, edge.tail));
                if (faces_[other].removed) continue;
                if (dot(faces_[other].normal, point) > faces_[other].height) {
                    faces_[other].removed = true;
                    open.push_back(other);
                } else {
                    horizon.push_back(edge);
                }
            }
        }
        return horizon;
    }

    std::vector<DifferencePoint> points_;
    std::vector<Face> faces_;
    std::vector<std::uint32_t> heap_;                        ///< nearest first; removed ones are passed over
    std::unordered_map<std::uint64_t, std::uint32_t> left_;  ///< the face on the left of a directed edge
};

}  // namespace edgewise::truth
