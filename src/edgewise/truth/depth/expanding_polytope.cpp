// SPDX-License-Identifier: MIT
//
// Faces are never erased, only marked: an index stays good, and the heap drops the dead when they surface.
#include "edgewise/truth/depth/expanding_polytope.hpp"

#include <algorithm>
#include <utility>

namespace edgewise::truth {

namespace {

std::uint64_t key(std::uint32_t tail, std::uint32_t head) { return std::uint64_t{tail} << 32 | head; }

}  // namespace

bool is_nearer(const ExpandingPolytope::Face& f, const ExpandingPolytope::Face& g) {
    return f.squared_height * g.squared_normal < g.squared_height * f.squared_normal;
}

ExpandingPolytope::ExpandingPolytope(std::vector<DifferencePoint> tetrahedron)
    : points_(std::move(tetrahedron)) {
    const IntegerVec& corner = points_[0].point;
    const IntegerVec normal = cross(points_[1].point - corner, points_[2].point - corner);
    if (sgn(dot(normal, points_[3].point - corner)) < 0) std::swap(points_[1], points_[2]);
    add_face(0, 2, 1);
    add_face(0, 1, 3);
    add_face(0, 3, 2);
    add_face(1, 2, 3);
}

void ExpandingPolytope::add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
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
    std::push_heap(heap_.begin(), heap_.end(),
                   [this](std::uint32_t f, std::uint32_t g) { return comes_later(f, g); });
}

bool ExpandingPolytope::comes_later(std::uint32_t f, std::uint32_t g) const {
    if (g < f) return !is_nearer(faces_[f], faces_[g]);
    return is_nearer(faces_[g], faces_[f]);
}

std::uint32_t ExpandingPolytope::nearest() {
    while (faces_[heap_.front()].removed) {
        std::pop_heap(heap_.begin(), heap_.end(),
                      [this](std::uint32_t f, std::uint32_t g) { return comes_later(f, g); });
        heap_.pop_back();
    }
    return heap_.front();
}

/// Removes the faces strictly below the point, which are connected; gives the edges around them.
std::vector<ExpandingPolytope::Edge> ExpandingPolytope::remove_below(std::uint32_t face,
                                                                     const IntegerVec& point) {
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

void ExpandingPolytope::expand(std::uint32_t face, DifferencePoint point) {
    const std::uint32_t apex = static_cast<std::uint32_t>(points_.size());
    points_.push_back(std::move(point));
    for (const Edge& edge : remove_below(face, points_[apex].point)) add_face(edge.tail, edge.head, apex);
}

}  // namespace edgewise::truth
