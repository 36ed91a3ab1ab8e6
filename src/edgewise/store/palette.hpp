// SPDX-License-Identifier: MIT
//
// The colours of everything that is drawn, by name: a component or a layout has one colour in every picture.
#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

namespace edgewise::store {

struct NamedColour {
    std::string_view name, colour;
};

/// Components of tables. People with every kind of colour vision can distinguish them (Okabe and Ito, 2008);
/// padding is grey.
inline constexpr NamedColour component_colours[] = {
    {"voronoi_planes", "#0072b2"}, {"edge_geometry", "#56b4e9"}, {"vertex_coordinates", "#e69f00"},
    {"face_planes", "#cc79a7"},    {"topology", "#009e73"},      {"input_order", "#d55e00"},
    {"padding", "#d9d9d9"}};
/// Colours of a store's components that are not in the list.
inline constexpr std::string_view further_component_colours[] = {"#a0522d", "#f0e442", "#2e4057", "#8d6a9f"};

/// Layouts. People with every kind of colour vision can distinguish them (CIELAB distances of 12 and more,
/// also as seen with deuteranopia and protanopia); contrast at least 3:1 on a white and a dark page. A test
/// checks both.
inline constexpr NamedColour layout_colours[] = {{"aos", "#3366bb"},
                                                 {"lean", "#bb8800"},
                                                 {"soa", "#7733ff"},
                                                 {"linked", "#6699aa"},
                                                 {"points_soa", "#995544"},
                                                 {"quantised", "#ff3388"},
                                                 {"hot_cold", "#2277ff"},
                                                 {"shared_plane", "#aa5500"},
                                                 {"lazy", "#666666"},
                                                 {"aosoa", "#2299cc"},
                                                 {"aos_padded", "#7788ee"},
                                                 {"ring", "#9966aa"},
                                                 {"ring_block", "#888888"},
                                                 {"lean_seeds", "#cc7733"},
                                                 {"quantised_outward", "#bb2288"},
                                                 {"points_neighbours", "#bb7766"},
                                                 {"jitter2", "#cc1166"},
                                                 {"bepu", "#9933dd"},
                                                 {"line_per_vertex", "#996633"},
                                                 {"soa_stagger", "#bb8855"}};

/// Colour of a component. `place`: that of an unknown component among the unknown ones.
[[nodiscard]] constexpr std::string_view component_colour(std::string_view name, std::size_t place = 0) {
    for (const NamedColour& known : component_colours)
        if (known.name == name) return known.colour;
    return further_component_colours[place % std::size(further_component_colours)];
}

/// Colour of a layout or a library: its own, or one of the list that depends on the name alone.
[[nodiscard]] constexpr std::string_view layout_colour(std::string_view name) {
    for (const NamedColour& known : layout_colours)
        if (known.name == name) return known.colour;
    std::size_t sum = 0;
    for (const char c : name) sum = 31 * sum + static_cast<unsigned char>(c);
    return layout_colours[sum % std::size(layout_colours)].colour;
}

}  // namespace edgewise::store
