// SPDX-License-Identifier: MIT
#include "judged_case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "edgewise/bench/certificates.hpp"
#include "edgewise/scene/answer_claim.hpp"

namespace edgewise {

namespace {

/// World coordinates far from the origin hold no finer difference than `coarse`.
truth::Claim claim_of(const bench::NamedAnswer& answer) {
    truth::Claim claim = scene::claim_of(answer.distance);
    const double coarse = 4 * Tolerance<double>::eps *
                          std::max(max_abs(answer.distance.point_a), max_abs(answer.distance.point_b));
    claim.witness_error -= coarse;
    claim.depth = answer.depth;
    return claim;
}

class Judge {
  public:
    Judge(bench::Runner& runner, const Exactness& exactness, const scene::Case& given,
          const scene::Query& query, std::span<const Polyhedron> bodies, JudgedCase& result)
        : runner_(runner),
          given_(given),
          query_(query),
          bodies_(bodies),
          held_(scene::placed(runner.stored_bodies(), query)),
          allowed_(truth::allowed_errors(exactness.eps, exactness.rounded_planes)),
          result_(result) {
        const bench::NamedAnswer answer = runner.answer(query);
        if (answer.distance.status == Status::failed) {
            result_.refusal = "too far from each other for this precision";
            return;
        }
        result_.answered = true;
        result_.apart = answer.distance.status == Status::separated;
        check(answer, exactness.eps);
        certificates(answer);
    }

  private:
    void complain(const std::string& what) { result_.complaints.push_back(what); }

    void check(const bench::NamedAnswer& answer, double eps) {
        const truth::ExactDistance& exact = known_.exact(held_);
        const Distance& d = answer.distance;
        band_ = held_.band(eps);
        const truth::CheckedAnswer checked = truth::check(claim_of(answer), held_, known_, band_, allowed_);
        if (checked.verdict_wrong) complain(fmt::format("wrong verdict: {}", to_string(d.status)));
        if (checked.distance_wrong)
            complain(fmt::format("distance {} instead of {}, witness points {} off", d.distance,
                                 exact.distance, checked.witness_error));
        if (checked.depth_wrong)
            complain(fmt::format("depth {} instead of {}", answer.depth, known_.depth(held_)));
        if (!result_.apart && exact.verdict != truth::ExactVerdict::separated &&
            known_.depth(held_) > band_.band && d.status != Status::overlapping)
            complain(fmt::format("touching at depth {}", known_.depth(held_)));
        result_.in_band = checked.in_band;
        result_.distance = band_.beyond(checked.error);
        result_.witness = band_.beyond(checked.witness_error);
        result_.depth = band_.beyond(checked.depth_error);
    }

    void certificates(const bench::NamedAnswer& answer) {
        const std::vector<Vec3d>&a = given_.a.vertices, &b = given_.b.vertices;
        const auto known = bench::certificates_of(answer, query_, bodies_, runner_.stored_bodies(), a, b);
        if (!known) return complain("no certificate: " + known.error);
        const double exact = known_.exact(held_).distance,
                     given = truth::KnownPair().exact({a, query_.pose_a, b, query_.pose_b}).distance;
        if (!(known->stored.lower <= exact && exact <= known->stored.upper))
            complain("the certificate of the stored bodies misses the exact distance");
        const double most = allowed_.distance * band_.scale + band_.band;
        if (const auto why = bench::contradiction(answer.distance.distance, known->stored, most, most);
            !why.empty())
            complain(why);
        if (!(known->given.lower <= given && given <= known->given.upper))
            complain("the certificate of the given bodies misses the exact distance");
    }

    bench::Runner& runner_;
    const scene::Case& given_;
    const scene::Query& query_;
    std::span<const Polyhedron> bodies_;
    truth::PlacedBodies held_;
    truth::AllowedErrors allowed_;
    JudgedCase& result_;
    truth::KnownPair known_;
    truth::AccuracyBand band_;
};

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
    Judge(runner, exactness, given, query, bodies, result);
    return result;
}

}  // namespace edgewise
