// SPDX-License-Identifier: MIT
//
// An engine's own shape in a query: the points stay in the engine's memory; no table is built and nothing is
// copied. GJK needs two types and three functions of a shape (table/contract.hpp). V-Clip needs a layout with
// edges, faces and their planes.
#include <array>
#include <cstdint>
#include <cstdio>
#include <edgewise/algorithms/gjk.hpp>
#include <edgewise/algorithms/penetration.hpp>
#include <span>

/// Corners of a convex body, in single precision as engines have them.
class Corners {
  public:
    using PrecisionType = edgewise::mixed;  // stored in single, computed in double
    using Vertex = std::uint32_t;           // any type that can be copied and compared

    explicit Corners(std::span<const std::array<float, 3>> points) : points_(points) {}

    Vertex first_vertex() const { return 0; }
    edgewise::Vec3d vertex(Vertex v) const { return {points_[v][0], points_[v][1], points_[v][2]}; }
    auto all_vertices() const { return edgewise::index_range(static_cast<std::uint32_t>(points_.size())); }

  private:
    std::span<const std::array<float, 3>> points_;
};

static_assert(edgewise::SupportTable<Corners>);

constexpr std::array<std::array<float, 3>, 8> cube = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};

int main() {
    const Corners shape(cube);
    edgewise::SimplexPair<Corners, Corners> pair(shape,
                                                 shape);  // one per pair of bodies, kept between frames
    edgewise::PenetrationSpace space;                     // one per thread
    const edgewise::Pose a;
    edgewise::Pose b;
    for (const double x : {3.0, 1.5, 0.75}) {
        b.translation = {x, 0.25, 0.125};
        const edgewise::Transform<double> a_from_b = edgewise::relative_pose(a, b);
        const edgewise::Distance answer = edgewise::Gjk::query(shape, shape, a_from_b, pair);
        if (answer.status == edgewise::Status::separated) {
            std::printf("separated %g along %g %g %g\n", answer.distance, answer.normal.x(),
                        answer.normal.y(), answer.normal.z());
        } else {
            const auto overlap = edgewise::penetration(shape, shape, a_from_b, pair, space);
            std::printf("overlapping %g along %g %g %g\n", overlap.depth, overlap.normal.x(),
                        overlap.normal.y(), overlap.normal.z());
        }
    }
}
