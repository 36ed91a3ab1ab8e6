// SPDX-License-Identifier: MIT
//
// The fields of `aos` and of its rings in records by groups that are chosen at run time: which fields share a
// record is a list, not a type. `edgewise fields` finds a list, builds it here and measures it. The groups of
// `aos` give the table of `aos`, byte for byte, and those of `hot_cold` that of `hot_cold`; so a gain or loss
// of another list comes from the list. The cost: a field's place is a start and a stride, 16 bytes that the
// table holds and reads before the field, where a struct has a constant.
//
// The usual groups, used unless others are chosen, are what `edgewise fields` advised for `aos_f64` and
// V-Clip in the scene `tumble`: at 386 vertices 27.0 lines per query instead of 32.3.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "edgewise/layout_parts/field_groups.hpp"
#include "edgewise/layout_parts/stored_table.hpp"

namespace edgewise {

/// Groups for a table without a choice of its own.
[[nodiscard]] inline const FieldGroups& usual_groups() {
    using enum StoredField;
    static const FieldGroups groups = {{point, vertex_offset},
                                       {tail_plane},
                                       {head_plane, direction, tail, head},
                                       {left_plane, right_plane},
                                       {left, right},
                                       {length},
                                       {face_plane},
                                       {face_offset},
                                       {vertex_ring},
                                       {neighbour},
                                       {face_ring}};
    return groups;
}

template <class Stored>
struct GroupedArrays : RingsAt<GroupedArrays<Stored>> {
    /// The place of a field in each record.
    struct Column {
        std::byte* first = nullptr;
        std::size_t stride = 0;
    };

    FieldGroups groups = FieldsGroupedBy<StoredField>::chosen_or(usual_groups());
    std::array<Column, stored_field_count> columns{};

    void place(BlockPlan& plan, const BodyFacts& n) {
        const auto sized = sized_stored_fields<Stored>();
        place_groups(
            plan, groups, sized,
            [&](std::uint8_t field) { return record_count(static_cast<StoredField>(field), n); },
            [&](const GroupRecord& record) { return shares_of(record, sized); },
            [&](std::uint8_t field, std::size_t start, std::size_t stride) {
                if (plan.base()) columns[field] = {plan.base() + start, stride};
            });
    }

    [[nodiscard]] auto& vertex(Index v) const { return at<Vec3<Stored>>(StoredField::point, v); }
    [[nodiscard]] auto& vertex_edge_plane(Index e, End end) const {
        return at<Plane<Stored>>(end == End::tail ? StoredField::tail_plane : StoredField::head_plane, e);
    }
    [[nodiscard]] auto& edge_face_plane(Index e, Side side) const {
        return at<Plane<Stored>>(side == Side::left ? StoredField::left_plane : StoredField::right_plane, e);
    }
    [[nodiscard]] auto& direction(Index e) const { return at<Vec3<Stored>>(StoredField::direction, e); }
    [[nodiscard]] auto& length(Index e) const { return at<Stored>(StoredField::length, e); }
    [[nodiscard]] auto& face_plane(Index f) const { return at<Plane<Stored>>(StoredField::face_plane, f); }
    /// The two ends of one edge.
    struct Ends {
        const GroupedArrays* arrays;
        Index edge;
    };
    [[nodiscard]] Ends ends(Index e) const { return {this, e}; }

    [[nodiscard]] Index& vertex_offset_at(Index v) const { return at<Index>(StoredField::vertex_offset, v); }
    [[nodiscard]] Index& neighbour_at(Index i) const { return at<Index>(StoredField::neighbour, i); }
    [[nodiscard]] Index& vertex_ring_at(Index i) const { return at<Index>(StoredField::vertex_ring, i); }
    [[nodiscard]] Index& face_offset_at(Index f) const { return at<Index>(StoredField::face_offset, f); }
    [[nodiscard]] Index& face_ring_at(Index i) const { return at<Index>(StoredField::face_ring, i); }

    friend Index& end_at(const Ends& ends, std::size_t k) {
        const auto field = static_cast<StoredField>(static_cast<std::size_t>(StoredField::tail) + k);
        return ends.arrays->template at<Index>(field, ends.edge);
    }
    friend void write_ends(const Ends& to, const PolyhedronEdge& ends) {
        for (std::size_t k = 0; k < ends_in_order.size(); ++k) end_at(to, k) = edgewise::end_at(ends, k);
    }

  private:
    template <class Value>
    [[nodiscard]] Value& at(StoredField field, Index element) const {
        const Column& column = columns[static_cast<std::size_t>(field)];
        return *reinterpret_cast<Value*>(column.first + element * column.stride);
    }

    static Shares shares_of(const GroupRecord& record, std::span<const RecordField> sized) {
        ShareRuns runs;
        for (std::size_t i = 0; i < record.count; ++i) {
            runs.pad_to(record.offset[i]);
            runs.add(info_of(static_cast<StoredField>(record.fields[i])).component,
                     sized[record.fields[i]].bytes);
        }
        return runs.take();
    }
};

template <Precision P, class Loader = Direct>
class grouped : public StoredTable<GroupedArrays<typename P::Stored>, P, Loader> {
    using Base = StoredTable<GroupedArrays<typename P::Stored>, P, Loader>;

  public:
    static constexpr std::string_view name = "grouped";
    static constexpr std::string_view stores =
        "the fields of aos in records by groups that are chosen at run time";

    using Base::Base;
};

}  // namespace edgewise
