// SPDX-License-Identifier: MIT
//
// What queries read and write, access by access, as a stream: nothing is kept but what a listener keeps.
// Addresses are relative to where the tables' memory starts, so that a trace is the same on every machine and
// in every run; the caches of pairs follow behind the tables.
#pragma once

#include <cstdint>

#include "edgewise/measure/cache_model.hpp"

namespace edgewise {

struct TracedAccess {
    std::uint64_t address;  ///< bytes from the start of the tables' memory
    std::uint32_t bytes;
    AccessKind kind;
    std::uint8_t field, step;  ///< numbers whose names the tracer knows
    std::uint8_t side;         ///< 0: body A, 1: body B
};

class TraceListener {
  public:
    TraceListener() = default;
    TraceListener(const TraceListener&) = delete;
    TraceListener& operator=(const TraceListener&) = delete;
    virtual ~TraceListener() = default;

    virtual void on_access(const TracedAccess& access) = 0;
    /// After each query; `counts` is false for the cold first query of a pair in a warm scene.
    virtual void on_query_end(bool counts) = 0;
};

}  // namespace edgewise
