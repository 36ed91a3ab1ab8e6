// SPDX-License-Identifier: MIT
//
// openGJK's scalar GJK, in the precision that its library was built in. It knows no poses: a query takes the
// vertices of both bodies to the world first, and that belongs to its time. It has no start but its own, so
// every query is cold.
#include <openGJK/openGJK.h>

#include <array>
#include <vector>

#include "edgewise/peers/adapters/module.hpp"

namespace edgewise::peers {

namespace {

struct OpenGjk {
    static constexpr const char* name = "open_gjk";
    static constexpr const char* precision = sizeof(gkFloat) == sizeof(double) ? "f64" : "f32";
    static constexpr const char* summary =
        "compute_minimum_distance, with both bodies' vertices taken to the world in each query";
    static constexpr const char* cache = "nothing";

    using Point = std::array<gkFloat, 3>;
    struct Shape {
        explicit Shape(const Polyhedron& body) {
            vertices.reserve(body.vertices.size());
            for (const Vec3d& v : body.vertices) vertices.push_back(to_point(v));
        }
        std::vector<Point> vertices;
    };
    struct Placed {
        explicit Placed(const Pose& pose) : translation(to_point(pose.translation)) {
            for (int i = 0; i < 3; ++i) rows[i] = to_point(pose.rotation.row(i));
        }
        std::array<Point, 3> rows;
        Point translation;
    };
    struct Cache {};

    static Point to_point(const Vec3d& v) {
        return {static_cast<gkFloat>(v.x()), static_cast<gkFloat>(v.y()), static_cast<gkFloat>(v.z())};
    }

    /// Vertices in the world, with the pointer to each that openGJK asks for; kept, so that queries do not
    /// allocate. One for each side: both may be of one shape.
    struct World {
        std::vector<Point> points;
        std::vector<gkFloat*> pointers;

        gkPolytope place(const Shape& shape, const Placed& at) {
            const std::size_t count = shape.vertices.size();
            if (points.size() < count) {
                points.resize(count);
                pointers.clear();
                for (Point& point : points) pointers.push_back(point.data());
            }
            for (std::size_t i = 0; i < count; ++i) {
                const Point& v = shape.vertices[i];
                for (int k = 0; k < 3; ++k) {
                    const Point& row = at.rows[k];
                    points[i][k] = row[0] * v[0] + row[1] * v[1] + row[2] * v[2] + at.translation[k];
                }
            }
            gkPolytope placed{};
            placed.numpoints = static_cast<int>(count);
            placed.coord = pointers.data();
            return placed;
        }
    };

    static PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b, Cache&,
                            bool) {
        static World world_a, world_b;
        gkSimplex simplex;
        simplex.nvrtx = 0;
        const gkFloat distance =
            compute_minimum_distance(world_a.place(a, at_a), world_b.place(b, at_b), &simplex);
        if (!(distance > 0)) return {};
        const auto witness = [&](int i) {
            const gkFloat* w = simplex.witnesses[i];
            return Vec3d(w[0], w[1], w[2]);
        };
        return {.separated = true, .distance = distance, .point_a = witness(0), .point_b = witness(1)};
    }
};

}  // namespace

extern "C" const PeerInfo* edgewise_peer() { return &info_of<OpenGjk>; }

}  // namespace edgewise::peers
