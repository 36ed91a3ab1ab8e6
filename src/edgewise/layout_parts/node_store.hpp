// SPDX-License-Identifier: MIT
//
// Memory of a table that is made of nodes: each asked for by itself, as `new` would, and given back one by
// one. For layouts with pointers; the others keep one block (block.hpp).
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

#include "edgewise/table/pieces.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise {

class NodeStore {
  public:
    NodeStore() = default;
    ~NodeStore() {
        for (const Node& node : nodes_) {
            const Kind& kind = kinds_[node.kind];
            resource_.deallocate(node.at, kind.bytes, kind.alignment);
        }
    }
    NodeStore(const NodeStore&) = delete;
    NodeStore& operator=(const NodeStore&) = delete;

    /// A new node, its pointers null; `shares` say what its bytes are for, the same for all nodes of a type.
    template <class Type>
    [[nodiscard]] Type* make(const Shares& shares) {
        static_assert(std::is_trivially_destructible_v<Type>);
        const std::uint32_t kind = kind_of({sizeof(Type), alignof(Type), shares});
        void* const memory = resource_.allocate(sizeof(Type), alignof(Type));
        nodes_.push_back({static_cast<std::byte*>(memory), kind});
        return new (memory) Type{};
    }

    [[nodiscard]] Ledger ledger() const {
        Ledger ledger;
        for (const Node& node : nodes_) piece(node).add_to(ledger);
        return ledger;
    }
    /// In the order in which they were made.
    [[nodiscard]] std::vector<Piece> pieces() const {
        std::vector<Piece> all;
        for (const Node& node : nodes_) all.push_back(piece(node));
        return all;
    }

  private:
    struct Kind {
        std::size_t bytes, alignment;
        Shares shares;
    };
    struct Node {
        std::byte* at;
        std::uint32_t kind;
    };

    [[nodiscard]] std::uint32_t kind_of(const Kind& wanted) {
        const auto same = [&](const Kind& k) {
            return k.bytes == wanted.bytes && k.alignment == wanted.alignment && k.shares == wanted.shares;
        };
        const auto found = std::find_if(kinds_.begin(), kinds_.end(), same);
        const auto at = static_cast<std::uint32_t>(found - kinds_.begin());
        if (found == kinds_.end()) kinds_.push_back(wanted);
        return at;
    }
    [[nodiscard]] Piece piece(const Node& node) const {
        return {node.at, kinds_[node.kind].bytes, 1, kinds_[node.kind].shares};
    }

    std::pmr::memory_resource& resource_ = table_memory();
    std::vector<Kind> kinds_;
    std::vector<Node> nodes_;
};

}  // namespace edgewise
