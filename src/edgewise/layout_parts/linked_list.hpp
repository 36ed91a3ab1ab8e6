// SPDX-License-Identifier: MIT
//
// Linked lists as ranges, each step a read through the loader.
#pragma once

#include <cassert>
#include <cstddef>

#include "edgewise/table/loader.hpp"

namespace edgewise {

/// A list from one of its nodes on, both range and iterator: `item` is what a node stands for.
template <class Loader, class Node, class Item>
class LinkedList {
  public:
    LinkedList(const Loader& loader, const Node* at, Field field, Item item)
        : loader_(&loader), at_(at), field_(field), item_(item) {}
    [[nodiscard]] LinkedList begin() const { return *this; }
    [[nodiscard]] std::nullptr_t end() const { return nullptr; }
    auto operator*() const {
        assert(at_);
        return item_(at_);
    }
    LinkedList& operator++() {
        assert(at_);
        at_ = static_cast<const Node*>(loader_->load(at_->next, field_));
        return *this;
    }
    bool operator!=(std::nullptr_t) const { return at_ != nullptr; }

  private:
    const Loader* loader_;
    const Node* at_;
    Field field_;
    Item item_;
};

}  // namespace edgewise
