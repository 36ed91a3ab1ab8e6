// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/checked_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "edgewise/studies/stability_tally.hpp"

namespace edgewise::studies::campaign {

namespace {

/// | |p_a - p_b| - d | of a separated answer with a distance, else 0.
double witness_error(const Distance& answer, const Cell& cell) {
    if (answer.status != Status::separated || cell.verdict_only) return 0;
    return std::abs(norm(Vec3d(answer.point_a - answer.point_b)) - answer.distance);
}

/// NaN is the worst.
double worse(double a, double b) { return std::isnan(a) || a > b ? a : b; }

/// Whether the interval alone proves the answer right; sets the error's bound.
bool is_proven(const Distance& answer, const KnownPair& known, const truth::AccuracyBand& band,
               const Cell& cell, CheckedAnswer& checked) {
    const bool separated = answer.status == Status::separated;
    checked.in_band = known.is_grazing || (known.is_separated() && known.upper <= band.band);
    if (known.is_grazing) {
        if (separated && !cell.verdict_only && !(answer.distance <= band.band)) return false;
    } else if (separated != known.is_separated()) {
        return !separated && checked.in_band;
    }
    if (cell.verdict_only) return true;
    const double off = separated ? std::max(answer.distance - known.lower, known.upper - answer.distance) : 0;
    checked.error = error_beyond(worse(off, witness_error(answer, cell)), band);
    return checked.error <= cell.error_allowed;
}

void check_exactly(const Distance& answer, const Cell& cell, const StoredPair& stored,
                   const std::pair<Pose, Pose>& poses, const truth::AccuracyBand& band, KnownPair& known,
                   CheckedAnswer& checked) {
    const truth::ExactDistance& exact = stored.exact(poses, known);
    const bool separated = answer.status == Status::separated;
    std::optional<double> depth;
    if (separated && exact.verdict != truth::ExactVerdict::separated) depth = stored.depth(poses, known);
    const double distance = cell.verdict_only ? 0 : answer.distance;
    const truth::Judgement judged = truth::judge({separated, distance}, exact, band, depth);
    checked.was_exact = true;
    checked.in_band = judged.in_band;
    if (!cell.verdict_only)
        checked.error = error_beyond(worse(judged.error, witness_error(answer, cell)), band);
    if (!judged.verdict_wrong && checked.error <= cell.error_allowed) return;
    checked.wrong = fmt::format(
        "{}: {} at {:.17g}, witness points {:.3g} off, exactly {} at {:.17g}{}; band {:.3g}, scale {:.3g}",
        judged.verdict_wrong ? "wrong verdict" : "wrong distance", to_string(answer.status), answer.distance,
        witness_error(answer, cell), to_string(exact.verdict), exact.distance,
        depth ? fmt::format(", {:.3g} deep", *depth) : "", band.band, band.scale);
}

}  // namespace

CheckedAnswer check_answer(const Distance& answer, const Cell& cell, const StoredPair& stored,
                           const std::pair<Pose, Pose>& poses, KnownPair& known) {
    CheckedAnswer checked;
    checked.refused = answer.status == Status::failed;
    if (checked.refused) return checked;
    const truth::AccuracyBand band = stored.band(known, cell.eps);
    if (!is_proven(answer, known, band, cell, checked))
        check_exactly(answer, cell, stored, poses, band, known, checked);
    return checked;
}

}  // namespace edgewise::studies::campaign
