// SPDX-License-Identifier: MIT
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/lean.hpp"
#include "queries.hpp"

void queries::add_vclip_in_double(const Polyhedron& body, int poses, std::vector<double>& sums) {
    sums.push_back(sum_of_distances<VClip, aos<f64>>(body, poses));
    sums.push_back(sum_of_distances<VClip, lean<f64>>(body, poses));
}
