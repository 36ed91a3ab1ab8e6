// SPDX-License-Identifier: MIT
//
// Checks that the colours of layouts differ visibly: CIELAB distances (CIE 1976) as seen with normal colour
// vision, and with deuteranopia and protanopia as Machado, Oliveira and Fernandes simulate them ("A
// Physiologically-based Model for Simulation of Color Vision Deficiency", 2009, severity 1). Also checks
// their contrast with the page, as WCAG defines it.
#include "edgewise/store/palette.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <tuple>

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
    for (std::size_t i = 0; i < layout_colours.size(); ++i) {
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

}  // namespace
}  // namespace edgewise::store
