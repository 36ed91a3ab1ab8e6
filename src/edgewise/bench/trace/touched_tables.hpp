// SPDX-License-Identifier: MIT
//
// What a scene ever touched of its tables' memory, by component and by kind of feature: what it needs,
// against what was modelled.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/geometry/feature.hpp"
#include "edgewise/measure/cache/heat_map.hpp"
#include "edgewise/measure/cache/scene_caches.hpp"

namespace edgewise::bench {

/// Touched tables, by maps with the same offsets as the touched bytes; features as in touched_features.
[[nodiscard]] measure::TouchedTables touched_tables(std::span<const TableMap> maps,
                                                    const measure::TouchedBytes& touched);

/// Features of a kind that one table's scene touched in any byte, by order in the layout. Arrays of one
/// element a feature show it, side by side or several behind each other (x, y and z). Nothing when the table
/// has no bytes for the kind alone, or packs several features into one element.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> touched_features(const TableMap& map,
                                                                         const measure::TouchedBytes& touched,
                                                                         FeatureKind kind);

/// Kind of feature that an element's bytes of this component belong to; nothing if there is no single one.
[[nodiscard]] std::optional<FeatureKind> kind_of(Component component);
[[nodiscard]] std::size_t features_of(const TableMap& map, FeatureKind kind);
/// The pieces that identify a table's features of a kind: element i of a piece belongs to feature i mod n.
/// Empty where no piece does.
[[nodiscard]] std::vector<const MappedPiece*> feature_pieces(const TableMap& map, FeatureKind kind);

}  // namespace edgewise::bench
