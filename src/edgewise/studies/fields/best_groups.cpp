// SPDX-License-Identifier: MIT
#include "edgewise/studies/fields/fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "edgewise/input/file_text.hpp"
#include "edgewise/input/json_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"

namespace edgewise::studies {

namespace {

using Fields = std::vector<std::uint8_t>;

/// Cost by which groups are compared; the first difference decides.
struct GroupCost {
    std::uint64_t lines = 0, bytes = 0, groups = 0;

    [[nodiscard]] auto operator<=>(const GroupCost&) const = default;
    [[nodiscard]] GroupCost operator+(const GroupCost& other) const {
        return {lines + other.lines, bytes + other.bytes, groups + other.groups};
    }
};

/// The fields, as bits, that one query read from one record of a table.
struct RecordRead {
    std::uint32_t element, fields;
};
using TableReads = std::vector<RecordRead>;

/// The reads of records of one kind, query by query and table by table.
class KindReads {
  public:
    KindReads(const FieldTrace& trace, const Fields& fields) : sized_(trace.fields()) {
        for (const std::uint8_t field : fields) of_kind_ |= std::uint32_t{1} << field;
        for (const FieldMap& table : trace.tables)
            for (const FieldPlace& place : table.places)
                if ((of_kind_ >> place.field & 1) != 0) records_ = std::max(records_, place.element + 1);
        collect(trace);
    }

    /// Returns the fields that any query reads.
    [[nodiscard]] std::uint32_t read() const { return read_; }

    [[nodiscard]] GroupCost cost(const Fields& group) {
        const GroupRecord record(group, sized_);
        const std::uint64_t bytes = std::uint64_t{record.size.bytes} * records_;
        seen_.assign(bytes / measure::cache_line + 2, 0);
        std::uint64_t lines = 0;
        for (std::uint32_t i = 0; i < reads_.size(); ++i)
            for (const RecordRead& read : reads_[i]) lines += new_lines(record, read, i + 1);
        return {lines, bytes, 1};
    }

  private:
    void collect(const FieldTrace& trace) {
        std::map<std::uint32_t, std::uint32_t> of_query[2];
        std::uint64_t queries = 0;
        for (const FieldEvent& event : trace.events) {
            if (queries == searched_queries) break;
            if (event.kind == FieldEvent::Kind::field) {
                const std::uint32_t bit = std::uint32_t{1} << event.field.field;
                read_ |= bit & of_kind_;
                if ((bit & of_kind_) != 0)
                    of_query[static_cast<std::size_t>(event.access.side)][event.field.element] |= bit;
            }
            if (event.kind != FieldEvent::Kind::query_end) continue;
            ++queries;
            for (auto& of_table : of_query) {
                TableReads& reads = reads_.emplace_back();
                for (const auto& [element, fields] : of_table) reads.push_back({element, fields});
                of_table.clear();
            }
        }
    }

    std::uint64_t new_lines(const GroupRecord& record, const RecordRead& read, std::uint32_t stamp) {
        std::uint64_t lines = 0;
        const std::uint64_t at = std::uint64_t{read.element} * record.size.bytes;
        for (std::size_t i = 0; i < record.count; ++i) {
            if ((read.fields >> record.fields[i] & 1) == 0) continue;
            const std::uint64_t first = at + record.offset[i];
            const std::uint64_t last = first + sized_[record.fields[i]].bytes - 1;
            for (auto line = first / measure::cache_line; line <= last / measure::cache_line; ++line)
                if (std::exchange(seen_[line], stamp) != stamp) ++lines;
        }
        return lines;
    }

