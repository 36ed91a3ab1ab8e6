// SPDX-License-Identifier: MIT
//
// The part of MuJoCo's model and state that its adapter uses, written from the calls.
#pragma once

using mjtNum = double;

enum mjtGeom { mjGEOM_SPHERE = 2, mjGEOM_MESH = 7 };

struct mjModel {
    int* geom_type;
    int* geom_dataid;
    mjtNum* geom_size;
    int* mesh_vertadr;
    int* mesh_vertnum;
    int* mesh_graphadr;
    int* mesh_polyadr;
    int* mesh_polynum;
    int* mesh_extrema;
    int* mesh_graph;
    float* mesh_vert;
};

struct mjData {
    mjtNum* geom_xpos;
    mjtNum* geom_xmat;
};
