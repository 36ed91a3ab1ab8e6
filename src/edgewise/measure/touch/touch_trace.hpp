// SPDX-License-Identifier: MIT
//
// What queries read and write of a user's own structure: he says where each query begins and touches what it
// reads, by plain calls or through a loader (touch/reads.hpp). Kept in memory, 16 bytes per access, so that a
// cache model can go over it as often as it likes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/measure/touch/structure.hpp"

namespace edgewise::measure {

class TouchTrace {
  public:
    /// fields: their names by number, 256 at most. Arrays must have been added to the structure before.
    TouchTrace(Structure structure, std::vector<std::string> fields);

    /// Ends the query at hand. A query that starts from an earlier answer starts warm; all others cold.
    void start_query(QueryStart start = QueryStart::cold);
    /// What is touched from here to the next query is no query's own.
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

}  // namespace edgewise::measure
