// SPDX-License-Identifier: MIT
//
// MuJoCo's collision of convex bodies, written from the calls. The distance is that of the centres of the
// bodies' boxes. Hill climbing and the table of extremes must give the same sides of a box.
#pragma once

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

inline constexpr mjtNum mjMAX_LIMIT = DBL_MAX;

struct mjCCDObj {
    int geom, geom_type;
    mjtNum pos[3], mat[9], margin;
    struct {
        struct {
            int nvert;
            const float* vert;
            const int* graph;
            const int* extrema;
        } mesh;
    } data;
};

struct mjCCDConfig {
    int max_iterations;
    mjtNum tolerance;
    int max_contacts;
    mjtNum dist_cutoff;
};

struct mjCCDStatus {
    mjtNum x1[3], x2[3];
};

inline void mjc_initCCDObj(mjCCDObj* object, const mjModel* model, const mjData* data, int geom,
                           mjtNum margin) {
    const int mesh = model->geom_dataid[geom];
    object->geom = geom;
    object->geom_type = model->geom_type[geom];
    object->margin = margin;
    std::copy_n(data->geom_xpos + 3 * geom, 3, object->pos);
    std::copy_n(data->geom_xmat + 9 * geom, 9, object->mat);
    object->data.mesh = {model->mesh_vertnum[mesh], model->mesh_vert + 3 * model->mesh_vertadr[mesh],
                         model->mesh_graph + model->mesh_graphadr[mesh], model->mesh_extrema + 27 * mesh};
}

/// The highest coordinate along the axis, in the body's frame, at the table's vertex. A climb from the first
/// vertex must find the same vertex.
inline mjtNum highest(const mjCCDObj& object, int axis, int sign) {
    const auto& mesh = object.data.mesh;
    const int count = mesh.graph[0];
    const int *lists_at = mesh.graph + 2, *names = lists_at + count, *lists = names + count;
    const auto height = [&](int v) { return sign * mesh.vert[3 * names[v] + axis]; };
    const int step = axis == 0 ? 9 : axis == 1 ? 3 : 1;
    const int first = mesh.extrema[13 + sign * step];
    int best = 0;
    for (int before = -1; before != best;) {
        before = best;
        for (const int* next = lists + lists_at[before]; *next >= 0; ++next) {
            if (height(*next) > height(best)) best = *next;
        }
    }
    return height(best) == height(first) && count == mesh.nvert ? static_cast<mjtNum>(height(first))
                                                                : mjMAX_LIMIT;
}

inline void centre_of(const mjCCDObj& object, mjtNum centre[3]) {
    mjtNum local[3];
    for (int k = 0; k < 3; ++k) local[k] = (highest(object, k, 1) - highest(object, k, -1)) / 2;
    for (int k = 0; k < 3; ++k) {
        const mjtNum* row = object.mat + 3 * k;
        centre[k] = row[0] * local[0] + row[1] * local[1] + row[2] * local[2] + object.pos[k];
    }
}

inline mjtNum mjc_ccd(const mjCCDConfig* config, mjCCDStatus* status, mjCCDObj* a, mjCCDObj* b) {
    if (a->geom_type != mjGEOM_MESH || b->geom_type != mjGEOM_MESH || config->max_contacts > 0)
        return mjMAX_LIMIT;
    centre_of(*a, status->x1);
    centre_of(*b, status->x2);
    const mjtNum distance = std::hypot(status->x1[0] - status->x2[0], status->x1[1] - status->x2[1],
                                       status->x1[2] - status->x2[2]);
    return distance > config->dist_cutoff ? mjMAX_LIMIT : distance;
}
