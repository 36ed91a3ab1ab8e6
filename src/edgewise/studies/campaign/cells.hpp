// SPDX-License-Identifier: MIT
//
// The cells of a campaign: an algorithm on a table type, one of each class of equal answers, and GJK also
// with Johnson's sub-distance search and for the verdict alone. Most table types give the same bits as
// another (shared arithmetic, other memory); the program compares its own answers, over pairs of every
// family, to find which do.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/truth/checked_answer.hpp"

namespace edgewise::studies::campaign {

/// Answers the queries of a cell. The tests have one that gives wrong answers on purpose.
class Asker {
  public:
    Asker() = default;
    Asker(const Asker&) = delete;
    Asker& operator=(const Asker&) = delete;
    virtual ~Asker() = default;

    /// Returns an error line if the bodies cannot be stored, else "". The workload must outlive the queries.
    [[nodiscard]] virtual std::string load(const scene::Workload& workload) = 0;
    /// Answers every query of the workload: from cold, or warm where the workload says so.
    [[nodiscard]] virtual std::vector<Distance> answer() = 0;
    [[nodiscard]] virtual std::span<const Polyhedron> stored_bodies() const = 0;
};

struct Cell {
    std::string name;           ///< "gjk aos_f64", "gjk aos_f64 johnson"
    double eps = 0;             ///< rounding step of the arithmetic
    double error_allowed = 0;   ///< over scale, beyond the band
    bool verdict_only = false;  ///< its distances are bounds, and not checked
    std::function<std::unique_ptr<Asker>()> make_asker;
    std::vector<std::string> as_well{};  ///< cells with the same answers
};

/// Returns every algorithm on every table type that supports it; GJK in each of its three ways.
[[nodiscard]] std::vector<Cell> cells_of(std::span<const bench::TableType* const> types,
                                         std::span<const std::string> algorithms);

/// Returns the first cell of each class of equal answers (status, distance, witness points, normal).
[[nodiscard]] std::vector<Cell> one_of_each_class(std::vector<Cell> cells);

/// Checks an answer against the exact one.
[[nodiscard]] truth::CheckedAnswer check_answer(const Distance& answer, const Cell& cell,
                                                const truth::StoredPair& stored,
                                                const truth::PosesOfPair& poses, truth::ProvenPair& known);

/// Returns what is wrong with the answer; empty if it is right.
[[nodiscard]] std::string what_is_wrong(const truth::CheckedAnswer& checked, const Distance& answer,
                                        const truth::StoredPair& stored, const truth::PosesOfPair& poses,
                                        truth::ProvenPair& known);

}  // namespace edgewise::studies::campaign
