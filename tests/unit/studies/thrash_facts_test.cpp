// SPDX-License-Identifier: MIT
//
// The four facts of figure 8: each fails by itself, at both ends where it has two.
#include <gtest/gtest.h>

#include "edgewise/studies/thrash/figure_8_facts.hpp"

namespace edgewise::studies::thrash {
namespace {

SpeedCurve flat(double ns) {
    SpeedCurve curve;
    curve.fill(ns);
    return curve;
}

/// As the paper draws it: V-Clip up and down under 1.2 ms, GJK at the bottom.
Figure8 papers_figure() {
    return {flat(7e4), flat(9e4), {9e5, 6e5, 1.1e6, 8e5, 1e6, 7e5, 1e6}, flat(7e4), flat(1e5), flat(1e5)};
}

std::array<bool, 4> all_but(Fact fact) {
    std::array<bool, 4> facts = {true, true, true, true};
    facts[static_cast<std::size_t>(fact)] = false;
    return facts;
}

TEST(Figure8Facts, HoldForThePapersFigure) {
    const FactScore found = score(papers_figure());
    EXPECT_EQ(found.count(), 4);
    EXPECT_EQ(found.mask(), 15U);
    EXPECT_NEAR(found.rise, 1.1e6 / 9e4, 1e-12);
    EXPECT_EQ(found.top_ns, 1.1e6);
    EXPECT_EQ(found.gjk_rise, 1);
    EXPECT_NEAR(found.gjk_rise_from_8, 1e5 / 7e4, 1e-12);
    EXPECT_NEAR(found.fall, 1.1e6 / 7e5, 1e-12);
}

TEST(Figure8Facts, FailAloneByTheRise) {
    for (const double small : {1.1e6 / 25, 1.1e6 / 5}) {
        Figure8 figure = papers_figure();
        figure.vclip_38 = flat(small);
        EXPECT_EQ(score(figure).holds, all_but(Fact::rises)) << small;
    }
}

TEST(Figure8Facts, FailAloneByTheTime) {
    for (const double factor : {0.5, 1.2}) {
        Figure8 figure = papers_figure();
        for (double& ns : figure.vclip_386) ns *= factor;
        for (double& ns : figure.vclip_38) ns *= factor;
        EXPECT_EQ(score(figure).holds, all_but(Fact::takes_as_long)) << factor;
    }
}

TEST(Figure8Facts, FailAloneByGjk) {
    for (const double ns : {2.1e5, 4.9e4}) {
        Figure8 figure = papers_figure();
        figure.gjk_386 = flat(ns);
        EXPECT_EQ(score(figure).holds, all_but(Fact::spares_gjk)) << ns;
    }
}

TEST(Figure8Facts, FailAloneWithoutUpsAndDowns) {
    Figure8 figure = papers_figure();
    figure.vclip_386 = {5e5, 6e5, 7e5, 8e5, 9e5, 1e6, 1.1e6};
    EXPECT_EQ(score(figure).holds, all_but(Fact::erratic));
    figure = papers_figure();
    figure.gjk_386 = {1e5, 7e4, 1e5, 1e5, 1e5, 1e5, 1e5};  // as erratic as V-Clip
    EXPECT_EQ(score(figure).holds, all_but(Fact::erratic));
}

TEST(Figure8Facts, FindTheLargestFallOverAnyDistance) {
    EXPECT_NEAR(largest_fall({1, 4, 3, 5, 2, 6, 7}), 2.5, 1e-12);
    EXPECT_LT(largest_fall({1, 2, 3, 4, 5, 6, 7}), 1);
}

}  // namespace
}  // namespace edgewise::studies::thrash
