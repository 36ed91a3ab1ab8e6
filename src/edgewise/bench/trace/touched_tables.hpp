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

/// Of tables whose maps have the same offsets as the touched bytes; features as touched_features finds them.
[[nodiscard]] measure::TouchedTables touched_tables(std::span<const TableMap> maps,
                                                    const measure::TouchedBytes& touched);

/// Which features of a kind one table's scene touched, by their order in the layout: those of which any byte
/// was. Arrays of one element a feature tell it, side by side or several behind each other (x, y and z).
/// Nothing when the table has no bytes for the kind alone, or packs several features into one element.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> touched_features(const TableMap& map,
                                                                         const measure::TouchedBytes& touched,
                                                                         FeatureKind kind);

/// What an element's bytes of this component belong to; nothing: to no feature alone.
[[nodiscard]] std::optional<FeatureKind> kind_of(Component component);
[[nodiscard]] std::size_t features_of(const TableMap& map, FeatureKind kind);
/// The pieces that tell a table's features of a kind one from another: element i of such a piece is of
/// feature i mod n. None where no piece does.
[[nodiscard]] std::vector<const MappedPiece*> feature_pieces(const TableMap& map, FeatureKind kind);

}  // namespace edgewise::bench
