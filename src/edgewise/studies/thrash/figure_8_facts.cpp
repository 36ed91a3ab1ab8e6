// SPDX-License-Identifier: MIT
#include "edgewise/studies/thrash/figure_8_facts.hpp"

#include <algorithm>

namespace edgewise::studies::thrash {

namespace {

double longest(const SpeedCurve& curve) { return *std::max_element(curve.begin(), curve.end()); }

}  // namespace

double largest_fall(const SpeedCurve& curve) {
    double fall = 0;
    for (std::size_t slow = 0; slow < curve.size(); ++slow)
        for (std::size_t fast = slow + 1; fast < curve.size(); ++fast)
            fall = std::max(fall, curve[slow] / curve[fast]);
    return fall;
}

FactScore score(const Figure8& figure) {
    FactScore found;
    found.rise = longest(figure.vclip_386) / longest(figure.vclip_38);
    found.top_ns = longest(figure.vclip_386);
    found.gjk_rise = longest(figure.gjk_386) / longest(figure.gjk_38);
    found.gjk_rise_from_8 = longest(figure.gjk_386) / longest(figure.gjk_8);
    found.fall = largest_fall(figure.vclip_386);
    found.gjk_fall = largest_fall(figure.gjk_386);
    found.holds = {found.rise >= least_rise && found.rise <= most_rise,
                   found.top_ns >= least_top_ns && found.top_ns <= most_top_ns,
                   found.gjk_rise <= most_gjk_rise && found.gjk_rise >= 1 / most_gjk_rise,
                   found.fall >= least_fall && found.gjk_fall < least_fall};
    return found;
}

}  // namespace edgewise::studies::thrash
