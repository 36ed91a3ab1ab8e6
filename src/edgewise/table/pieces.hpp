// SPDX-License-Identifier: MIT
//
// A table declares its memory in pieces: which bytes there are, and the purpose of each. The ledger adds them
// up, a drawing paints them, and a contract test compares every traced read with them.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <span>
#include <string_view>
#include <vector>

namespace edgewise {

/// Purposes of a table's bytes.
enum class Component : std::uint8_t {
    voronoi_planes,
    edge_geometry,  ///< direction and length
    vertex_coordinates,
    face_planes,
    topology,
    input_order,  ///< index of each vertex in the user's list
    padding,      ///< inside records and between arrays
};

inline constexpr std::array<std::string_view, 7> component_names = {
    "voronoi_planes", "edge_geometry", "vertex_coordinates", "face_planes", "topology",
    "input_order",    "padding"};

/// Number of bytes of a table by purpose.
struct Ledger {
    std::array<std::size_t, component_names.size()> bytes{};

    [[nodiscard]] std::size_t& operator[](Component c) { return bytes[static_cast<std::size_t>(c)]; }
    [[nodiscard]] std::size_t operator[](Component c) const { return bytes[static_cast<std::size_t>(c)]; }

    /// Sum of all bytes of the table.
    [[nodiscard]] std::size_t total() const {
        return std::accumulate(bytes.begin(), bytes.end(), std::size_t{0});
    }

    /// The paper's subtotal: Voronoi planes, direction and length, vertex coordinates; 0 where no planes are
    /// stored.
    [[nodiscard]] std::size_t paper_subtotal() const {
        if ((*this)[Component::voronoi_planes] == 0) return 0;
        return (*this)[Component::voronoi_planes] + (*this)[Component::edge_geometry] +
               (*this)[Component::vertex_coordinates];
    }
};

/// Bytes of an element that serve one component. Shares of an element lie in memory order; the rest of it is
/// padding at its end, and padding within is a share of its own.
struct Share {
    Component component;
    std::size_t bytes;
};

/// The shares of one kind of element.
class Shares {
  public:
    static constexpr std::size_t most = 16;  ///< an edge's ten fields in any order, and padding between them

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
    /// Adds the piece's bytes to the ledger.
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

/// A piece by offset, without its memory.
struct MappedPiece {
    std::size_t offset = 0, stride = 0, count = 0;
    Shares shares;
};

/// A table's memory in order of address, by offset, so that the map outlives the table. Offsets count from
/// `base`, or without it from the lowest address; no piece covers the gaps.
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
