// SPDX-License-Identifier: MIT
//
// Groups of fields that share a record: fields by number, cut into groups; each group is one kind of record.
// A layout takes its groups from here at run time: a choice holds for tables that this thread builds while it
// lives, as with TablesIn for memory.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "edgewise/layout_parts/block.hpp"
#include "edgewise/table/field_map.hpp"

namespace edgewise {

/// Groups in memory order. Copied with every table, so it owns no memory.
class FieldGroups {
  public:
    static constexpr std::size_t most = 32;  ///< fields

    FieldGroups() = default;
    /// Takes groups of fields; Field is an enumeration of fields, by number.
    template <class Field>
    FieldGroups(std::initializer_list<std::initializer_list<Field>> groups) {
        for (const auto& group : groups) {
            std::array<std::uint8_t, most> numbers{};
            std::size_t count = 0;
            for (const Field field : group) numbers[count++] = static_cast<std::uint8_t>(field);
            add({numbers.data(), count});
        }
    }

    void add(std::span<const std::uint8_t> group) {
        assert(count_ + group.size() <= most);
        if (group.empty()) return;
        starts_ |= std::uint32_t{1} << count_;
        for (const std::uint8_t field : group) fields_[count_++] = field;
    }

    /// Calls use(group) for each group, a span of field numbers.
    template <class Use>
    void for_each(Use use) const {
        for (std::size_t first = 0; first < count_;) {
            std::size_t last = first + 1;
            while (last < count_ && (starts_ >> last & 1) == 0) ++last;
            use(std::span(fields_).subspan(first, last - first));
            first = last;
        }
    }
    [[nodiscard]] bool operator==(const FieldGroups&) const = default;

  private:
    std::array<std::uint8_t, most> fields_{};
    std::uint32_t starts_ = 0;  ///< bit i: a group starts at fields_[i]
    std::uint8_t count_ = 0;
};

/// The record of one group: its fields in the given order, each at its alignment, as in a struct.
struct GroupRecord {
    std::array<std::uint8_t, FieldGroups::most> fields{};   ///< in memory order
    std::array<std::uint32_t, FieldGroups::most> offset{};  ///< offset of each field
    std::size_t count = 0;
    BlockPlan::RecordSize size{0, 1};

    /// `sized`: description of each field, by number.
    GroupRecord(std::span<const std::uint8_t> group, std::span<const RecordField> sized)
        : count(group.size()) {
        assert(count <= FieldGroups::most);
        std::copy(group.begin(), group.end(), fields.begin());
        for (std::size_t i = 0; i < count; ++i) {
            const RecordField& field = sized[fields[i]];
            size.bytes = rounded_up(size.bytes, field.alignment);
            offset[i] = static_cast<std::uint32_t>(size.bytes);
            size.bytes += field.bytes;
            size.alignment = std::max<std::size_t>(size.alignment, field.alignment);
        }
        size.bytes = rounded_up(size.bytes, size.alignment);
    }
};

/// Purposes of the bytes of a record, field by field in memory order.
class ShareRuns {
  public:
    void add(Component component, std::size_t bytes) {
        if (bytes == 0) return;
        if (run_.bytes > 0 && run_.component != component) {
            shares_.add(run_);
            run_.bytes = 0;
        }
        run_ = {component, run_.bytes + bytes};
        end_ += bytes;
    }
    void pad_to(std::size_t offset) {
        assert(offset >= end_);
        add(Component::padding, offset - end_);
    }
    [[nodiscard]] Shares take() {
        if (run_.bytes > 0 && run_.component != Component::padding) shares_.add(run_);
        run_.bytes = 0;
        return shares_;
    }

  private:
    Shares shares_;
    Share run_{};
    std::size_t end_ = 0;
};

/// Adds the records of all groups to a plan, in order. records(field): their number; 0 leaves the field out
/// of its group. shares(record): the purposes of its bytes. use(field, start, stride): receives the places of
/// its values, in bytes from the block's start.
template <class Records, class SharesOf, class Use>
void place_groups(BlockPlan& plan, const FieldGroups& groups, std::span<const RecordField> sized,
                  const Records& records, const SharesOf& shares, const Use& use) {
    groups.for_each([&](std::span<const std::uint8_t> group) {
        std::array<std::uint8_t, FieldGroups::most> held{};
        std::size_t count = 0, most = 0;
        for (const std::uint8_t field : group) {
            const std::size_t of_field = records(field);
            if (of_field > 0) held[count++] = field;
            most = std::max(most, of_field);
        }
        if (count == 0) return;
        const GroupRecord record({held.data(), count}, sized);
        const std::size_t start = plan.records_at(record.size, most, shares(record));
        for (std::size_t i = 0; i < count; ++i)
            use(record.fields[i], start + record.offset[i], record.size.bytes);
    });
}

/// Chooses groups for tables with fields of this enumeration, while it lives; choices nest.
template <class Field>
class FieldsGroupedBy {
  public:
    explicit FieldsGroupedBy(const FieldGroups& groups) : before_(current()) { current() = &groups; }
    ~FieldsGroupedBy() { current() = before_; }
    FieldsGroupedBy(const FieldsGroupedBy&) = delete;
    FieldsGroupedBy& operator=(const FieldsGroupedBy&) = delete;

    /// Returns the chosen groups, or else `usual`.
    [[nodiscard]] static const FieldGroups& chosen_or(const FieldGroups& usual) {
        return current() ? *current() : usual;
    }

  private:
    static const FieldGroups*& current() {
        thread_local const FieldGroups* chosen = nullptr;
        return chosen;
    }
    const FieldGroups* before_;
};

}  // namespace edgewise
