// SPDX-License-Identifier: MIT
//
// Checks that the colours of layouts differ visibly: CIELAB distances (CIE 1976) as seen with normal colour
// vision, and with deuteranopia and protanopia as Machado, Oliveira and Fernandes simulate them ("A
// Physiologically-based Model for Simulation of Color Vision Deficiency", 2009, severity 1). Also checks
// their contrast with the page, as WCAG defines it.
//
// Names of figures: written, looked up and read back.
#include "edgewise/store/palette.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <tuple>

#include "edgewise/store/vocabulary.hpp"

namespace edgewise::store {
namespace {

using Colour = std::array<double, 3>;
using Matrix = std::array<Colour, 3>;

constexpr Matrix normal = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                 deuteranopia = {{{0.367322, 0.860646, -0.227968},
                                  {0.280085, 0.672501, 0.047413},
                                  {-0.011820, 0.042940, 0.968881}}},
                 protanopia = {{{0.152286, 1.052583, -0.204868},
                                {0.114503, 0.786281, 0.099216},
                                {-0.003882, -0.048116, 1.051998}}};

/// Linear light of "#rrggbb".
Colour linear(std::string_view hex) {
    Colour light{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = std::stoi(std::string(hex.substr(1 + 2 * i, 2)), nullptr, 16) / 255.0;
        light[i] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    }
    return light;
}

double dot(const Colour& a, const Colour& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Colour seen(const Matrix& with, const Colour& light) {
    Colour result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = std::clamp(dot(with[i], light), 0.0, 1.0);
    return result;
}

constexpr Colour luminance = {0.2126, 0.7152, 0.0722};

/// Under D65.
Colour lab(const Colour& light) {
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f(dot({0.4124, 0.3576, 0.1805}, light) / 0.95047), y = f(dot(luminance, light)),
                 z = f(dot({0.0193, 0.1192, 0.9505}, light) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double distance(const Matrix& with, std::string_view a, std::string_view b) {
    const Colour one = lab(seen(with, linear(a))), other = lab(seen(with, linear(b)));
    return std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}

double contrast(std::string_view a, std::string_view b) {
    const double one = dot(luminance, linear(a)) + 0.05, other = dot(luminance, linear(b)) + 0.05;
    return std::max(one, other) / std::min(one, other);
}

TEST(Palette, LayoutsAreToldApartByEveryEye) {
    double least = 1000;
    for (std::size_t i = 0; i < std::size(layout_colours); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const auto &a = layout_colours[i], &b = layout_colours[j];
            for (const auto& [name, eye] :
                 {std::pair("normal", normal), std::pair("deuteranopia", deuteranopia),
                  std::pair("protanopia", protanopia)}) {
                EXPECT_GE(distance(eye, a.colour, b.colour), 12) << a.name << ' ' << b.name << ' ' << name;
                least = std::min(least, distance(eye, a.colour, b.colour));
            }
        }
    }
    std::printf("least distance of two layouts' colours: %.1f\n", least);
}

TEST(Palette, LayoutsStandOutFromAWhiteAndADarkPage) {
    for (const NamedColour& layout : layout_colours) {
        EXPECT_GE(contrast(layout.colour, "#ffffff"), 3) << layout.name;
        EXPECT_GE(contrast(layout.colour, "#15181c"), 3) << layout.name;
    }
    EXPECT_NEAR(contrast("#ffffff", "#000000"), 21, 1e-9);
}

/// A layout of a user's own has a colour by its name alone.
TEST(Palette, ALayoutsColourDependsOnItsNameAlone) {
    EXPECT_EQ(layout_colour("aos"), "#3366bb");
    EXPECT_EQ(layout_colour("mine"), layout_colour("mine"));
    EXPECT_EQ(component_colour("topology"), "#009e73");
}

constexpr FigureName misses("caches.{machine}.{level}.misses_per_query");

TEST(Vocabulary, NamesEachFigureOnceWithAUnitAndAMeaning) {
    std::set<std::string_view> keys;
    for (const FigureInfo& info : vocabulary) {
        EXPECT_TRUE(keys.insert(info.key).second) << info.key;
        EXPECT_NE(info.key.find('.'), std::string_view::npos) << info.key;
        EXPECT_FALSE(info.unit.empty() || info.meaning.empty()) << info.key;
    }
    EXPECT_GT(keys.size(), 150U);
}

/// A figure that is made is found again, filled or not.
TEST(Vocabulary, FindsWhatItMakes) {
    for (const FigureInfo& info : vocabulary) {
        std::string name(info.name());
        for (std::size_t open; (open = name.find('{')) != std::string::npos;)
            name.replace(open, name.find('}') + 1 - open, "x1");
        EXPECT_EQ(find_figure(info.probe(), name), &info) << info.key;
    }
    EXPECT_EQ(find_figure("time", "al_ns"), nullptr);
    EXPECT_EQ(find_figure("caches", "all_ns"), nullptr);
    EXPECT_EQ(find_figure("caches", "zen5..misses_per_query"), nullptr);
}

TEST(Vocabulary, FillsBracesInOrder) {
    EXPECT_EQ(misses.of("zen5/random", "L1D").name(), "zen5/random.L1D.misses_per_query");
    EXPECT_EQ(misses.of("zen5").name(), "zen5.{level}.misses_per_query");
    const measure::Figure made = figure(misses.of("zen5", "L2"), 1.5);
    EXPECT_EQ(made.name, "zen5.L2.misses_per_query");
    EXPECT_EQ(made.unit, "misses");
    EXPECT_EQ(made.value, 1.5);
    const measure::Figure none = no_figure("time.all_ns", "why", "what to do");
    EXPECT_FALSE(none.value);
    EXPECT_EQ(none.reason, "why");
    EXPECT_EQ(none.remedy, "what to do");
}

TEST(Vocabulary, ReadsBackWhatFillsBraces) {
    const FigureName of_zen5 = misses.of("zen5");
    EXPECT_EQ(of_zen5.value_in("caches", "zen5.L2.misses_per_query"), "L2");
    EXPECT_EQ(of_zen5.value_in("reuse", "zen5.L2.misses_per_query"), std::nullopt);
    EXPECT_EQ(of_zen5.value_in("caches", "zen5.misses_per_query"), std::nullopt);
    EXPECT_EQ(of_zen5.value_in("caches", "zen4.L2.misses_per_query"), std::nullopt);
    EXPECT_EQ(of_zen5.value_in("caches", "zen5.L2.emptied_misses_per_query"), std::nullopt);
    EXPECT_EQ(of_zen5.value_in("caches", "zen5.L2.misses_per_query.warm"), std::nullopt);
    constexpr FigureName curve("reuse.line_misses_at_2^{power}");
    EXPECT_EQ(curve.value_in("reuse", "line_misses_at_2^10"), "10");
    EXPECT_EQ(curve.value_in("reuse", "line_misses_at_2^10.cold"), std::nullopt) << "another population";
    EXPECT_EQ(FigureName("reuse.page_misses_at_2^{power}").value_in("reuse", "page_misses_at_2^15"), "15");
}

}  // namespace
}  // namespace edgewise::store
