// SPDX-License-Identifier: MIT
//
// Which parts of its tables' memory a scene touched, by component and by kind of feature; and heat on the
// body itself: how often it reads the data that a table stores of each vertex, edge and face.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/geometry/feature.hpp"
#include "edgewise/measure/cache/heat_map.hpp"
#include "edgewise/measure/cache/scene_caches.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/table/pieces.hpp"

namespace edgewise::bench {

/// Touched tables, by maps with the same offsets as the touched bytes; features as in touched_features.
[[nodiscard]] measure::TouchedTables touched_tables(std::span<const TableMap> maps,
                                                    const measure::TouchedBytes& touched);

/// Returns the features of a kind with at least one touched byte, in the order of the layout. The arrays with
/// one element per feature (e.g. x, y and z) show which bytes are touched. Nothing if the table has no bytes
/// for the kind alone, or packs several features into one element.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> touched_features(const TableMap& map,
                                                                         const measure::TouchedBytes& touched,
                                                                         FeatureKind kind);

/// Finds the component of a byte of tables by its address.
class ComponentPlaces {
  public:
    explicit ComponentPlaces(std::span<const TableMap> maps);
    /// Returns the component's name; nothing if the byte lies in no piece of a table.
    [[nodiscard]] std::optional<std::string_view> at(std::uint64_t address) const;

  private:
    std::vector<MappedPiece> pieces_;  ///< by address
};

/// Counts the reads of each vertex, edge and face.
class FeatureHeat final : public measure::TraceListener {
  public:
    /// Takes maps of tables of one body, at the addresses that the trace reports.
    explicit FeatureHeat(std::span<const TableMap> maps);

    void on_access(const measure::TracedAccess& access) override;
    void on_query_end(bool /*counts*/) override { ++queries_; }

    [[nodiscard]] std::uint64_t queries() const { return queries_; }
    /// Reads of the features of a kind over all tables, in the order of the layout; nothing if the layout
    /// stores no bytes for them alone, or not one by one.
    [[nodiscard]] const std::optional<std::vector<std::uint32_t>>& reads(FeatureKind kind) const {
        return reads_[static_cast<std::size_t>(kind)];
    }

  private:
    /// A piece of a table, and the kinds of the features that it identifies.
    struct Stretch {
        std::uint64_t from = 0;
        const MappedPiece* piece = nullptr;
        std::array<bool, 3> tells = {};
    };

    std::vector<TableMap> maps_;
    std::vector<Stretch> stretches_;  ///< by address
    std::array<std::optional<std::vector<std::uint32_t>>, 3> reads_;
    std::uint64_t queries_ = 0;
};

}  // namespace edgewise::bench
