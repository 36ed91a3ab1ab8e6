// SPDX-License-Identifier: MIT
//
// Must not compile:
// error: both tables of a query must compute in one precision
#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/lean.hpp"

using A = edgewise::aos<edgewise::f32>;
using B = edgewise::lean<edgewise::f64>;

edgewise::Distance ask(const A& a, const B& b, const edgewise::Transform<double>& pose,
                       edgewise::FeaturePair<A, B>& pair) {
    return edgewise::VClip::query(a, b, pose, pair);
}
