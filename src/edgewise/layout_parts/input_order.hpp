// SPDX-License-Identifier: MIT
//
// The index of each vertex in the user's list: a permutation in tables that order vertices in their own way,
// for users that name features and no longer have the body. In 1, 2 or 4 bytes per vertex; left out unless it
// is asked for, since neither distances nor points need it.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/narrow_rings.hpp"
#include "edgewise/table/body_facts.hpp"

namespace edgewise {

enum class InputOrder : bool { left_out, kept };

/// Points (in the form that DerivedTable needs) with their input indices behind them, if these are kept.
template <class Points>
class WithInputOrder : public Points {
  public:
    WithInputOrder(const Polyhedron& body, InputOrder wanted) : kept_(wanted == InputOrder::kept) {
        assert(body.input_index.size() == body.vertex_count());
        if (kept_) largest_ = *std::max_element(body.input_index.begin(), body.input_index.end());
    }

    void place(BlockPlan& plan, const BodyFacts& n) {
        Points::place(plan, n);
        if (!kept_) return;
        const NarrowPlace indices(plan, n.vertex_count, largest_, Component::input_order);
        at_ = indices.at;
        width_ = indices.width;
    }

    void write(std::byte* base, const Polyhedron& body) {
        Points::write(base, body);
        if (!kept_) return;
        NarrowArray(base + at_, width_).fill(body.vertex_count(), [&](Index v) {
            return body.input_index[v];
        });
    }

    [[nodiscard]] bool keeps_input_order() const { return kept_; }
    template <class Loader>
    [[nodiscard]] Index input_index(const Loader& loader, std::byte* base, Index v) const {
        assert(kept_);
        return NarrowArray(base + at_, width_).read(loader, v, Field::vertex);
    }

  private:
    bool kept_;
    std::uint8_t width_ = 1;
    std::uint32_t at_ = 0;
    Index largest_ = 0;
};

}  // namespace edgewise
