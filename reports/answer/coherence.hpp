// SPDX-License-Identifier: MIT
//
// How much a query of a scene has in common with the last one of its pair, and how many tables the scene's
// queries go through: the break-even map looks up a winner by these two and by vertices.
#pragma once

#include <compare>
#include <optional>
#include <string>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// How each pair starts a query, ordered from the most coherent to the least.
struct Coherence {
    enum class Start { turned, random, fresh };  ///< by an angle; at random; a pair without an earlier query

    Start start = Start::fresh;
    double turn = 0;   ///< radians per step: 0, or a power of the root of ten
    std::string kind;  ///< kind of scene

    auto operator<=>(const Coherence&) const = default;

    /// Returns "tumble, 0.1 rad", "tumble, random turns", "cold, every pair new".
    [[nodiscard]] std::string text() const;
};

/// Returns the coherence of a cell's scene; null if the scene does not say it.
[[nodiscard]] std::optional<Coherence> coherence_of(const ReportCell& cell);

/// Returns the ratio, at least 1, of the scene's turn to the turn of its class; 1 for scenes without a turn.
[[nodiscard]] double distance_from_class(const ReportCell& cell, const Coherence& coherence);

/// Returns the class of the number of tables: its power of ten; -1 if all bodies share one table.
/// Null if the bodies have tables of their own and the scene does not say how many.
[[nodiscard]] std::optional<int> tables_class(const ReportCell& cell);
/// Returns "one shared table", "2 to 9 tables", "100 to 999 tables".
[[nodiscard]] std::string tables_class_text(int of);

}  // namespace edgewise::reports
