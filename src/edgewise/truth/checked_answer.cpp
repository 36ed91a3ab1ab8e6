// SPDX-License-Identifier: MIT
//
// Comparisons are written so that NaN is wrong.
#include "edgewise/truth/checked_answer.hpp"

#include <algorithm>
#include <cmath>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/truth/exact_proof.hpp"
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

namespace {

/// NaN is the worst.
double worse(double a, double b) { return std::isnan(a) || a > b ? a : b; }

/// The excess that a gap tolerance allows: gap_tolerance times the answer, so a little more than that times
/// the true distance.
double given_away(double gap_tolerance, double distance) {
    return gap_tolerance / (1 - gap_tolerance) * distance;
}

/// Signed distance beyond the contact tolerance; no value for an overlap if its depth is not needed.
std::optional<double> signed_gap(const ExactDistance& exact, const PlacedBodies& bodies, KnownPair& known,
                                 bool needs_depth, double tolerance) {
    if (exact.verdict != ExactVerdict::overlapping) return exact.distance - tolerance;
    if (!needs_depth) return std::nullopt;
    return -known.depth(bodies) - tolerance;
}

void check_verdict(const Claim& claim, bool separated, std::optional<double> gap, double tolerance,
                   CheckedAnswer& checked) {
    const double band = checked.band.band;
    checked.in_band = gap && std::abs(*gap) <= band;
    const bool claim_inside = !claim.separated || claim.distance - tolerance <= band;
    if (claim.separated != separated) checked.verdict_wrong = !(checked.in_band && claim_inside);
    if (claim.failed || (claim.separated && std::isnan(claim.distance))) checked.verdict_wrong = true;
}

/// Returns no value if the interval does not prove the answer right.
std::optional<CheckedAnswer> check_by_interval(const Claim& claim, const ProvenPair& known,
                                               const AccuracyBand& band, const AllowedErrors& allowed) {
    CheckedAnswer checked;
    checked.exact = known.verdict;
    checked.band = band;
    checked.is_bound = true;
    checked.in_band = known.is_grazing || (known.is_separated() && known.upper <= band.band);
    if (known.is_grazing) {
        if (claim.separated && !claim.verdict_only && !(claim.distance <= band.band)) return std::nullopt;
    } else if (claim.separated != known.is_separated()) {
        if (claim.separated || !checked.in_band) return std::nullopt;
        return checked;
    }
    checked.has_distance = !claim.verdict_only;
    if (claim.verdict_only) return checked;
    if (claim.separated) checked.error = std::max(claim.distance - known.lower, known.upper - claim.distance);
    checked.witness_error = claim.witness_error;
    if (!(checked.worst_beyond() <= allowed.distance)) return std::nullopt;
    return checked;
}

}  // namespace

double CheckedAnswer::worst_beyond() const { return band.beyond(worse(error, witness_error)); }

double distance_error(const Claim& claim, const ExactDistance& exact, double contact_tolerance) {
    const double claimed = claim.separated ? claim.distance - contact_tolerance : 0;
    return std::abs(claimed - std::max(exact.distance - contact_tolerance, 0.0));
}

CheckedAnswer check(const Claim& claim, const PlacedBodies& bodies, KnownPair& known,
                    const AccuracyBand& band, const AllowedErrors& allowed, const Leeway& leeway) {
    const double tolerance = leeway.contact_tolerance;
    const ExactDistance& exact = known.exact(bodies);
    const bool in_contact = exact.verdict != ExactVerdict::separated;
    const bool separated = !in_contact && exact.distance > tolerance;
    CheckedAnswer checked;
    checked.band = band;
    checked.exact = in_contact || separated ? exact.verdict : ExactVerdict::touching;
    const bool needs_depth = claim.separated || claim.depth;
    check_verdict(claim, separated, signed_gap(exact, bodies, known, needs_depth, tolerance), tolerance,
                  checked);
    checked.has_distance = !claim.verdict_only;
    if (claim.verdict_only) return checked;
    checked.error = distance_error(claim, exact, tolerance);
    checked.witness_error = claim.witness_error;
    const double longer = given_away(leeway.gap_tolerance, exact.distance);
    const auto counted = [&](double error) {
        return allowed.beyond_band ? band.beyond(error) : band.over_scale(error);
    };
    checked.distance_wrong = !(counted(checked.error) <= allowed.distance + band.over_scale(longer)) ||
                             !(counted(checked.witness_error) <= allowed.distance);
    if (claim.depth && in_contact && !claim.separated) {
        checked.depth_error = std::abs(*claim.depth - known.depth(bodies));
        checked.depth_wrong = !(band.beyond(checked.depth_error) <= allowed.depth);
    }
    return checked;
}

CheckedAnswer check_nearness(bool nearer, const ExactDistance& exact, double margin, const AccuracyBand& band,
                             double gap_tolerance) {
    const double beyond = exact.distance - margin;
    CheckedAnswer checked;
    checked.has_distance = false;
    checked.exact = exact.verdict;
    checked.band = band;
    checked.in_band = std::abs(beyond) <= band.band;
    const bool right = nearer ? beyond < 0 : beyond + given_away(gap_tolerance, exact.distance) >= 0;
    checked.verdict_wrong = !(right || checked.in_band);
    return checked;
}

CheckedAnswer check(const Claim& claim, const StoredPair& bodies, const PosesOfPair& poses, ProvenPair& known,
                    const AccuracyBand& band, const AllowedErrors& allowed) {
    if (const auto proven = check_by_interval(claim, known, band, allowed)) return *proven;
    return check(claim, bodies.placed(poses), known.answers, band, allowed);
}

}  // namespace edgewise::truth
