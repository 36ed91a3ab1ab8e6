// SPDX-License-Identifier: MIT
#include "edgewise/studies/fields/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/bench/trace/trace_places.hpp"
#include "edgewise/layout_parts/stored_fields.hpp"

namespace edgewise::studies {

namespace {

class FieldRecorder final : public measure::TraceListener {
  public:
    explicit FieldRecorder(const std::vector<FieldMap>& maps) {
        for (std::uint32_t table = 0; table < maps.size(); ++table)
            for (const FieldPlace& place : maps[table].places)
                entries_.emplace(place.at,
                                 Entry{{table, place.element, place.field, place.part}, place.bytes});
    }

    void on_query_start(measure::QueryStart start) override {
        events_.push_back({.kind = FieldEvent::Kind::query_start, .start = start});
    }
    void on_step_start(std::uint8_t step) override {
        events_.push_back({.kind = FieldEvent::Kind::step_start});
        events_.back().access.step = step;
    }
    void on_access(const measure::TracedAccess& access) override {
        events_.push_back({.kind = FieldEvent::Kind::other, .access = access});
        if (access.side == measure::TraceSide::scene) return;
        const auto found = entries_.find(access.address);
        if (found != entries_.end() && found->second.bytes == access.bytes) {
            events_.back().kind = FieldEvent::Kind::field;
            events_.back().field = found->second.access;
        } else if (!unknown_) {
            unknown_ = access;
        }
    }
    void on_query_end(bool counts) override {
        events_.push_back({.kind = FieldEvent::Kind::query_end, .counts = counts});
    }
    void on_frame_end() override { events_.push_back({.kind = FieldEvent::Kind::frame_end}); }

    [[nodiscard]] std::vector<FieldEvent> take() { return std::move(events_); }
    /// Returns the first read of a table that reads no field.
    [[nodiscard]] const std::optional<measure::TracedAccess>& unknown() const { return unknown_; }

  private:
    struct Entry {
        FieldAccess access;
        std::uint8_t bytes;
    };
    std::unordered_map<std::uint64_t, Entry> entries_;  ///< by address
    std::vector<FieldEvent> events_;
    std::optional<measure::TracedAccess> unknown_;
};

/// Returns how many records have each field.
std::vector<std::uint32_t> records_of(const FieldMap& table) {
    std::vector<std::uint32_t> records(table.fields.size());
    for (const FieldPlace& place : table.places)
        records[place.field] = std::max(records[place.field], place.element + 1);
    return records;
}

}  // namespace

FieldTrace trace_fields(const bench::Runner& runner, const bench::TraceExtent& extent,
                        const std::string& table) {
    FieldTrace trace;
    trace.tables = runner.field_maps();
    if (trace.tables.empty() || !runner.table_allocator().base())
        throw std::invalid_argument(
            fmt::format("{}: this layout does not keep its fields in arrays, each in a place of its own; "
                        "name aos, aos_padded, hot_cold, soa, soa_stagger, aosoa or grouped",
                        table));
    FieldRecorder recorder(trace.tables);
    trace.queries = runner.trace(extent, recorder).queries;
    if (const auto& unknown = recorder.unknown())
        throw std::invalid_argument(
            fmt::format("{}: a read of {} bytes at {} ({}) is of no field that the layout names", table,
                        unknown->bytes, unknown->address, bench::field_names()[unknown->field]));
    trace.events = recorder.take();
    trace.taken = runner.table_allocator().taken();
    return trace;
}

GroupedPlaces::GroupedPlaces(const std::vector<FieldMap>& tables, const FieldGroups& groups) {
    for (const FieldMap& table : tables) {
        std::vector<Column>& columns = columns_.emplace_back(table.fields.size());
        const std::vector<std::uint32_t> records = records_of(table);
        BlockPlan plan;
        place_groups(
            plan, groups, table.fields, [&](std::uint8_t field) { return records[field]; },
            [](const GroupRecord&) { return Shares(); },
            [&](std::uint8_t field, std::size_t start, std::size_t stride) {
                columns[field] = {start, stride};
            });
        const std::uint64_t base = rounded_up(taken_, plan.block_alignment());
        for (Column& column : columns) column.first += base;
        taken_ = base + plan.size();
    }
}

void replay(const FieldTrace& trace, const GroupedPlaces& places, measure::TraceListener& listener) {
    const std::uint64_t was = bench::TracePlaces::page_after(trace.taken),
                        is = bench::TracePlaces::page_after(places.taken());
    for (const FieldEvent& event : trace.events) {
        using enum FieldEvent::Kind;
        measure::TracedAccess access = event.access;
        switch (event.kind) {
            case query_start:
                listener.on_query_start(event.start);
                break;
            case step_start:
                listener.on_step_start(access.step);
                break;
            case field:
                access.address = places.address(event.field);
                listener.on_access(access);
                break;
            case other:
                access.address += is - was;
                listener.on_access(access);
                break;
            case query_end:
                listener.on_query_end(event.counts);
                break;
            case frame_end:
                listener.on_frame_end();
                break;
        }
    }
}

}  // namespace edgewise::studies
