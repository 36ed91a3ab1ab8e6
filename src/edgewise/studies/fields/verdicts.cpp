// SPDX-License-Identifier: MIT
//
// Decides whether advice on fields held.
#include <algorithm>

#include "edgewise/measure/statistics.hpp"
#include "edgewise/studies/fields/fields.hpp"

namespace edgewise::studies {

using Role = FieldsContender::Role;

std::string_view to_string(FieldsContender::Role role) {
    constexpr std::string_view names[] = {"original", "own groups", "control", "advised", "beside"};
    return names[static_cast<int>(role)];
}

std::string_view to_string(Held held) {
    constexpr std::string_view names[] = {"held", "did not hold", "within the noise"};
    return names[static_cast<int>(held)];
}

const FieldsContender* FieldsAdvice::find(Role role) const {
    const auto found = std::find_if(contenders.begin(), contenders.end(),
                                    [&](const FieldsContender& contender) { return contender.role == role; });
    return found == contenders.end() ? nullptr : &*found;
}

std::optional<TimeRatio> FieldsAdvice::ratio(Role above, Role below) const {
    const FieldsContender *const a = find(above), *const b = find(below);
    if (!a || !b) return std::nullopt;
    const std::vector<double> ratios = measure::paired_ratios(a->ns, b->ns);
    const auto middle = measure::median(ratios);
    const auto interval = measure::bootstrap_median(ratios);
    if (!middle || !interval) return std::nullopt;
    return TimeRatio{interval->lower, *middle, interval->upper};
}

Role FieldsAdvice::baseline() const { return own ? Role::own_groups : Role::original; }

bool FieldsAdvice::all_right() const {
    return std::all_of(contenders.begin(), contenders.end(),
                       [](const FieldsContender& contender) { return contender.wrong.empty(); });
}

Held FieldsAdvice::lines_held() const {
    const FieldsContender *const built = find(Role::advised), *const before = find(Role::original);
    if (!built || !before) return Held::no;
    return built->cost.lines == predicted.lines && built->cost.lines < before->cost.lines ? Held::yes
                                                                                          : Held::no;
}

Held FieldsAdvice::time_held() const {
    const auto time = ratio(Role::advised, baseline()), noise = ratio(Role::control, baseline());
    if (!time || !noise) return Held::within_noise;
    if (time->high < std::min(1.0, noise->low)) return Held::yes;
    return time->low > std::max(1.0, noise->high) ? Held::no : Held::within_noise;
}

}  // namespace edgewise::studies
