// SPDX-License-Identifier: MIT
//
// Ends every run. V-Clip's next pair of features is a function of the present pair alone, so a pair seen
// twice proves a cycle. Brent's method ("An improved Monte Carlo factorization algorithm", 1980) finds it
// with one remembered pair, moved to the present at growing distances, and never calls a cycle where there is
// none.
#pragma once

namespace edgewise::vclip {

template <class FeatureA, class FeatureB>
class CycleGuard {
  public:
    CycleGuard(const FeatureA& a, const FeatureB& b) : a_(a), b_(b) {}

    /// True when this pair was the present one before.
    [[nodiscard]] bool returns_to(const FeatureA& a, const FeatureB& b) {
        if (a == a_ && b == b_) return true;
        if (++since_ == reach_) {
            a_ = a;
            b_ = b;
            since_ = 0;
            reach_ *= 2;
        }
        return false;
    }

  private:
    FeatureA a_;
    FeatureB b_;
    int since_ = 0;
    int reach_ = 4;
};

}  // namespace edgewise::vclip
