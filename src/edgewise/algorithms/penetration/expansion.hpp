// SPDX-License-Identifier: MIT
//
// Sums of products of two or three differences of coordinates, without rounding. Shewchuk's grow-expansion
// ("Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997). Exact as long
// as no digit of a product leaves the range of double: see smallest_coordinate.
#pragma once

#include <cassert>

#include "edgewise/geometry/double_double.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise::epa {

/// A sum of doubles without rounding: terms that do not overlap, the smallest first.
class Expansion {
  public:
    void add(double value) {
        int kept = 0;
        for (int i = 0; i < count_; ++i) {
            const DoubleDouble sum = exact_sum(value, term_[i]);
            value = sum.high;
            if (sum.low != 0) term_[kept++] = sum.low;
        }
        assert(kept < determinant_terms);
        if (value != 0) term_[kept++] = value;
        count_ = kept;
    }

    void add_product(double a, double b, double c) {
        const DoubleDouble ab = exact_product(a, b);
        for (const double part : {ab.low, ab.high}) {
            if (part == 0) continue;
            const DoubleDouble abc = exact_product(part, c);
            add(abc.low);
            add(abc.high);
        }
    }

    void add_product(const DoubleDouble& a, const DoubleDouble& b) {
        for (const double x : {a.low, a.high}) {
            for (const double y : {b.low, b.high}) {
                const DoubleDouble xy = exact_product(x, y);
                add(xy.low);
                add(xy.high);
            }
        }
    }

    void add_product(const DoubleDouble& a, const DoubleDouble& b, const DoubleDouble& c) {
        for (const double x : {a.low, a.high}) {
            for (const double y : {b.low, b.high}) {
                for (const double z : {c.low, c.high}) {
                    if (x != 0 && y != 0 && z != 0) add_product(x, y, z);
                }
            }
        }
    }

    /// Value of the sum, to a rounding step or two.
    [[nodiscard]] double value() const {
        double sum = 0;
        for (int i = 0; i < count_; ++i) sum += term_[i];
        return sum;
    }

    /// Sign of the sum: that of its largest term.
    [[nodiscard]] int sign() const {
        return count_ == 0 ? 0 : (term_[count_ - 1] > 0) - (term_[count_ - 1] < 0);
    }

  private:
    static constexpr int determinant_terms = 6 * 8 * 4;  ///< products, choices of parts, parts of each

    SmallArray<double, determinant_terms> term_;
    int count_ = 0;
};

}  // namespace edgewise::epa
