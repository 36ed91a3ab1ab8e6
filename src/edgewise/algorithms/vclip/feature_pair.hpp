// SPDX-License-Identifier: MIT
//
// State of V-Clip that a pair keeps from one query to the next: its last pair of closest features, and what
// the next query tries first, in 8 bytes where tables have numbers for features.
#pragma once

#include <cassert>
#include <cstdint>

#include "edgewise/table/contract.hpp"
#include "edgewise/table/feature_handle.hpp"
#include "edgewise/table/identity.hpp"

namespace edgewise {

template <FeatureTable TableA, FeatureTable TableB>
struct Features {
    Feature<TableA> a;
    Feature<TableB> b;

    /// Features for a cold start; any would do.
    [[nodiscard]] static Features first_of(const TableA& table_a, const TableB& table_b) {
        return {Feature<TableA>::of_vertex(table_a.first_vertex()),
                Feature<TableB>::of_vertex(table_b.first_vertex())};
    }

    [[nodiscard]] bool operator==(const Features&) const = default;
};

/// What the next query of a pair tries first.
enum class FirstTry : std::uint8_t {
    walk,          ///< from the last features
    nearer_start,  ///< they were far from those before (nearer_start.hpp)
    corners,       ///< of the last features: the bodies were too close for the states' arithmetic
    walk_on,       ///< from the last features, however far: a nearer start shortened no walk
};

/// Handles of any kind, each marked with its table.
template <FeatureTable TableA, FeatureTable TableB>
class PlainFeatures {
  public:
    PlainFeatures(const TableA& table_a, const TableB& table_b, const Features<TableA, TableB>& held,
                  FirstTry first_try)
        : held_{held.a.of(table_a), held.b.of(table_b)}, first_try_(first_try) {}

    [[nodiscard]] bool belongs_to(const TableA& table_a, const TableB& table_b) const {
        return held_.a.is_of(table_a) && held_.b.is_of(table_b);
    }
    [[nodiscard]] const Features<TableA, TableB>& in(const TableA&, const TableB&) const { return held_; }
    [[nodiscard]] FirstTry first_try() const { return first_try_; }
    [[nodiscard]] bool operator==(const PlainFeatures&) const = default;

  private:
    Features<TableA, TableB> held_;
    FirstTry first_try_;
};

/// Both features' kinds and numbers, what is tried first, and a mark of both tables, in one word.
template <NamesFeatures TableA, NamesFeatures TableB>
class PackedFeatures {
  public:
    PackedFeatures(const TableA& table_a, const TableB& table_b, const Features<TableA, TableB>& held,
                   FirstTry first_try) {
        const std::uint32_t name_a = feature_name(table_a, held.a), name_b = feature_name(table_b, held.b);
        const bool fits = ((name_a | name_b) >> feature_name_bits) == 0;
        assert(fits && "no body of so many features is built");
        mark_ = (fits ? mark_of(table_a, table_b) : 0) & all_of_mark;
        first_try_ = static_cast<std::uint8_t>(first_try) & 3U;
        kind_a_ = static_cast<std::uint8_t>(held.a.kind()) & 3U;
        kind_b_ = static_cast<std::uint8_t>(held.b.kind()) & 3U;
        name_a_ = name_a & all_of_name;
        name_b_ = name_b & all_of_name;
    }

    [[nodiscard]] bool belongs_to(const TableA& table_a, const TableB& table_b) const {
        return mark_ == mark_of(table_a, table_b);
    }
    [[nodiscard]] Features<TableA, TableB> in(const TableA& table_a, const TableB& table_b) const {
        return {feature_named(table_a, static_cast<FeatureKind>(kind_a_), name_a_),
                feature_named(table_b, static_cast<FeatureKind>(kind_b_), name_b_)};
    }
    [[nodiscard]] FirstTry first_try() const { return static_cast<FirstTry>(first_try_); }
    [[nodiscard]] bool operator==(const PackedFeatures&) const = default;

  private:
    static constexpr int mark_bits = 62 - 2 * (feature_name_bits + 2);
    static constexpr std::uint64_t all_of_mark = (1U << mark_bits) - 1;
    static constexpr std::uint32_t all_of_name = (1U << feature_name_bits) - 1;

    /// Mark of both tables, never 0. After up to 2^12 rebuilds it differs from all earlier ones; beyond that
    /// a number without a feature is detected, and any feature is a valid start.
    [[nodiscard]] static std::uint64_t mark_of(const TableA& table_a, const TableB& table_b) {
        const std::uint32_t mark = static_cast<std::uint32_t>(identity_of(table_a, table_b) & all_of_mark);
        return mark == 0 ? 1 : mark;
    }

    std::uint64_t mark_ : mark_bits;
    std::uint64_t first_try_ : 2;
    std::uint64_t kind_a_ : 2;
    std::uint64_t kind_b_ : 2;
    std::uint64_t name_a_ : feature_name_bits;
    std::uint64_t name_b_ : feature_name_bits;
};

template <FeatureTable TableA, FeatureTable TableB>
struct FeaturesFor {
    using Type = PlainFeatures<TableA, TableB>;
};
template <NamesFeatures TableA, NamesFeatures TableB>
struct FeaturesFor<TableA, TableB> {
    using Type = PackedFeatures<TableA, TableB>;
};

template <FeatureTable TableA, FeatureTable TableB>
class FeaturePair {
  public:
    /// Makes a cold pair.
    FeaturePair(const TableA& table_a, const TableB& table_b)
        : FeaturePair(table_a, table_b, Features<TableA, TableB>::first_of(table_a, table_b)) {}
    FeaturePair(const TableA& table_a, const TableB& table_b, const Features<TableA, TableB>& held,
                FirstTry first_try = FirstTry::walk)
        : held_(table_a, table_b, held, first_try) {}

    /// Returns false after a rebuild: the handles may lead anywhere, and no query follows them.
    [[nodiscard]] bool belongs_to(const TableA& table_a, const TableB& table_b) const {
        return held_.belongs_to(table_a, table_b);
    }
    [[nodiscard]] FirstTry first_try() const { return held_.first_try(); }
    /// Start of the next query of two tables.
    [[nodiscard]] Features<TableA, TableB> start(const TableA& table_a, const TableB& table_b) const {
        if (!belongs_to(table_a, table_b)) return Features<TableA, TableB>::first_of(table_a, table_b);
        return held_.in(table_a, table_b);
    }
    /// Compares what is held and the tables' marks.
    [[nodiscard]] bool operator==(const FeaturePair&) const = default;

  private:
    typename FeaturesFor<TableA, TableB>::Type held_;
};

}  // namespace edgewise
