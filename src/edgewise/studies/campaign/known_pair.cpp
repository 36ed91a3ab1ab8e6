// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/known_pair.hpp"

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/truth/depth/exact_depth.hpp"

namespace edgewise::studies::campaign {

KnownPair StoredPair::know(const std::pair<Pose, Pose>& poses, const Vec3d& guess) {
    truth::PosedPair pair(a_, poses.first, b_, poses.second);
    KnownPair known;
    known.offset = norm(pair.offset());
    known.ortho = pair.ortho();
    const double narrow = band(known, Tolerance<double>::eps).band;
    const truth::FloatProof proof = truth::prove_distance(pair, guess, narrow);
    if (proof.verdict != truth::FloatVerdict::unknown) {
        known.by = proof.is_wide ? KnownBy::wide_proof : KnownBy::double_proof;
        known.is_grazing = proof.verdict == truth::FloatVerdict::grazing;
        if (known.is_grazing) known.verdict = truth::ExactVerdict::touching;
        if (proof.verdict == truth::FloatVerdict::overlapping)
            known.verdict = truth::ExactVerdict::overlapping;
        known.lower = proof.lower;
        known.upper = proof.upper;
        return known;
    }
    const truth::ExactDistance& answer = exact(poses, known);
    known.by = KnownBy::exact;
    known.verdict = answer.verdict;
    known.lower = known.upper = answer.distance;
    return known;
}

const truth::ExactDistance& StoredPair::exact(const std::pair<Pose, Pose>& poses, KnownPair& known) const {
    if (!known.exact)
        known.exact = std::make_unique<truth::ExactDistance>(
            truth::exact_distance(a_.vertices(), poses.first, b_.vertices(), poses.second).or_throw());
    return *known.exact;
}

double StoredPair::depth(const std::pair<Pose, Pose>& poses, KnownPair& known) const {
    if (!known.depth)
        known.depth = truth::exact_depth(a_.vertices(), poses.first, b_.vertices(), poses.second,
                                         exact(poses, known).simplex)
                          .or_throw()
                          .depth;
    return *known.depth;
}

truth::AccuracyBand StoredPair::band(const KnownPair& known, double eps) const {
    return truth::accuracy_band({a_.reach(), a_.extent()}, {b_.reach(), b_.extent()}, known.offset,
                                known.ortho, eps);
}

}  // namespace edgewise::studies::campaign
