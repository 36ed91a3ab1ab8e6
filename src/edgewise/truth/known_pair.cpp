// SPDX-License-Identifier: MIT
#include "edgewise/truth/known_pair.hpp"

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/truth/depth/exact_depth.hpp"
#include "edgewise/truth/filter/float_proof.hpp"

namespace edgewise::truth {

const ExactDistance& KnownPair::exact(const PlacedBodies& bodies) {
    if (!exact_)
        exact_ = std::make_unique<ExactDistance>(
            exact_distance(bodies.a, bodies.pose_a, bodies.b, bodies.pose_b).or_throw());
    return *exact_;
}

double KnownPair::depth(const PlacedBodies& bodies) {
    if (!depth_)
        depth_ = exact_depth(bodies.a, bodies.pose_a, bodies.b, bodies.pose_b, exact(bodies).simplex)
                     .or_throw()
                     .depth;
    return *depth_;
}

ProvenPair StoredPair::know(const PosesOfPair& poses, const Vec3d& guess) {
    PosedPair pair(a_, poses.first, b_, poses.second);
    ProvenPair known;
    known.offset = norm(pair.offset());
    known.ortho = pair.ortho();
    const double narrow = band(known, Tolerance<double>::eps).band;
    const FloatProof proof = prove_distance(pair, guess, narrow);
    if (proof.verdict != FloatVerdict::unknown) {
        known.by = proof.is_wide ? KnownBy::wide_proof : KnownBy::double_proof;
        known.is_grazing = proof.verdict == FloatVerdict::grazing;
        if (known.is_grazing) known.verdict = ExactVerdict::touching;
        if (proof.verdict == FloatVerdict::overlapping) known.verdict = ExactVerdict::overlapping;
        known.lower = proof.lower;
        known.upper = proof.upper;
        return known;
    }
    const ExactDistance& answer = known.answers.exact(placed(poses));
    known.by = KnownBy::exact;
    known.verdict = answer.verdict;
    known.lower = known.upper = answer.distance;
    return known;
}

AccuracyBand StoredPair::band(const ProvenPair& known, double eps) const {
    return accuracy_band({a_.reach(), a_.extent()}, {b_.reach(), b_.extent()}, known.offset, known.ortho,
                         eps);
}

}  // namespace edgewise::truth
