// SPDX-License-Identifier: MIT
//
// The part of openGJK's interface that its adapter uses, written from the calls. The distance is that of the means of
// the vertices.
#pragma once

#include <cmath>

#ifdef USE_32BITS
using gkFloat = float;
#else
using gkFloat = double;
#endif

struct gkPolytope {
    int numpoints;
    gkFloat** coord;
};

struct gkSimplex {
    int nvrtx;
    gkFloat witnesses[2][3];
};

inline gkFloat compute_minimum_distance(gkPolytope a, gkPolytope b, gkSimplex* simplex) {
    gkFloat squared = 0;
    for (int k = 0; k < 3; ++k) {
        gkFloat* witness[2] = {&simplex->witnesses[0][k], &simplex->witnesses[1][k]};
        *witness[0] = *witness[1] = 0;
        for (int i = 0; i < a.numpoints; ++i)
            *witness[0] += a.coord[i][k] / static_cast<gkFloat>(a.numpoints);
        for (int i = 0; i < b.numpoints; ++i)
            *witness[1] += b.coord[i][k] / static_cast<gkFloat>(b.numpoints);
        squared += (*witness[0] - *witness[1]) * (*witness[0] - *witness[1]);
    }
    return std::sqrt(squared);
}
