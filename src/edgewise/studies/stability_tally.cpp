// SPDX-License-Identifier: MIT
#include "edgewise/studies/stability_tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "edgewise/measure/statistics.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::studies {

namespace {

double witness_error(const StabilityJudgement& judged) {
    if (judged.answer.status != Status::separated) return 0;
    const double apart = norm(Vec3d(judged.answer.point_a - judged.answer.point_b));
    return error_beyond(std::abs(apart - judged.answer.distance), judged.band);
}

measure::Figure at_quantile(const store::FigureName& name, const std::vector<double>& sample, double p,
                            const std::string& none) {
    const auto value = measure::quantile(sample, p);
    return store::figure(name, value, value ? "" : sample.empty() ? none : "an error is not a number");
}

measure::Figure count(const store::FigureName& name, std::uint64_t n) {
    return store::figure(name, static_cast<double>(n));
}

measure::Figure worst(const store::FigureName& name, const std::vector<double>& sample,
                      const std::string& none) {
    return at_quantile(name, sample, 1, none);
}

}  // namespace

double error_beyond(double error, const truth::AccuracyBand& band) {
    const double beyond = error - band.band;
    return beyond <= 0 ? 0 : beyond / (band.scale > 0 ? band.scale : 1);
}

void StabilityTally::note(const char* what, const StabilityJudgement& judged) {
    if (!first_wrong_.empty()) return;
    first_wrong_ = fmt::format("case {}: {}, {} at {:.6g}, exact {:.6g}, scale {:.3g}", asked_ - 1, what,
                               to_string(judged.answer.status), judged.answer.distance,
                               judged.exact->distance, judged.band.scale);
}

void StabilityTally::add(const StabilityJudgement& judged) {
    ++asked_;
    const Distance& answer = judged.answer;
    const bool apart = judged.exact->verdict == truth::ExactVerdict::separated;
    separated_ += apart;
    touching_ += judged.exact->verdict == truth::ExactVerdict::touching;
    overlapping_ += judged.exact->verdict == truth::ExactVerdict::overlapping;
    const bool disagrees = (answer.status == Status::separated) != apart;
    const bool near = judged.judgement.in_band || (apart && judged.exact->distance <= judged.band.band);
    in_band_ += near;
    compare_with_control(judged, apart, near);
    wrong_outside_ += judged.judgement.verdict_wrong;
    wrong_inside_ += disagrees && !judged.judgement.verdict_wrong;
    errors_.push_back(error_beyond(judged.judgement.error, judged.band));
    witness_errors_.push_back(witness_error(judged));
    const bool beyond = !(errors_.back() <= error_allowed_) || !(witness_errors_.back() <= error_allowed_);
    beyond_ += beyond;
    if (judged.judgement.verdict_wrong) note("wrong verdict", judged);
    if (beyond) note("wrong distance", judged);
    for (std::size_t i = 0; i < failures_.size(); ++i) {
        const bool contact = answer.distance <= stability_tolerances[i] * judged.band.scale;
        failures_[i] += contact == apart;
    }
    steps_ += static_cast<std::uint64_t>(answer.steps);
    cycles_ += static_cast<std::uint64_t>(answer.cycles);
    fallbacks_ += static_cast<std::uint64_t>(answer.fallbacks);
    refinements_ += static_cast<std::uint64_t>(answer.refinements);
    escapes_ += static_cast<std::uint64_t>(answer.escapes);
    max_steps_ = std::max(max_steps_, answer.steps);
}

/// The paper's robustness metric, with the exact referee beside it.
void StabilityTally::compare_with_control(const StabilityJudgement& judged, bool apart, bool near) {
    if (!judged.control) return;
    ++control_asked_;
    const bool touching = judged.exact->verdict == truth::ExactVerdict::touching;
    const bool disagrees = *judged.control != (judged.answer.status != Status::separated);
    control_disagrees_ += disagrees;
    control_outside_ += disagrees && !near && !touching;
    control_wrong_ += *judged.control == apart && !near && !touching;
}

void StabilityTally::add(const StabilityProof& proof) {
    ++proofs_;
    depth_errors_.push_back(proof.depth_error);
    widths_.push_back(proof.certificate_width);
    depths_beyond_ += !(proof.depth_error <= depth_error_allowed_);
    missed_ += proof.certificate_missed;
    cap_hits_ += proof.depth_cut_short;
}

void StabilityTally::add_refusal(std::size_t poses, const std::string& reason) {
    refused_ += poses;
    if (first_refusal_.empty()) first_refusal_ = reason;
}

void StabilityTally::add_time(const std::string& bin, std::optional<double> ns) {
    times_.emplace_back(bin, ns);
}

std::vector<measure::Figure> StabilityTally::figures() const {
    const std::string none = asked_ > 0 ? "not asked for" : "every case was refused: " + first_refusal_;
    const double asked = static_cast<double>(std::max<std::size_t>(asked_, 1));
    std::vector<measure::Figure> result = {
        count("stability.cases", asked_),
        count("stability.refused", refused_),
        count("stability.separated", separated_),
        count("stability.touching", touching_),
        count("stability.overlapping", overlapping_),
        count("stability.in_band", in_band_),
        count("stability.wrong_outside_band", wrong_outside_),
        count("stability.wrong_inside_band", wrong_inside_),
        count("stability.errors_beyond", beyond_),
        worst("stability.worst_error", errors_, none),
        at_quantile("stability.p999_error", errors_, 0.999, none),
        worst("stability.worst_witness_error", witness_errors_, none),
        worst("stability.worst_depth_error", depth_errors_, none),
        count("stability.depths_beyond", depths_beyond_),
        count("stability.cap_hits", cap_hits_),
        worst("stability.worst_certificate_width", widths_, none),
        count("stability.certificates", proofs_),
        count("stability.certificates_missed", missed_),
        count("stability.control_asked", control_asked_),
        count("stability.control_disagrees", control_disagrees_),
        count("stability.control_disagrees_outside_band", control_outside_),
        count("stability.control_wrong", control_wrong_),
        store::figure("stability.escapes", static_cast<double>(escapes_)),
        count("stability.cycles", cycles_),
        count("stability.fallbacks", fallbacks_),
        count("stability.refinements", refinements_),
        store::figure("stability.mean_steps", static_cast<double>(steps_) / asked),
        store::figure("stability.max_steps", static_cast<double>(max_steps_))};
    add_curves(result);
    return result;
}

void StabilityTally::add_curves(std::vector<measure::Figure>& to) const {
    for (std::size_t i = 0; i < failures_.size(); ++i) {
        to.push_back(count(store::FigureName("stability.failures_at_{tolerance}")
                               .of(fmt::format("{:.0e}", stability_tolerances[i])),
                           failures_[i]));
    }
    for (const auto& [bin, ns] : times_) {
        to.push_back(store::figure(store::FigureName("stability.ns_at_{gap}").of(bin), ns,
                                   ns ? "" : "no case of this family has such a gap"));
    }
}

std::string StabilityTally::what_is_wrong() const {
    if (asked_ == 0) return "no case was answered; first refusal: " + first_refusal_;
    if (wrong_outside_ + beyond_ + depths_beyond_ + missed_ == 0) return {};
    return fmt::format(
        "{} of {} verdicts and {} distances are wrong; of {} proven answers {} depths are wrong and {} "
        "certificates "
        "miss{}",
        wrong_outside_, asked_, beyond_, proofs_, depths_beyond_, missed_,
        first_wrong_.empty() ? "" : "; first: " + first_wrong_);
}

}  // namespace edgewise::studies
