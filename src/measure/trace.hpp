// SPDX-License-Identifier: MIT
//
// What queries read and write, access by access, as a stream: nothing is kept but what a listener keeps.
// Addresses are relative to where the tables' memory starts, so that a trace is the same on every machine and
// in every run; the caches of pairs follow behind the tables.
#pragma once

#include <cstddef>
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

/// Where a traced loader tells what it reads.
class TraceSink {
  public:
    TraceSink(TraceListener& listener, std::uint8_t side) : listener_(&listener), side_(side) {}

    void start_at(const void* base) { base_ = reinterpret_cast<std::uintptr_t>(base); }
    void set_step(std::uint8_t step) { step_ = step; }

    template <class Field>
    void read(const void* address, std::size_t bytes, Field field) {
        note(reinterpret_cast<std::uintptr_t>(address) - base_, bytes, AccessKind::read,
             static_cast<std::uint8_t>(field));
    }
    /// Not to be inlined: query loops call it at every read.
    [[gnu::noinline]] void note(std::uint64_t address, std::size_t bytes, AccessKind kind,
                                std::uint8_t field) {
        listener_->on_access({address, static_cast<std::uint32_t>(bytes), kind, field, step_, side_});
    }

  private:
    TraceListener* listener_;
    std::uintptr_t base_ = 0;
    std::uint8_t step_ = 0, side_;
};

}  // namespace edgewise
