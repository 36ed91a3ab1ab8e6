// SPDX-License-Identifier: MIT
//
// Nodes that are structs: each field in its place, each node allocated by itself, as with `new`.
#pragma once

#include <cstddef>
#include <memory_resource>
#include <new>
#include <type_traits>
#include <vector>

#include "edgewise/layout_parts/field_groups.hpp"
#include "edgewise/layout_parts/linked_nodes.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/loader.hpp"

namespace edgewise {

template <class StoredScalar>
struct NodeStructs {
    using Stored = StoredScalar;
    using Nodes = LinkedNodes<Stored>;

    /// The field's place. A pointer on the way would be read by the loader under that name; here none is.
    template <NodeField field, class Loader, class Node>
    [[nodiscard]] static auto& at(const Loader& /*loader*/, Node* node, Field /*name*/) {
        return node->*node_member<Stored, field>;
    }

    /// Called before the first node is made, and after the last one was given back.
    static void prepare(const BodyFacts& /*n*/, std::pmr::memory_resource& /*owner*/) {}
    static void release(std::pmr::memory_resource& /*owner*/) {}

    /// Makes a node with null pointers.
    template <class Node>
    [[nodiscard]] static Node* make(std::pmr::memory_resource& owner) {
        static_assert(std::is_trivially_destructible_v<Node>);
        return new (owner.allocate(sizeof(Node), alignof(Node))) Node{};
    }
    template <class Node>
    static void give_back(Node* node, std::pmr::memory_resource& owner) {
        owner.deallocate(node, sizeof(Node), alignof(Node));
    }

    template <class Node>
    static void add_piece(const Node* node, std::vector<Piece>& to) {
        to.push_back({reinterpret_cast<const std::byte*>(node), sizeof(Node), 1, shares<Node>()});
    }
    /// Adds the pieces of memory other than the nodes: none here.
    static void add_further_pieces(std::vector<Piece>& /*to*/) {}

  private:
    /// Shares of runs of fields of one purpose, with the padding between them.
    template <class Node>
    [[nodiscard]] static Shares shares() {
        static const Shares made = [] {
            const auto sized = sized_node_fields<Stored>();
            ShareRuns runs;
            std::size_t end = 0;
            for (std::size_t i = 0; i < node_field_count; ++i) {
                if (node_field_infos[i].kind != kind_of<Stored, Node>()) continue;
                if (end + sized[i].bytes > sizeof(Node)) break;  // a spoke ends before the cone's fields
                end = rounded_up(end, sized[i].alignment);
                runs.pad_to(end);
                runs.add(node_field_infos[i].component, sized[i].bytes);
                end += sized[i].bytes;
            }
            return runs.take();
        }();
        return made;
    }
};

}  // namespace edgewise
