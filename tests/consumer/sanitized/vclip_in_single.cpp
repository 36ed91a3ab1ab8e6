// SPDX-License-Identifier: MIT
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/layouts/aos.hpp"
#include "queries.hpp"

void queries::add_vclip_in_single(const Polyhedron& body, int poses, std::vector<double>& sums) {
    sums.push_back(sum_of_distances<VClip, aos<f32>>(body, poses));
}
