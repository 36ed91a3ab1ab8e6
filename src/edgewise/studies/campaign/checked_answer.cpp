// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/checked_answer.hpp"

#include <fmt/format.h>

#include "edgewise/scene/answer_claim.hpp"

namespace edgewise::studies::campaign {

truth::CheckedAnswer check_answer(const Distance& answer, const Cell& cell, const truth::StoredPair& stored,
                                  const truth::PosesOfPair& poses, truth::ProvenPair& known) {
    truth::Claim claim = scene::claim_of(answer, cell.verdict_only);
    if (cell.verdict_only) claim.distance = 0;  // a bound, which may be any
    return truth::check(claim, stored, poses, known, stored.band(known, cell.eps), {cell.error_allowed});
}

std::string what_is_wrong(const truth::CheckedAnswer& checked, const Distance& answer,
                          const truth::StoredPair& stored, const truth::PosesOfPair& poses,
                          truth::ProvenPair& known) {
    if (!checked.wrong()) return {};
    const truth::PlacedBodies bodies = stored.placed(poses);
    const truth::ExactDistance& exact = known.answers.exact(bodies);
    const bool deep = answer.status == Status::separated && exact.verdict != truth::ExactVerdict::separated;
    return fmt::format(
        "{}: {} at {:.17g}, witness points {:.3g} off, exactly {} at {:.17g}{}; band {:.3g}, scale {:.3g}",
        checked.verdict_wrong ? "wrong verdict" : "wrong distance", to_string(answer.status), answer.distance,
        checked.witness_error, to_string(exact.verdict), exact.distance,
        deep ? fmt::format(", {:.3g} deep", known.answers.depth(bodies)) : "", checked.band.band,
        checked.band.scale);
}

}  // namespace edgewise::studies::campaign
