// SPDX-License-Identifier: MIT
//
// How much a query of a scene has in common with the last one of its pair, and how many tables the scene's
// queries go through: by these, and by vertices, a winner is looked up.
#pragma once

#include <compare>
#include <optional>
#include <string>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// From the most coherent to the least.
struct Coherence {
    enum class Start { turned, random, fresh };  ///< by an angle; at random; a pair that was never asked

    Start start = Start::fresh;
    double turn = 0;   ///< radians per step: 0, or a power of the root of ten
    std::string kind;  ///< of scene

    auto operator<=>(const Coherence&) const = default;

    /// "tumble, 0.1 rad", "tumble, random turns", "cold, every pair new"
    [[nodiscard]] std::string text() const;
};

/// Null where the scene says neither.
[[nodiscard]] std::optional<Coherence> coherence_of(const ReportCell& cell);

/// How far the scene's turn is from the one that stands for it, as a ratio of at least 1; 1 where it is none.
[[nodiscard]] double distance_from_class(const ReportCell& cell, const Coherence& coherence);

/// A class of the number of tables: the power of ten that it reaches; -1: one table that all bodies share.
/// Null where the bodies have tables of their own and the scene does not say how many.
[[nodiscard]] std::optional<int> tables_class(const ReportCell& cell);
/// "one shared table", "2 to 9 tables", "100 to 999 tables"
[[nodiscard]] std::string tables_class_text(int of);

}  // namespace edgewise::reports
