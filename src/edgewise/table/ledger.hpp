// SPDX-License-Identifier: MIT
//
// Number of bytes of a table by purpose.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string_view>

namespace edgewise {

enum class Component : std::uint8_t {
    voronoi_planes,
    edge_geometry,  ///< direction and length
    vertex_coordinates,
    face_planes,
    topology,
    input_order,  ///< index of each vertex in the user's list
    padding,      ///< inside records and between arrays
};

inline constexpr std::array<std::string_view, 7> component_names = {
    "voronoi_planes", "edge_geometry", "vertex_coordinates", "face_planes", "topology",
    "input_order",    "padding"};

struct Ledger {
    std::array<std::size_t, component_names.size()> bytes{};

    [[nodiscard]] std::size_t& operator[](Component c) { return bytes[static_cast<std::size_t>(c)]; }
    [[nodiscard]] std::size_t operator[](Component c) const { return bytes[static_cast<std::size_t>(c)]; }

    /// Sum of all bytes of the table.
    [[nodiscard]] std::size_t total() const {
        return std::accumulate(bytes.begin(), bytes.end(), std::size_t{0});
    }

    /// The paper's subtotal: Voronoi planes, direction and length, vertex coordinates; 0 where no planes are
    /// stored.
    [[nodiscard]] std::size_t paper_subtotal() const {
        if ((*this)[Component::voronoi_planes] == 0) return 0;
        return (*this)[Component::voronoi_planes] + (*this)[Component::edge_geometry] +
               (*this)[Component::vertex_coordinates];
    }
};

}  // namespace edgewise
