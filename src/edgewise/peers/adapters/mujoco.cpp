// SPDX-License-Identifier: MIT
//
// MuJoCo's own convex collision (mjc_ccd) with its default settings, for distances alone. It computes in
// double on vertices in single. A shape is what its compiler makes of a mesh: neighbours of each vertex to
// climb along, and the farthest vertex in each of 26 directions to begin at. Each query starts cold.
#include <mujoco/mujoco.h>

#include <engine/engine_collision_gjk.h>

#include <algorithm>
#include <array>
#include <vector>

#include "edgewise/peers/adapters/module.hpp"

namespace edgewise::peers {

namespace {

/// Numbers of vertices and of faces; where each vertex's list begins; which vertex of the mesh it is; the
/// lists, each ended by -1; no faces, which support does not ask for.
[[nodiscard]] std::vector<int> graph_of(const Polyhedron& body) {
    const auto count = static_cast<int>(body.vertex_count());
    std::vector<int> graph = {count, 0}, lists;
    for (int v = 0; v < count; ++v) {
        graph.push_back(static_cast<int>(lists.size()));
        for (const HalfEdge h : body.ring_of_vertex(static_cast<Index>(v)))
            lists.push_back(static_cast<int>(body.head(h)));
        lists.push_back(-1);
    }
    for (int v = 0; v < count; ++v) graph.push_back(v);
    graph.insert(graph.end(), lists.begin(), lists.end());
    return graph;
}

/// The farthest vertex in each direction with components -1, 0 and 1.
[[nodiscard]] std::array<int, 27> extremes_of(const Polyhedron& body) {
    std::array<int, 27> extremes{};
    for (int k = 0; k < 27; ++k) {
        const Vec3d direction(k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1);
        const auto lower = [&](const Vec3d& v, const Vec3d& w) {
            return dot(v, direction) < dot(w, direction);
        };
        extremes[k] = static_cast<int>(std::max_element(body.vertices.begin(), body.vertices.end(), lower) -
                                       body.vertices.begin());
    }
    return extremes;
}

struct MuJoCo {
    static constexpr const char* name = "mujoco";
    static constexpr const char* precision = sizeof(mjtNum) == sizeof(double) ? "mixed" : "f32";
    static constexpr const char* summary =
        "mjc_ccd on a mesh, no contacts asked for; verdicts with a cutoff of 0";
    static constexpr const char* cache = "nothing";

    struct Shape {
        explicit Shape(const Polyhedron& body) : graph(graph_of(body)), extremes(extremes_of(body)) {
            for (const Vec3d& v : body.vertices) {
                for (int k = 0; k < 3; ++k) vertices.push_back(static_cast<float>(v[k]));
            }
            describe(static_cast<int>(body.vertex_count()));
        }
        Shape(const Shape&) = delete;
        Shape& operator=(const Shape&) = delete;

        std::vector<float> vertices;
        std::vector<int> graph;
        std::array<int, 27> extremes;
        mjCCDObj object{};

      private:
        /// By a model that has this one mesh: how its support is found is MuJoCo's choice.
        void describe(int count) {
            int zero = 0, mesh = mjGEOM_MESH;
            mjtNum none[9] = {};
            mjModel model{};
            model.geom_type = &mesh;
            model.geom_size = none;
            model.geom_dataid = model.mesh_graphadr = model.mesh_vertadr = model.mesh_polyadr =
                model.mesh_polynum = &zero;
            model.mesh_vertnum = &count;
            model.mesh_vert = vertices.data();
            model.mesh_graph = graph.data();
            model.mesh_extrema = extremes.data();
            mjData data{};
            data.geom_xpos = data.geom_xmat = none;
            mjc_initCCDObj(&object, &model, &data, 0, 0);
        }
    };
    struct Placed {
        explicit Placed(const Pose& pose) {
            for (int i = 0; i < 3; ++i) {
                position[i] = static_cast<mjtNum>(pose.translation[i]);
                for (int k = 0; k < 3; ++k) matrix[3 * i + k] = static_cast<mjtNum>(pose.rotation(i, k));
            }
        }
        mjtNum position[3], matrix[9];
    };
    struct Cache {};

    static mjCCDObj placed(const Shape& shape, const Placed& at) {
        mjCCDObj object = shape.object;
        std::copy_n(at.position, 3, object.pos);
        std::copy_n(at.matrix, 9, object.mat);
        return object;
    }

    static PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b, Cache&,
                            bool verdict_alone) {
        mjCCDConfig settings{};
        settings.max_iterations = 35;
        settings.tolerance = static_cast<mjtNum>(1e-6);
        settings.dist_cutoff = verdict_alone ? 0 : mjMAX_LIMIT;
        mjCCDObj object_a = placed(a, at_a), object_b = placed(b, at_b);
        mjCCDStatus status;
        const mjtNum distance = mjc_ccd(&settings, &status, &object_a, &object_b);
        PeerAnswer answer;
        answer.answered = verdict_alone || distance < mjMAX_LIMIT;
        answer.separated = answer.answered && distance > 0;
        if (verdict_alone || !answer.separated) return answer;
        answer.distance = distance;
        answer.point_a = {status.x1[0], status.x1[1], status.x1[2]};
        answer.point_b = {status.x2[0], status.x2[1], status.x2[2]};
        return answer;
    }
};

}  // namespace

extern "C" const PeerInfo* edgewise_peer() { return &info_of<MuJoCo>; }

}  // namespace edgewise::peers
