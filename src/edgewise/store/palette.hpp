// SPDX-License-Identifier: MIT
//
// The colours of everything that is drawn, by name: a component or a layout has one colour in every picture.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace edgewise::store {

struct NamedColour {
    std::string_view name, colour;
};

/// What bytes are for; told apart by people of every colour vision (Okabe and Ito, 2008), padding in grey.
inline constexpr std::array<NamedColour, 7> component_colours = {{{"voronoi_planes", "#0072b2"},
                                                                  {"edge_geometry", "#56b4e9"},
                                                                  {"vertex_coordinates", "#e69f00"},
                                                                  {"face_planes", "#cc79a7"},
                                                                  {"topology", "#009e73"},
                                                                  {"input_order", "#d55e00"},
                                                                  {"padding", "#d9d9d9"}}};
/// For components that the store names and this list does not.
inline constexpr std::array<std::string_view, 4> further_component_colours = {"#a0522d", "#f0e442", "#2e4057",
                                                                              "#8d6a9f"};

/// Layouts, in the order of the report's legends: ten plain colours and ten dark ones, all readable on white;
/// beyond twenty layouts they repeat.
inline constexpr std::array<std::string_view, 20> layout_colours = {
    "#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17becf", "#8c564b",
    "#e377c2", "#7f7f7f", "#a3a500", "#0b3c5d", "#8b1a1a", "#145a14", "#4b2e83",
    "#a65200", "#0b6e78", "#4a2c24", "#9b2f72", "#3f3f3f", "#6f7010"};

/// `place` is that of an unknown component among its like.
[[nodiscard]] constexpr std::string_view component_colour(std::string_view name, std::size_t place = 0) {
    for (const NamedColour& known : component_colours)
        if (known.name == name) return known.colour;
    return further_component_colours[place % further_component_colours.size()];
}

}  // namespace edgewise::store
