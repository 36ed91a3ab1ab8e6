// SPDX-License-Identifier: MIT
#include "judged_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "edgewise/bench/certificates.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/truth/accuracy_band.hpp"
#include "edgewise/truth/depth/exact_depth.hpp"

namespace edgewise {

namespace {

class Judge {
  public:
    Judge(bench::Runner& runner, const Exactness& exactness, const scene::Case& given,
          const scene::Query& query, std::span<const Polyhedron> bodies, JudgedCase& result)
        : runner_(runner),
          given_(given),
          query_(query),
          bodies_(bodies),
          single_(exactness.as_single),
          result_(result) {
        const auto exact = truth::exact_distance(vertices(0), query.pose_a, vertices(1), query.pose_b);
        if (!exact) {
            complain("no exact answer: " + exact.error);
            return;
        }
        exact_ = *exact;
        band_ = truth::accuracy_band(vertices(0), query.pose_a, vertices(1), query.pose_b, exactness.eps);
        const bench::NamedAnswer answer = runner.answer(query);
        if (answer.distance.status == Status::failed) {
            result_.refusal = "too far from each other for this precision";
            return;
        }
        result_.answered = true;
        result_.apart = answer.distance.status == Status::separated;
        distance(answer);
        certificates(answer);
    }

  private:
    void complain(const std::string& what) { result_.complaints.push_back(what); }

    [[nodiscard]] std::span<const Vec3d> vertices(std::size_t body) const {
        return runner_.stored_bodies()[body].vertices;
    }

    [[nodiscard]] double allowed(double in_double) const {
        return (single_ ? verified_error_single : in_double) * band_.scale + band_.band;
    }

    /// Over scale, beyond the band; two points at one place have no scale.
    [[nodiscard]] double beyond(double error) const {
        return error == 0 ? 0 : (error - band_.band) / band_.scale;
    }

    void distance(const bench::NamedAnswer& answer) {
        std::optional<double> depth;
        if (exact_.verdict != truth::ExactVerdict::separated) {
            const auto found =
                truth::exact_depth(vertices(0), query_.pose_a, vertices(1), query_.pose_b, exact_.simplex);
            if (!found) return complain("no exact depth: " + found.error);
            depth = found->depth;
        }
        const truth::Judgement judged =
            truth::judge({result_.apart, answer.distance.distance}, exact_, band_, depth);
        if (judged.verdict_wrong)
            complain("wrong verdict: " + std::string(to_string(answer.distance.status)));
        if (!(judged.error <= allowed(verified_error_double)))
            complain(fmt::format("distance {} instead of {}", answer.distance.distance, exact_.distance));
        result_.in_band = judged.in_band;
        result_.distance = beyond(judged.error);
        if (result_.apart) witness(answer);
        if (depth && !result_.apart) penetration(answer, *depth);
    }

    void witness(const bench::NamedAnswer& answer) {
        const double between = norm(Vec3d(answer.distance.point_a - answer.distance.point_b));
        // World coordinates far from the origin hold no finer difference.
        const double coarse = 4 * Tolerance<double>::eps *
                              std::max(max_abs(answer.distance.point_a), max_abs(answer.distance.point_b));
        const double error = std::max(0.0, std::abs(between - answer.distance.distance) - coarse);
        if (!(error <= allowed(verified_error_double)))
            complain(fmt::format("witness points {} apart, distance {}", between, answer.distance.distance));
        result_.witness = beyond(error);
    }

    void penetration(const bench::NamedAnswer& answer, double depth) {
        const double error = std::abs(answer.depth - depth);
        if (!(error <= allowed(verified_depth_error_double)))
            complain(fmt::format("depth {} instead of {}", answer.depth, depth));
        if (depth > band_.band && answer.distance.status != Status::overlapping)
            complain(fmt::format("touching at depth {}", depth));
        result_.depth = beyond(error);
    }

    void certificates(const bench::NamedAnswer& answer) {
        const std::vector<Vec3d>&a = given_.a.vertices, &b = given_.b.vertices;
        const auto known = bench::certificates_of(answer, query_, bodies_, runner_.stored_bodies(), a, b);
        if (!known) return complain("no certificate: " + known.error);
        const auto given = truth::exact_distance(a, query_.pose_a, b, query_.pose_b);
        if (!(known->stored.lower <= exact_.distance && exact_.distance <= known->stored.upper))
            complain("the certificate of the stored bodies misses the exact distance");
        const double most = allowed(verified_error_double);
        if (const auto why = bench::contradiction(answer.distance.distance, known->stored, most, most);
            !why.empty())
            complain(why);
        if (!(known->given.lower <= given->distance && given->distance <= known->given.upper))
            complain("the certificate of the given bodies misses the exact distance");
    }

    bench::Runner& runner_;
    const scene::Case& given_;
    const scene::Query& query_;
    std::span<const Polyhedron> bodies_;
    bool single_;
    JudgedCase& result_;
    truth::ExactDistance exact_;
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
