// SPDX-License-Identifier: MIT
//
// What a table declares of its memory: which bytes are there, and what each is for. The ledger adds them up,
// a drawing paints them, and a contract test holds every traced read against them.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "edgewise/table/ledger.hpp"

namespace edgewise {

/// So many bytes of an element serve this component. Shares of an element stand in memory order; what is left
/// of it is padding at its end, padding within is a share like others.
struct Share {
    Component component;
    std::size_t bytes;
};

/// The shares of one kind of element.
class Shares {
  public:
    static constexpr std::size_t most = 10;

    Shares() = default;
    Shares(std::initializer_list<Share> shares) {
        for (const Share& share : shares) add(share);
    }
    void add(const Share& share) {
        assert(count_ < most);
        shares_[count_++] = share;
    }
    [[nodiscard]] const Share* begin() const { return shares_.data(); }
    [[nodiscard]] const Share* end() const { return shares_.data() + count_; }
    [[nodiscard]] std::size_t bytes() const {
        std::size_t sum = 0;
        for (const Share& share : *this) sum += share.bytes;
        return sum;
    }
    [[nodiscard]] bool operator==(const Shares& other) const {
        if (count_ != other.count_) return false;
        for (std::size_t i = 0; i < count_; ++i) {
            const Share &a = shares_[i], &b = other.shares_[i];
            if (a.component != b.component || a.bytes != b.bytes) return false;
        }
        return true;
    }

  private:
    std::array<Share, most> shares_{};
    std::size_t count_ = 0;
};

/// `count` elements of one kind, `stride` bytes apart.
struct Piece {
    const std::byte* at = nullptr;
    std::size_t stride = 0, count = 0;
    Shares shares = {};

    [[nodiscard]] std::size_t bytes() const { return stride * count; }
    [[nodiscard]] bool holds(const void* address, std::size_t size) const {
        const auto* const from = static_cast<const std::byte*>(address);
        return from >= at && from + size <= at + bytes();
    }
    /// Books the piece's bytes.
    void add_to(Ledger& ledger) const {
        assert(shares.bytes() <= stride);
        for (const Share& share : shares) ledger[share.component] += share.bytes * count;
        ledger[Component::padding] += (stride - shares.bytes()) * count;
    }
};

[[nodiscard]] inline Ledger ledger_of(std::span<const Piece> pieces) {
    Ledger ledger;
    for (const Piece& piece : pieces) piece.add_to(ledger);
    return ledger;
}

/// A piece without its memory.
struct MappedPiece {
    std::size_t offset = 0, stride = 0, count = 0;
    Shares shares;
};

/// A table's memory from the lowest address up, by offset, so that it outlives the table: from `base` or else
/// from the lowest address; gaps between pieces belong to nobody.
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
