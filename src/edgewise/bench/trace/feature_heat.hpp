// SPDX-License-Identifier: MIT
//
// Heat on the body itself: how often a scene reads what a table stores of each vertex, edge and face.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/geometry/feature.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/table/pieces.hpp"

namespace edgewise::bench {

class FeatureHeat final : public measure::TraceListener {
  public:
    /// Takes maps of tables of one body, at the addresses that the trace reports.
    explicit FeatureHeat(std::span<const TableMap> maps);

    void on_access(const measure::TracedAccess& access) override;
    void on_query_end(bool /*counts*/) override { ++queries_; }

    [[nodiscard]] std::uint64_t queries() const { return queries_; }
    /// Reads of the features of a kind over all tables, in the order of the layout; nothing where it stores
    /// nothing for them alone, or not one by one.
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
