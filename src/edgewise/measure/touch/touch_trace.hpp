// SPDX-License-Identifier: MIT
//
// Reads and writes of a user's own structure by queries: the user says where each query begins and touches
// what it reads, by plain calls or through a loader. The trace is kept in memory, 16 bytes per access, so
// that a cache model can go over it as often as it likes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ranges>
#include <string>
#include <vector>

#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

/// So many bytes of an element serve this member.
struct Member {
    std::string name;
    std::size_t bytes;
};

/// Bytes of a component of a structure, such as "nodes.children".
struct ComponentBytes {
    std::string component;
    std::uint64_t bytes;
};

/// A user's own structure, as a trace of it needs it: which arrays it has and what each element's bytes are
/// for. Addresses become places that are the same in every run: arrays follow each other in the order in
/// which they were added, each from the start of a cache line, as an aligned allocation has it. Where an
/// array really begins within a line is the allocator's chance and no layout's.
class Structure {
  public:
    /// Its elements must stay where they are as long as they are traced: add arrays when they are built. What
    /// no member takes of an element is its padding. An array may be added in parts of one name.
    template <std::ranges::contiguous_range Array>
    void add_array(const std::string& name, const Array& elements, const std::vector<Member>& members) {
        add_memory(name, std::ranges::data(elements), std::ranges::size(elements),
                   sizeof(std::ranges::range_value_t<Array>), members);
    }

    /// `count` elements, `stride` bytes apart, placed at a multiple of `alignment`, a power of two: a line
    /// for what is allocated as a whole, less for nodes that are allocated one by one.
    void add_memory(const std::string& name, const void* at, std::size_t count, std::size_t stride,
                    const std::vector<Member>& members, std::size_t alignment = 64);

    /// Where these bytes lie; nothing: no array has them all.
    [[nodiscard]] std::optional<std::uint64_t> place_of(const void* address, std::size_t bytes) const;

    /// Bytes of every member and of every array's padding, in the order in which they were added.
    [[nodiscard]] const std::vector<ComponentBytes>& bytes() const { return bytes_; }

    /// The fault in what was added; empty if there is none.
    [[nodiscard]] const std::string& problem() const { return problem_; }

  private:
    struct Stretch {
        std::uintptr_t from, to;  ///< past its end
        std::uint64_t place;
        std::string name;
    };

    void book(const std::string& component, std::uint64_t bytes);
    void put(const Stretch& stretch);
    void refuse(const std::string& problem) {
        if (problem_.empty()) problem_ = problem;
    }

    std::vector<Stretch> stretches_;  ///< by address
    std::vector<ComponentBytes> bytes_;
    std::uint64_t next_ = 0;
    std::string problem_;
};

class TouchTrace {
  public:
    /// fields: their names by number, 256 at most. Arrays must have been added to the structure before.
    TouchTrace(Structure structure, std::vector<std::string> fields);

    /// Ends the current query and starts one: warm if it starts from an earlier answer, else cold.
    void start_query(QueryStart start = QueryStart::cold);
    /// Ends the current query. Accesses from here to the next query belong to no query.
    void end_query();

    /// A read. Field: a number or an enumerator.
    template <class Field>
    void touch(const void* address, std::size_t bytes, Field field) {
        note(address, bytes, AccessKind::read, static_cast<std::size_t>(field));
    }
    template <class Field>
    void write(const void* address, std::size_t bytes, Field field) {
        note(address, bytes, AccessKind::write, static_cast<std::size_t>(field));
    }

    /// Tells all of it again, in order.
    void replay(TraceListener& listener) const;

    [[nodiscard]] const Structure& structure() const { return structure_; }
    [[nodiscard]] const std::vector<std::string>& fields() const { return fields_; }

    /// Why this trace says nothing that is the same in every run: the first touch that no array holds or
    /// that has a field without a name, or what is wrong with the structure; empty: it does.
    [[nodiscard]] const std::string& problem() const { return problem_; }

  private:
    /// Accesses first .. last - 1.
    struct Query {
        std::size_t first, last;
        QueryStart start;
    };

    void note(const void* address, std::size_t bytes, AccessKind kind, std::size_t field);
    void refuse(std::size_t bytes, std::size_t field);

    Structure structure_;
    std::vector<std::string> fields_;
    std::vector<TracedAccess> accesses_;
    std::vector<Query> queries_;
    bool in_query_ = false;
    std::string problem_;
};

/// Loaders for a user's code that reads every member through one: PlainReads for timing, which cost
/// nothing, and TouchReads for tracing.
struct PlainReads {
    template <class Value, class Field>
    const Value& load(const Value& location, Field) const {
        return location;
    }
};

class TouchReads {
  public:
    /// The trace must outlive this.
    explicit TouchReads(TouchTrace& trace) : trace_(&trace) {}

    /// Returns the value and records the read in the trace.
    template <class Value, class Field>
    const Value& load(const Value& location, Field field) const {
        // Where nodes hold pointers, a pointer is what is read. NOLINTNEXTLINE(bugprone-sizeof-expression)
        trace_->touch(&location, sizeof(Value), field);
        return location;
    }

  private:
    TouchTrace* trace_;
};

}  // namespace edgewise::measure
