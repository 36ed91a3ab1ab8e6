// SPDX-License-Identifier: MIT
//
// What a campaign keeps of its pairs: sums and worst cases, by family and by cell. Two parts of a campaign
// add up to the whole in every figure but seconds.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace edgewise::studies::campaign {

/// Tally of one family. Pairs are counted once, proofs once for each storage that holds other bodies,
/// answers once for each cell.
struct FamilyTally {
    std::uint64_t blocks = 0, pairs = 0;
    std::uint64_t refused_pairs = 0;                      ///< of bodies that no table holds
    std::uint64_t least_vertices = 0, most_vertices = 0;  ///< of either body
    /// Pairs, as the first storage holds them; grazing: of unknown verdict, within the band in double.
    std::uint64_t separated = 0, touching = 0, overlapping = 0, grazing = 0;
    std::uint64_t double_proofs = 0, wide_proofs = 0, exact_proofs = 0;
    std::uint64_t answers = 0, refused = 0, in_band = 0;
    std::uint64_t exact_answers = 0;  ///< answers that needed exact arithmetic
    std::uint64_t wrong = 0;
    double making_s = 0, asking_s = 0, proving_s = 0;  ///< processor time

    void add(const FamilyTally& other);
};

struct CellTally {
    std::uint64_t answers = 0, refused = 0, in_band = 0, wrong = 0;
    double worst_error = 0;        ///< bound of the error over scale, beyond the band
    std::uint64_t worst_pair = 0;  ///< the first with that error

    void add(const CellTally& other);
};

struct Tally {
    std::map<std::string, FamilyTally> families;
    std::map<std::string, CellTally> cells;

    void add(const Tally& other);
    [[nodiscard]] FamilyTally all_families() const;
};

[[nodiscard]] nlohmann::json to_json(const Tally& tally);
/// Reads a tally. Throws nlohmann::json::exception if the JSON is not one.
[[nodiscard]] Tally tally_of(const nlohmann::json& json);

}  // namespace edgewise::studies::campaign
