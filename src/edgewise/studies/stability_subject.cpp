// SPDX-License-Identifier: MIT
#include "edgewise/studies/stability_subject.hpp"

#include <fmt/format.h>

#include <cmath>

#include "edgewise/bench/certificates.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/studies/parts/allowed_errors.hpp"

namespace edgewise::studies {

namespace {

constexpr int timed_rounds = 5;

/// Signed gap over scale -> its bin: "0" near contact, else the lower edge, negative for overlaps.
std::string bin_of(double gap) {
    double edge = 0;
    for (const double e : stability_gaps) {
        if (std::abs(gap) >= e) edge = e;
    }
    return edge == 0 ? "0" : fmt::format("{}{:.0e}", gap < 0 ? "-" : "", edge);
}

bool holds(const truth::Certificate& known, const truth::ExactDistance& exact) {
    return known.lower <= exact.distance && exact.distance <= known.upper;
}

std::vector<std::string> all_bins() {
    std::vector<std::string> bins;
    for (std::size_t i = stability_gaps.size(); i-- > 0;) bins.push_back(bin_of(-stability_gaps[i]));
    bins.push_back("0");
    for (const double e : stability_gaps) bins.push_back(bin_of(e));
    return bins;
}

}  // namespace

scene::Workload StabilitySubject::workload_of(std::size_t index) const {
    const StabilityCase& given = cases_.all()[index];
    scene::Workload workload;
    workload.bodies = {given.a, given.b};
    workload.pair_count = 1;
    workload.warm = warm_;
    for (const auto& [pose_a, pose_b] : given.poses) workload.queries.push_back({0, 1, 0, pose_a, pose_b});
    return workload;
}

void StabilitySubject::run(StabilityTally& tally) {
    if (cases_.refused() > 0) tally.add_refusal(cases_.refused(), cases_.first_refusal());
    for (std::size_t i = 0; i < cases_.all().size(); ++i) ask(i, tally);
    time(tally);
}

void StabilitySubject::ask(std::size_t index, StabilityTally& tally) {
    const scene::Workload workload = workload_of(index);
    const std::string error = runner_->load(workload);
    if (!error.empty()) return tally.add_refusal(workload.queries.size(), error);
    const auto answers = runner_->answer();
    for (std::size_t pose = 0; pose < answers.size(); ++pose) {
        judge_pose({index, pose}, answers[pose], tally);
        if (proven_ < proofs_) prove_pose({index, pose}, tally);
    }
}

truth::AccuracyBand StabilitySubject::band_of(const Pose& pose_a, const Pose& pose_b) const {
    const auto stored = runner_->stored_bodies();
    return truth::accuracy_band(stored[0].vertices, pose_a, stored[1].vertices, pose_b, type_.eps);
}

void StabilitySubject::judge_pose(StabilityPose at, const Distance& answer, StabilityTally& tally) {
    const auto stored = runner_->stored_bodies();
    const auto& [pose_a, pose_b] = cases_.all()[at.index].poses[at.pose];
    const truth::ExactDistance& exact = cases_.exact(at, stored);
    const truth::AccuracyBand band = band_of(pose_a, pose_b);
    const bool separated = answer.status == Status::separated;
    std::optional<double> depth;
    if (separated && exact.verdict != truth::ExactVerdict::separated) depth = cases_.depth(at, stored);
    tally.add({truth::judge({separated, answer.distance}, exact, band, depth), band, answer, &exact,
               cases_.control(at, stored)});
}

void StabilitySubject::prove_pose(StabilityPose at, StabilityTally& tally) {
    ++proven_;
    const StabilityCase& given = cases_.all()[at.index];
    const auto& [pose_a, pose_b] = given.poses[at.pose];
    const auto stored = runner_->stored_bodies();
    const scene::Query query{0, 1, 0, pose_a, pose_b};
    const bench::NamedAnswer answer = runner_->answer(query);
    const std::vector<Polyhedron> bodies = {given.a, given.b};
    const auto certificates = bench::certificates_of(answer, query, bodies, stored);
    const truth::ExactDistance& exact = cases_.exact(at, stored);
    const truth::AccuracyBand band = band_of(pose_a, pose_b);
    StabilityProof proof;
    proof.certificate_missed = true;
    proof.depth_cut_short = answer.depth_cut_short;
    if (certificates) {
        const auto of_given = truth::exact_distance(given.a.vertices, pose_a, given.b.vertices, pose_b);
        proof.certificate_width = certificates->stored.width() / (band.scale > 0 ? band.scale : 1);
        const double allowed = allowed_errors(type_, algorithm_).distance * band.scale + band.band;
        proof.certificate_missed =
            !holds(certificates->stored, exact) || !of_given || !holds(certificates->given, *of_given) ||
            !bench::contradiction(answer.distance.distance, certificates->stored, allowed, allowed).empty();
    }
    if (exact.verdict != truth::ExactVerdict::separated && answer.distance.status != Status::separated)
        proof.depth_error = error_beyond(std::abs(answer.depth - cases_.depth(at, stored)), band);
    tally.add(proof);
}

/// The queries of the first cases, by gap; one workload each.
std::map<std::string, scene::Workload> StabilitySubject::by_gap() {
    std::map<std::string, scene::Workload> bins;
    std::size_t taken = 0;
    for (std::size_t i = 0; i < cases_.all().size() && taken < proofs_; ++i) {
        const scene::Workload one = workload_of(i);
        if (!runner_->load(one.bodies).empty()) continue;
        const auto stored = runner_->stored_bodies();
        std::map<std::string, std::uint32_t> first;  // of the case's bodies in a bin
        for (std::size_t pose = 0; pose < one.queries.size() && taken < proofs_; ++pose, ++taken) {
            const truth::ExactDistance& exact = cases_.exact({i, pose}, stored);
            const auto& query = one.queries[pose];
            const double scale = band_of(query.pose_a, query.pose_b).scale;
            const bool separated = exact.verdict == truth::ExactVerdict::separated;
            const double gap = separated ? exact.distance : -cases_.depth({i, pose}, stored);
            const std::string bin = bin_of(gap / (scale > 0 ? scale : 1));
            auto& bodies = bins[bin].bodies;
            const auto [place, is_new] = first.try_emplace(bin, static_cast<std::uint32_t>(bodies.size()));
            if (is_new) bodies.insert(bodies.end(), one.bodies.begin(), one.bodies.end());
            bins[bin].queries.push_back({place->second, place->second + 1, 0, query.pose_a, query.pose_b});
        }
    }
    return bins;
}

/// Cold queries of the first cases, gap by gap.
void StabilitySubject::time(StabilityTally& tally) {
    const std::map<std::string, scene::Workload> bins = by_gap();
    const double clock = measure::calibrate();
    const char* none = proofs_ == 0 ? "not asked for" : "no case of this family has such a gap";
    for (const std::string& bin : all_bins()) {
        std::vector<double> ns;
        if (const auto found = bins.find(bin); found != bins.end() && runner_->load(found->second).empty()) {
            const std::vector<std::uint8_t> one_class(found->second.queries.size(), 0);
            for (int round = 0; round < timed_rounds; ++round)
                ns.push_back(runner_->time(one_class, clock).separated_ns /
                             static_cast<double>(one_class.size()));
        }
        tally.add_time(bin, measure::median(ns), none);
    }
}

}  // namespace edgewise::studies
