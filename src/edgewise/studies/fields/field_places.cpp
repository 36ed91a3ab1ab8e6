// SPDX-License-Identifier: MIT
#include "edgewise/studies/fields/field_places.hpp"

#include "edgewise/bench/trace/trace_places.hpp"

namespace edgewise::studies {

GroupedPlaces::GroupedPlaces(const std::vector<TableFields>& tables, const FieldGroups& groups) {
    for (const TableFields& table : tables) {
        std::vector<Column>& columns = columns_.emplace_back(table.count());
        BlockPlan plan;
        place_groups(
            plan, groups, table.fields, [&](std::uint8_t field) { return table.records[field]; },
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
