// SPDX-License-Identifier: MIT
#include "edgewise/studies/judge/pair_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "edgewise/bench/certificates.hpp"
#include "edgewise/bench/peers/peer_modules.hpp"
#include "edgewise/geometry/hull/point_set.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/answer_claim.hpp"
#include "edgewise/studies/single_cell.hpp"
#include "edgewise/truth/exact_body.hpp"

namespace edgewise::studies {

namespace {

truth::PlacedBodies placed(const scene::Case& pair) {
    return {pair.a.vertices, pair.pose_a, pair.b.vertices, pair.pose_b};
}

/// Returns the allowed errors; for a library they include its own tolerance. Its depths are not asked for.
truth::AllowedErrors allowed_errors_of(const Respondent& respondent) {
    truth::AllowedErrors allowed = allowed_errors(*respondent.type, respondent.algorithm);
    if (respondent.type->is_peer) allowed.distance = std::max(allowed.distance, judged_error_peer);
    return allowed;
}

/// Fills in whether the answer is right: verdict, then distance, then depth; within the errors and the band.
void judge(JudgedResponse& response, bool separated, const truth::PlacedBodies& bodies,
           truth::KnownPair& known, const truth::AccuracyBand& band, const truth::AllowedErrors& relative) {
    const truth::Claim claim{
        .separated = separated, .distance = response.distance.value_or(0), .depth = response.depth};
    const truth::CheckedAnswer checked = truth::check(claim, bodies, known, band, relative);
    const truth::ExactDistance& exact = known.exact(bodies);
    const auto allowed = [&](double error) { return error * band.scale + band.band; };
    if (response.distance) response.error = checked.error;
    const bool truly_separated = exact.verdict == truth::ExactVerdict::separated;
    if (checked.verdict_wrong) {
        response.is = AnswerIs::wrong_verdict;
        response.beyond = std::max(checked.error, truly_separated ? 0 : known.depth(bodies)) - band.band;
        response.why = fmt::format("says {}, is {}", response.status, to_string(exact.verdict));
    } else if (response.distance && checked.distance_wrong) {
        response.is = AnswerIs::wrong_distance;
        response.beyond = checked.error - allowed(relative.distance);
        response.why = fmt::format("distance {} instead of {}", *response.distance, exact.distance);
    } else if (separated != truly_separated) {
        response.is = AnswerIs::in_band;
        response.why = "another verdict, where rounding decides";
    } else if (!separated && response.depth) {
        response.error = checked.depth_error;
        if (!checked.depth_wrong) return;
        response.is = AnswerIs::wrong_depth;
        response.beyond = response.error - allowed(relative.depth);
        response.why = fmt::format("depth {} instead of {}", *response.depth, known.depth(bodies));
    }
}

std::vector<Polyhedron> bodies_of(const scene::Case& pair) {
    return {scene::body_from_case(pair.a).or_throw(), scene::body_from_case(pair.b).or_throw()};
}

/// Adds the certificate of V-Clip in double on the first table type that stores bodies exactly.
void add_certificate(const scene::Case& pair, PairTruth& truth) {
    const auto is_exact = [](const bench::TableType& type) {
        return type.serves("vclip") && type.storage == "double" && !type.single_storage;
    };
    const auto type = std::ranges::find_if(bench::table_types(), is_exact);
    truth.no_certificate = "this program has no table type that stores doubles";
    if (type == bench::table_types().end()) return;
    const std::vector<Polyhedron> bodies = bodies_of(pair);
    const auto runner = type->make_runner("vclip");
    truth.no_certificate = runner->load(bodies);
    if (!truth.no_certificate.empty()) return;
    const scene::Query query{0, 1, 0, pair.pose_a, pair.pose_b};
    const auto known = bench::certificates_of(runner->answer(query), query, bodies, runner->stored_bodies(),
                                              pair.a.vertices, pair.b.vertices);
    if (known) truth.certificate = known->given;
    truth.no_certificate = known.error;
}

}  // namespace

std::string_view to_string(AnswerIs answer) {
    constexpr std::string_view names[] = {"right",       "in the band", "wrong verdict", "wrong distance",
                                          "wrong depth", "no answer",   "refused"};
    return names[static_cast<std::size_t>(answer)];
}

std::string Respondent::name() const {
    if (type->is_peer) return type->name;
    return contender_name(algorithm, type->name);
}

Result<PairTruth> exact_truth_of(const scene::Case& pair) {
    for (const scene::CaseBody* body : {&pair.a, &pair.b}) {
        if (const auto made = scene::body_from_case(*body); !made)
            return Result<PairTruth>::failure(made.error);
    }
    const truth::PlacedBodies bodies = placed(pair);
    if (std::string error = truth::pair_error(bodies.a, pair.pose_a, bodies.b, pair.pose_b); !error.empty())
        return Result<PairTruth>::failure(std::move(error));
    truth::KnownPair known;
    PairTruth truth;
    truth.exact = known.exact(bodies);
    truth.band = bodies.band(Tolerance<double>::eps);
    if (truth.exact.verdict != truth::ExactVerdict::separated) truth.depth = known.depth(bodies);
    return Result<PairTruth>::success(std::move(truth));
}

Result<PairTruth> truth_of(const scene::Case& pair) {
    Result<PairTruth> truth = exact_truth_of(pair);
    if (truth) add_certificate(pair, *truth);
    return truth;
}

JudgedResponse ask(const Respondent& respondent, const scene::Case& pair, const PairTruth& truth) {
    JudgedResponse response;
    response.who = respondent.name();
    const bench::TableType& type = *respondent.type;
    const std::vector<Polyhedron> bodies = bodies_of(pair);
    const auto runner = type.make_runner(respondent.algorithm);
    if (const std::string error = runner->load(bodies); !error.empty()) {
        response.is = AnswerIs::refused;
        response.status = "failed";
        response.why = error;
        return response;
    }
    const scene::Query query{0, 1, 0, pair.pose_a, pair.pose_b};
    const bench::NamedAnswer answer = runner->answer(query);
    const Distance& d = answer.distance;
    response.status = to_string(d.status);
    if (d.status == Status::failed) {
        const auto* library = dynamic_cast<const bench::PeerRunner*>(runner.get());
        const bool was_asked = library && library->asks(query);
        response.is = was_asked ? AnswerIs::no_answer : AnswerIs::refused;
        response.why =
            was_asked ? "gave no answer" : "too large, too small or too far apart for this precision";
        return response;
    }
    const bool separated = d.status == Status::separated;
    if (!type.verdict_only) response.distance = d.distance;
    if (!separated && !type.is_peer) response.depth = answer.depth;
    const truth::PlacedBodies held = scene::placed(runner->stored_bodies(), query);
    truth::KnownPair known;
    judge(response, separated, held, known, held.band(type.eps), allowed_errors_of(respondent));
    response.of_given = truth::distance_error({.separated = separated, .distance = d.distance}, truth.exact);
    if (response.is == AnswerIs::right &&
        separated != (truth.exact.verdict == truth::ExactVerdict::separated))
        response.why = "of the bodies as it rounds them";
    return response;
}

JudgedResponse judge_reported(const scene::ReportedAnswer& reported, const scene::Case& pair,
                              const PairTruth& truth) {
    JudgedResponse response;
    response.who = reported.who;
    response.distance = reported.distance;
    if (!reported.distance) {
        response.is = AnswerIs::no_answer;
        response.status = "failed";
        response.why = reported.what;
        return response;
    }
    const bool separated = *reported.distance > 0;
    response.status = separated ? "separated" : "touching";
    if (*reported.distance < 0) {  // a signed distance: its size is a depth
        response.depth = -*reported.distance;
        response.distance = 0;
    }
    truth::KnownPair known(truth.exact, truth.depth);
    judge(response, separated, placed(pair), known, truth.band, {judged_error_peer, judged_error_peer});
    response.of_given = response.error;
    return response;
}

std::vector<JudgedResponse> ask_all(std::span<const Respondent> respondents, const scene::Case& pair,
                                    const PairTruth& truth) {
    std::vector<JudgedResponse> answers;
    std::map<std::string, std::size_t> places;  // of the first answers, by algorithm and answer
    for (const Respondent& respondent : respondents) {
        JudgedResponse response = ask(respondent, pair, truth);
        const std::string key =
            fmt::format("{} {} {} {} {} {}", respondent.type->is_peer ? response.who : respondent.algorithm,
                        response.status, response.distance.value_or(-1), response.depth.value_or(-1),
                        response.error, to_string(response.is));
        const auto [place, is_new] = places.try_emplace(key, answers.size());
        if (is_new) {
            answers.push_back(std::move(response));
        } else {
            answers[place->second].same.push_back(respondent.type->name);
        }
    }
    return answers;
}

std::vector<Respondent> respondents_of(std::span<const bench::TableType* const> types,
                                       std::span<const std::string> algorithms,
                                       std::span<const bench::TableType* const> peers) {
    std::vector<Respondent> all;
    for (const std::string& algorithm : algorithms) {
        for (const bench::TableType* type : types) {
            if (type->serves(algorithm)) all.push_back({type, algorithm});
        }
    }
    for (const bench::TableType* peer : peers) all.push_back({peer, peer->algorithms.front()});
    return all;
}

namespace {

constexpr double least_part = 0.1;         ///< of the error over scale that was there first
constexpr std::size_t most_work = 200000;  ///< tries x vertices: some seconds

bool is_solid(const scene::CaseBody& body) {
    return flatness_error(body.vertices, distinct_points(body.vertices)).empty();
}

double over_scale(const JudgedResponse& answer, const PairTruth& truth) {
    return truth.band.scale > 0 ? answer.beyond / truth.band.scale : 0;
}

}  // namespace

std::optional<SmallerPair> smaller_pair(const Respondent& respondent, const scene::Case& pair) {
    const auto given = exact_truth_of(pair);
    if (!given) return std::nullopt;
    const JudgedResponse first = ask(respondent, pair, *given);
    if (!first.wrong()) return std::nullopt;
    const bool solid_a = is_solid(pair.a), solid_b = is_solid(pair.b);
    const auto still_fails = [&](const scene::Case& candidate) {
        if (is_solid(candidate.a) != solid_a || is_solid(candidate.b) != solid_b) return false;
        const auto truth = exact_truth_of(candidate);
        if (!truth) return false;
        const JudgedResponse answer = ask(respondent, candidate, *truth);
        return answer.is == first.is && over_scale(answer, *truth) >= least_part * over_scale(first, *given);
    };
    const std::size_t vertices = pair.a.vertices.size() + pair.b.vertices.size();
    SmallerPair result;
    result.found = scene::minimise(pair, still_fails, std::max<std::size_t>(200, most_work / vertices));
    result.truth = *truth_of(result.found.pair);
    result.answer = ask(respondent, result.found.pair, result.truth);
    return result;
}

}  // namespace edgewise::studies
