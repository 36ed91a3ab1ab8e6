// SPDX-License-Identifier: MIT
#include "judged_case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "edgewise/bench/certificates.hpp"
#include "edgewise/scene/answer_claim.hpp"

namespace edgewise {

namespace {

/// The answer as a claim. World coordinates far from the origin are only exact to `coarse`.
truth::Claim claim_of(const bench::NamedAnswer& answer) {
    truth::Claim claim = scene::claim_of(answer.distance);
    const double coarse = 4 * Tolerance<double>::eps *
                          std::max(max_abs(answer.distance.point_a), max_abs(answer.distance.point_b));
    claim.witness_error -= coarse;
    claim.depth = answer.depth;
    return claim;
}

/// The pair as the tables hold it, with its exact answers, its error band and the errors that are allowed.
struct Question {
    const scene::Case& given;
    scene::Query query;
    truth::PlacedBodies held;
    truth::AccuracyBand band;
    truth::AllowedErrors allowed;
    truth::KnownPair known = {};
};

void check_answer(const bench::NamedAnswer& answer, Question& asked, JudgedCase& result) {
    const auto complain = [&](const std::string& what) { result.complaints.push_back(what); };
    const truth::ExactDistance& exact = asked.known.exact(asked.held);
    const Distance& d = answer.distance;
    const truth::CheckedAnswer checked =
        truth::check(claim_of(answer), asked.held, asked.known, asked.band, asked.allowed);
    if (checked.verdict_wrong) complain(fmt::format("wrong verdict: {}", to_string(d.status)));
    if (checked.distance_wrong)
        complain(fmt::format("distance {} instead of {}, witness points {} off", d.distance, exact.distance,
                             checked.witness_error));
    if (checked.depth_wrong)
        complain(fmt::format("depth {} instead of {}", answer.depth, asked.known.depth(asked.held)));
    if (!result.apart && exact.verdict != truth::ExactVerdict::separated &&
        asked.known.depth(asked.held) > asked.band.band && d.status != Status::overlapping)
        complain(fmt::format("touching at depth {}", asked.known.depth(asked.held)));
    result.in_band = checked.in_band;
    result.distance = asked.band.beyond(checked.error);
    result.witness = asked.band.beyond(checked.witness_error);
    result.depth = asked.band.beyond(checked.depth_error);
}

void check_certificates(const bench::NamedAnswer& answer, std::span<const Polyhedron> bodies,
                        std::span<const Polyhedron> stored, Question& asked, JudgedCase& result) {
    const auto complain = [&](const std::string& what) { result.complaints.push_back(what); };
    const std::vector<Vec3d>&a = asked.given.a.vertices, &b = asked.given.b.vertices;
    const auto known = bench::certificates_of(answer, asked.query, bodies, stored, a, b);
    if (!known) return complain("no certificate: " + known.error);
    const double exact = asked.known.exact(asked.held).distance;
    const double given = truth::KnownPair().exact({a, asked.query.pose_a, b, asked.query.pose_b}).distance;
    if (!(known->stored.lower <= exact && exact <= known->stored.upper))
        complain("the certificate of the stored bodies misses the exact distance");
    const double most = asked.allowed.distance * asked.band.scale + asked.band.band;
    const auto why = bench::contradiction(answer.distance.distance, known->stored, most, most);
    if (!why.empty()) complain(why);
    if (!(known->given.lower <= given && given <= known->given.upper))
        complain("the certificate of the given bodies misses the exact distance");
}

}  // namespace

JudgedCase judge_case(bench::Runner& runner, const Exactness& exactness, const scene::Case& given) {
    JudgedCase result;
    const auto a = scene::body_from_case(given.a);
    const auto b = scene::body_from_case(given.b);
    result.refusal = !a ? a.error : !b ? b.error : "";
    if (!result.refusal.empty()) return result;
    const std::vector<Polyhedron> bodies = {*a, *b};
    result.refusal = runner.load(bodies);
    if (!result.refusal.empty()) return result;
    const scene::Query query{0, 1, 0, given.pose_a, given.pose_b};
    const bench::NamedAnswer answer = runner.answer(query);
    if (answer.distance.status == Status::failed) {
        result.refusal = "too far from each other for this precision";
        return result;
    }
    result.answered = true;
    result.apart = answer.distance.status == Status::separated;
    const truth::PlacedBodies held = scene::placed(runner.stored_bodies(), query);
    Question asked{given, query, held, held.band(exactness.eps),
                   truth::allowed_errors(exactness.eps, exactness.rounded_planes)};
    check_answer(answer, asked, result);
    check_certificates(answer, bodies, runner.stored_bodies(), asked, result);
    return result;
}

}  // namespace edgewise