    const std::vector<RecordField>& sized_;
    std::uint32_t of_kind_ = 0, read_ = 0, records_ = 0;
    std::vector<TableReads> reads_;
    std::vector<std::uint32_t> seen_;  ///< by line: its last reader
};

/// Returns the fields with a bit in the set, by place in the list.
Fields members(const Fields& fields, std::uint32_t set) {
    Fields chosen;
    for (std::size_t i = 0; i < fields.size(); ++i)
        if ((set >> i & 1) != 0) chosen.push_back(fields[i]);
    return chosen;
}

/// Returns the partition of `fields` with the lowest cost.
std::vector<Fields> best_parts(KindReads& reads, const Fields& fields) {
    const std::uint32_t sets = std::uint32_t{1} << fields.size();
    std::vector<GroupCost> alone(sets), best(sets);
    std::vector<std::uint32_t> first_part(sets);
    for (std::uint32_t set = 1; set < sets; ++set) {
        alone[set] = reads.cost(members(fields, set));
        best[set] = alone[set];
        first_part[set] = set;
        const std::uint32_t lowest = set & -set, others = set & ~lowest;
        // For each partition in two, the part with the lowest field: a proper subset of the other fields
        // plus it.
        for (std::uint32_t with = others; with != 0;) {
            with = (with - 1) & others;
            const std::uint32_t part = with | lowest;
            const GroupCost cost = alone[part] + best[set & ~part];
            if (cost < best[set]) {
                best[set] = cost;
                first_part[set] = part;
            }
        }
    }
    std::vector<Fields> parts;
    for (std::uint32_t left = sets - 1; left != 0; left &= ~first_part[left])
        parts.push_back(members(fields, first_part[left]));
    return parts;
}

/// Exchanges two fields as long as that saves lines.
void order_fields(KindReads& reads, Fields& group) {
    GroupCost cost = reads.cost(group);
    for (bool better = true; better;) {
        better = false;
        for (std::size_t i = 0; i < group.size(); ++i)
            for (std::size_t k = i + 1; k < group.size(); ++k) {
                std::swap(group[i], group[k]);
                const GroupCost exchanged = reads.cost(group);
                if (exchanged < cost) {
                    cost = exchanged;
                    better = true;
                } else {
                    std::swap(group[i], group[k]);
                }
            }
    }
}

void add_kind(const FieldTrace& trace, const Fields& of_kind, FieldGroups& groups) {
    KindReads reads(trace, of_kind);
    Fields read, unread;
    for (const std::uint8_t field : of_kind)
        ((reads.read() >> field & 1) != 0 ? read : unread).push_back(field);
    if (!read.empty()) {
        for (Fields& part : best_parts(reads, read)) {
            order_fields(reads, part);
            groups.add(part);
        }
    }
    groups.add(unread);
}

/// Returns the fields by kind of record, in the order of their numbers.
std::vector<Fields> kinds_of(const std::vector<RecordField>& fields) {
    std::vector<Fields> kinds;
    std::map<std::string_view, std::size_t> places;
    for (std::uint8_t field = 0; field < fields.size(); ++field) {
        const auto [place, is_new] = places.emplace(fields[field].record, kinds.size());
        if (is_new) kinds.emplace_back();
        kinds[place->second].push_back(field);
    }
    return kinds;
}

}  // namespace

FieldGroups best_groups(const FieldTrace& trace) {
    FieldGroups groups;
    for (const Fields& of_kind : kinds_of(trace.fields())) add_kind(trace, of_kind, groups);
    return groups;
}

std::optional<FieldGroups> groups_of(const FieldMap& map) {
    struct Column {
        std::uint64_t at = 0, next = 0;
        std::uint8_t field = 0;
        [[nodiscard]] std::uint64_t stride() const { return next - at; }
    };
    std::vector<Column> columns(map.fields.size());
    std::vector<bool> held(map.fields.size());
    for (const FieldPlace& place : map.places) {
        if (place.part > 0) return std::nullopt;
        Column& column = columns[place.field];
        column.field = place.field;
        held[place.field] = true;
        if (place.element < 2) (place.element == 0 ? column.at : column.next) = place.at;
    }
    std::erase_if(columns, [&](const Column& column) { return column.next == 0; });
    std::sort(columns.begin(), columns.end(), [](const Column& a, const Column& b) { return a.at < b.at; });
    FieldGroups groups;
    for (std::size_t first = 0; first < columns.size();) {
        Fields group;
        std::size_t last = first;
        for (; last < columns.size(); ++last) {
            const bool same = columns[last].stride() == columns[first].stride() &&
                              columns[last].at < columns[first].at + columns[first].stride();
            if (!same) break;
            group.push_back(columns[last].field);
        }
        groups.add(group);
        first = last;
    }
    for (std::uint8_t field = 0; field < held.size(); ++field)
        if (const std::uint8_t alone[] = {field}; !held[field]) groups.add(alone);
    return groups;
}

namespace {

using Names = std::vector<std::vector<std::string>>;

Names read_names(const std::string& file) {
    const auto json = input::parse_json(input::read_file_text(file).or_throw());
    std::string problem = json.error;
    try {
        if (json) {
            Names names = json->at("groups").get<Names>();
            problem = input::unknown_member(*json, "a file of groups", {"groups"});
            if (problem.empty()) return names;
        }
    } catch (const nlohmann::json::exception& wrong) {
        problem = wrong.what();
    }
    throw std::invalid_argument(fmt::format(
        R"({}: {}; wanted: {{"groups": [["tail_plane", "head_plane"], ["direction"]]}})", file, problem));
}

}  // namespace

nlohmann::json groups_json(const FieldGroups& groups, std::span<const RecordField> fields) {
    Names names;
    groups.for_each([&](std::span<const std::uint8_t> group) {
        names.emplace_back();
        for (const std::uint8_t field : group) names.back().emplace_back(fields[field].name);
    });
    return names;
}

FieldGroups read_groups(const std::string& file, std::span<const RecordField> fields) {
    FieldGroups groups;
    std::vector<int> named(fields.size());
    std::vector<std::string> known;
    for (const RecordField& field : fields) known.emplace_back(field.name);
    for (const std::vector<std::string>& names : read_names(file)) {
        std::vector<std::uint8_t> group;
        for (const std::string& name : names) {
            const auto found = std::find_if(fields.begin(), fields.end(),
                                            [&](const RecordField& field) { return field.name == name; });
            if (found == fields.end())
                throw std::invalid_argument(fmt::format("{}: {}", file, unknown_name("field", name, known)));
            const auto number = static_cast<std::size_t>(found - fields.begin());
            if (++named[number] > 1)
                throw std::invalid_argument(fmt::format("{}: '{}' is named twice", file, name));
            group.push_back(static_cast<std::uint8_t>(number));
            const RecordField& first = fields[group.front()];
            if (first.record != found->record)
                throw std::invalid_argument(fmt::format("{}: '{}' is of a {}, '{}' of a {}: not one record",
                                                        file, name, found->record, first.name, first.record));
        }
        groups.add(group);
    }
    for (std::size_t i = 0; i < fields.size(); ++i)
        if (named[i] == 0)
            throw std::invalid_argument(fmt::format("{}: field '{}' is in no group; name every one of: {}",
                                                    file, known[i], fmt::join(known, ", ")));
    return groups;
}

}  // namespace edgewise::studies
