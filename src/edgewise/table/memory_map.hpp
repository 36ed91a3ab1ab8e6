// SPDX-License-Identifier: MIT
//
// A table's memory as a map: its pieces from the lowest address up, by offset, so that it outlives the table.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

#include "edgewise/table/pieces.hpp"

namespace edgewise {

/// A piece without its memory.
struct MappedPiece {
    std::size_t offset = 0, stride = 0, count = 0;
    Shares shares;
};

/// In order of offset, from `base` or else from the lowest address; gaps between pieces belong to nobody.
[[nodiscard]] inline std::vector<MappedPiece> memory_map(std::vector<Piece> pieces,
                                                         const std::byte* base = nullptr) {
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.at < b.at; });
    std::vector<MappedPiece> map;
    for (const Piece& piece : pieces) {
        const std::byte* const from = base ? base : pieces.front().at;
        assert(from <= piece.at);
        map.push_back({static_cast<std::size_t>(piece.at - from), piece.stride, piece.count, piece.shares});
    }
    return map;
}

}  // namespace edgewise
