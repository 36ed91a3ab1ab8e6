// SPDX-License-Identifier: MIT
#include "edgewise/studies/fields/fields.hpp"

#include <bit>
#include <map>
#include <string_view>
#include <unordered_map>

namespace edgewise::studies {

namespace {

/// Fields as bits.
using FieldSet = std::uint32_t;

void add_set(FieldCounts& counts, FieldSet set) {
    for (FieldSet left = set; left != 0; left &= left - 1) {
        const auto a = static_cast<std::size_t>(std::countr_zero(left));
        for (FieldSet others = set; others != 0; others &= others - 1)
            ++counts[a][static_cast<std::size_t>(std::countr_zero(others))];
    }
}

class CoAccessCounter {
  public:
    explicit CoAccessCounter(const std::vector<RecordField>& fields) {
        const FieldCounts none(fields.size(), std::vector<std::uint64_t>(fields.size()));
        counts_ = {none, none, none};
        std::map<std::string_view, std::uint64_t> kinds;
        for (const RecordField& field : fields)
            kind_.push_back(kinds.emplace(field.record, kinds.size()).first->second);
    }

    void read(measure::TraceSide side, const FieldAccess& field) {
        const FieldSet bit = FieldSet{1} << field.field;
        of_step_ |= bit;
        const std::uint64_t whose =
            kind_[field.field] << 40 | std::uint64_t{field.element} << 8 | static_cast<std::uint64_t>(side);
        of_records_[whose] |= bit;
    }
    void end_step() {
        if (of_step_ == 0) return;
        ++counts_.steps;
        add_set(counts_.by_step, of_step_);
        for (const auto& [whose, set] : of_records_) add_set(counts_.by_record, set);
        of_query_ |= of_step_;
        of_step_ = 0;
        of_records_.clear();
    }
    void end_query() {
        end_step();
        ++counts_.queries;
        add_set(counts_.by_query, of_query_);
        of_query_ = 0;
    }
    [[nodiscard]] CoAccess take() { return std::move(counts_); }

  private:
    CoAccess counts_;
    std::vector<std::uint64_t> kind_;  ///< of record, by field
    FieldSet of_step_ = 0, of_query_ = 0;
    std::unordered_map<std::uint64_t, FieldSet> of_records_;  ///< of the step
};

}  // namespace

double CoAccess::overlap(const FieldCounts& counts, std::size_t a, std::size_t b) {
    const std::uint64_t both = counts[a][b], either = counts[a][a] + counts[b][b] - both;
    return either == 0 ? 0 : static_cast<double>(both) / static_cast<double>(either);
}

CoAccess co_access(const FieldTrace& trace) {
    CoAccessCounter counter(trace.fields());
    for (const FieldEvent& event : trace.events) {
        if (event.kind == FieldEvent::Kind::step_start) counter.end_step();
        if (event.kind == FieldEvent::Kind::field) counter.read(event.access.side, event.field);
        if (event.kind == FieldEvent::Kind::query_end) counter.end_query();
    }
    return counter.take();
}

}  // namespace edgewise::studies
