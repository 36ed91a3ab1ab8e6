// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/finals.hpp"

#include <algorithm>

namespace edgewise::studies::advise {

namespace {

/// Of misses level by level, what the levels that answer them take.
double waiting_ns(const std::vector<double>& misses, std::span<const double> latencies_ns) {
    double sum = 0;
    for (std::size_t level = 0; level < misses.size(); ++level) {
        const bool last = level + 1 == misses.size();
        const double deeper = last ? 0 : misses[level + 1];
        sum += (misses[level] - deeper) *
               (last ? latencies_ns.back() : latencies_ns[std::min(level, latencies_ns.size() - 1)]);
    }
    return sum;
}

/// Ratios as divided by the baseline's median, which then is 1.
void set_noise(Finals& finals) {
    const Finalist* const baseline = finals.baseline();
    if (!baseline) return;
    const double mid = baseline->mid();
    finals.noise_low = baseline->low() / mid;
    finals.noise_high = baseline->high() / mid;
    for (auto* finalists : {&finals.ranked, &finals.over_limit})
        for (Finalist& finalist : *finalists)
            for (double& ratio : finalist.ratios) ratio /= mid;
}

}  // namespace

const Finalist* Finals::find(const std::string& algorithm, const std::string& table) const {
    for (const auto* finalists : {&ranked, &over_limit})
        for (const Finalist& one : *finalists)
            if (one.is(algorithm, table)) return &one;
    return nullptr;
}

bool Finals::ties(const Finalist& one) const {
    const Finalist& fastest = ranked.front();
    const double noise = std::max(noise_high, 1 / noise_low);
    return one.low() <= fastest.high() || one.mid() <= fastest.mid() * noise;
}

const Finalist* Finals::fastest_predicted(const std::string& machine) const {
    const Finalist* fastest = nullptr;
    for (const Finalist& one : ranked) {
        const auto predicted = one.predicted_ns.find(machine);
        if (predicted == one.predicted_ns.end()) continue;
        if (!fastest || predicted->second < fastest->predicted_ns.at(machine)) fastest = &one;
    }
    return fastest;
}

std::optional<bool> Finals::prediction_held() const {
    const Finalist* const fastest = fastest_predicted(this_machine);
    return fastest ? std::optional(ties(*fastest)) : std::nullopt;
}

Finals ranked_finals(std::vector<Finalist> finalists, double error_limit) {
    Finals finals;
    for (Finalist& finalist : finalists) {
        if (finalist.ratios.empty()) continue;
        (finalist.error <= error_limit ? finals.ranked : finals.over_limit).push_back(std::move(finalist));
    }
    set_noise(finals);
    std::ranges::stable_sort(finals.ranked, {}, &Finalist::mid);
    return finals;
}

void predict(Finals& finals, std::span<const double> latencies_ns) {
    finals.latencies_ns.assign(latencies_ns.begin(), latencies_ns.end());
    if (latencies_ns.empty()) return;
    for (Finalist& finalist : finals.ranked) {
        if (!finalist.in_cache_ns) continue;
        for (const auto& [machine, misses] : finalist.misses)
            finalist.predicted_ns[machine] = *finalist.in_cache_ns + waiting_ns(misses, latencies_ns);
    }
}

}  // namespace edgewise::studies::advise
