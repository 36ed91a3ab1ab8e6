// SPDX-License-Identifier: MIT
#include "edgewise/studies/stability/stability.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "edgewise/measure/statistics.hpp"

namespace edgewise::studies {

namespace {

measure::Figure at_quantile(const store::FigureName& name, const std::vector<double>& sample, double p,
                            const std::string& none) {
    const auto value = measure::quantile(sample, p);
    return store::figure(name, value, sample.empty() ? none : "an error is not a number");
}

}  // namespace

StabilityTally::StabilityTally() {
    for (const store::FigureInfo& info : store::vocabulary) {
        const bool counts = info.unit == "queries" || info.unit == "escapes";
        if (info.probe() == "stability" && counts && info.key.find('{') == info.key.npos) counts_[&info] = 0;
    }
}

void StabilityTally::note(const char* what, const StabilityAnswer& asked) {
    if (!first_wrong_.empty()) return;
    first_wrong_ = fmt::format("case {}: {}, {} at {:.6g}, exact {:.6g}, scale {:.3g}",
                               counted("stability.cases") - 1, what, to_string(asked.answer.status),
                               asked.answer.distance, asked.exact_distance, asked.checked.band.scale);
}

void StabilityTally::add(const StabilityAnswer& asked) {
    const truth::CheckedAnswer& checked = asked.checked;
    const bool separated = checked.exact == truth::ExactVerdict::separated;
    count("stability.separated") += separated;
    count("stability.touching") += checked.exact == truth::ExactVerdict::touching;
    count("stability.overlapping") += checked.exact == truth::ExactVerdict::overlapping;
    const bool disagrees = (asked.answer.status == Status::separated) != separated;
    count("stability.in_band") += checked.in_band;
    compare_with_control(asked);
    count("stability.wrong_outside_band") += checked.verdict_wrong;
    count("stability.wrong_inside_band") += disagrees && !checked.verdict_wrong;
    errors_.push_back(checked.band.beyond(checked.error));
    witness_errors_.push_back(checked.band.beyond(checked.witness_error));
    count("stability.errors_beyond") += checked.distance_wrong;
    count("stability.wrong_answers") += checked.wrong();
    count_answer(asked.answer);
    if (checked.verdict_wrong) note("wrong verdict", asked);
    if (checked.distance_wrong) note("wrong distance", asked);
    for (std::size_t i = 0; i < failures_.size(); ++i) {
        const bool contact = asked.answer.distance <= stability_tolerances[i] * checked.band.scale;
        failures_[i] += contact == separated;
    }
}

void StabilityTally::count_answer(const Distance& answer) {
    ++count("stability.cases");
    count("stability.cycles") += static_cast<std::uint64_t>(answer.cycles);
    count("stability.fallbacks") += static_cast<std::uint64_t>(answer.fallbacks);
    count("stability.refinements") += static_cast<std::uint64_t>(answer.refinements);
    count("stability.escapes") += static_cast<std::uint64_t>(answer.escapes);
    steps_ += static_cast<std::uint64_t>(answer.steps);
    max_steps_ = std::max(max_steps_, answer.steps);
}

/// Updates the paper's robustness metric, and compares the control with the exact answer too.
void StabilityTally::compare_with_control(const StabilityAnswer& asked) {
    const truth::CheckedAnswer& checked = asked.checked;
    if (!checked.control_disagrees) return;
    const bool disagrees = *checked.control_disagrees;
    const bool control = disagrees == (asked.answer.status == Status::separated);  // in contact?
    const bool separated = checked.exact == truth::ExactVerdict::separated;
    ++count("stability.control_asked");
    count("stability.control_disagrees") += disagrees;
    count("stability.control_disagrees_outside_band") += disagrees && !checked.in_band;
    count("stability.control_wrong") += control == separated && !checked.in_band;
}

void StabilityTally::add(const StabilityProof& proof) {
    ++count("stability.certificates");
    depth_errors_.push_back(proof.depth_error);
    widths_.push_back(proof.certificate_width);
    count("stability.depths_beyond") += proof.depth_wrong;
    count("stability.certificates_missed") += proof.certificate_missed;
    count("stability.cap_hits") += proof.depth_cut_short;
}

void StabilityTally::add_refusal(std::size_t poses, const std::string& reason) {
    count("stability.refused") += poses;
    if (first_refusal_.empty()) first_refusal_ = reason;
}

void StabilityTally::add_time(const std::string& bin, std::optional<double> ns, const std::string& none) {
    times_.push_back(store::figure(store::FigureName("stability.ns_at_{gap}").of(bin), ns, none));
}

std::vector<measure::Figure> StabilityTally::figures() const {
    const std::uint64_t asked = counted("stability.cases");
    const std::string none = asked > 0 ? "not asked for" : "every case was refused: " + first_refusal_;
    std::vector<measure::Figure> result = {
        at_quantile("stability.worst_error", errors_, 1, none),
        at_quantile("stability.p999_error", errors_, 0.999, none),
        at_quantile("stability.worst_witness_error", witness_errors_, 1, none),
        at_quantile("stability.worst_depth_error", depth_errors_, 1, none),
        at_quantile("stability.worst_certificate_width", widths_, 1, none),
        store::mean_figure("stability.mean_steps", steps_, std::max<std::uint64_t>(asked, 1)),
        store::figure("stability.max_steps", max_steps_)};
    for (const auto& [info, number] : counts_)
        result.push_back({std::string(info->name()), static_cast<double>(number), std::string(info->unit)});
    for (std::size_t i = 0; i < failures_.size(); ++i) {
        result.push_back(store::figure(store::FigureName("stability.failures_at_{tolerance}")
                                           .of(fmt::format("{:.0e}", stability_tolerances[i])),
                                       failures_[i]));
    }
    result.insert(result.end(), times_.begin(), times_.end());
    return result;
}

std::string StabilityTally::what_is_wrong() const {
    if (counted("stability.cases") == 0) return "no case was answered; first refusal: " + first_refusal_;
    const std::uint64_t verdicts = counted("stability.wrong_outside_band"),
                        distances = counted("stability.errors_beyond"),
                        depths = counted("stability.depths_beyond"),
                        certificates = counted("stability.certificates_missed");
    if (verdicts + distances + depths + certificates == 0) return {};
    return fmt::format(
        "{} of {} verdicts and {} distances are wrong; of {} proven answers {} depths are wrong and {} "
        "certificates miss{}",
        verdicts, counted("stability.cases"), distances, counted("stability.certificates"), depths,
        certificates, first_wrong_.empty() ? "" : "; first: " + first_wrong_);
}

}  // namespace edgewise::studies
