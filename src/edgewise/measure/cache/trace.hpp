// SPDX-License-Identifier: MIT
//
// A stream of what queries read and write, access by access: only a listener keeps any of it.
// Addresses are relative to where the tables' memory starts, so that a trace is the same on every machine and
// in every run; the caches of pairs and the broad phase's arrays follow behind the tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "edgewise/measure/cache/by_start.hpp"

namespace edgewise::measure {

/// What an access does to memory.
enum class AccessKind : std::uint8_t { read, write };

/// Whose memory an access is to.
enum class TraceSide : std::uint8_t { table_a, table_b, scene };

struct TracedAccess {
    std::uint64_t address;  ///< bytes from the start of the tables' memory
    std::uint32_t bytes;
    AccessKind kind;
    std::uint8_t field, step;  ///< the tracer knows the names behind these numbers
    TraceSide side;

    /// Calls use(number) for each unit of unit_bytes bytes that is accessed, counted from address 0.
    template <class Use>
    void for_each_unit(std::uint64_t unit_bytes, Use use) const {
        const std::uint64_t last = (address + bytes - 1) / unit_bytes;
        for (std::uint64_t unit = address / unit_bytes; unit <= last; ++unit) use(unit);
    }
};

class TraceListener {
  public:
    TraceListener() = default;
    TraceListener(const TraceListener&) = delete;
    TraceListener& operator=(const TraceListener&) = delete;
    virtual ~TraceListener() = default;

    /// Called before each query and its accesses.
    virtual void on_query_start(QueryStart /*start*/) {}
    /// Called before each step of a query's algorithm; later accesses belong to the step. `step` has the
    /// numbers of TracedAccess.
    virtual void on_step_start(std::uint8_t /*step*/) {}
    virtual void on_access(const TracedAccess& access) = 0;
    /// Called after each query; `counts` is false for the cold first query of a pair in a warm scene.
    virtual void on_query_end(bool /*counts*/) {}
    /// Called after the last query of a frame; never called in scenes without frames.
    virtual void on_frame_end() {}
};

/// Passes one trace to several listeners.
class TraceFanOut final : public TraceListener {
  public:
    TraceFanOut(std::initializer_list<TraceListener*> listeners) : listeners_(listeners) {}

    void on_query_start(QueryStart start) override {
        for (TraceListener* listener : listeners_) listener->on_query_start(start);
    }
    void on_step_start(std::uint8_t step) override {
        for (TraceListener* listener : listeners_) listener->on_step_start(step);
    }
    void on_access(const TracedAccess& access) override {
        for (TraceListener* listener : listeners_) listener->on_access(access);
    }
    void on_query_end(bool counts) override {
        for (TraceListener* listener : listeners_) listener->on_query_end(counts);
    }
    void on_frame_end() override {
        for (TraceListener* listener : listeners_) listener->on_frame_end();
    }

  private:
    std::vector<TraceListener*> listeners_;
};

/// Receives the reads of a traced loader.
class TraceSink {
  public:
    /// base: what addresses are relative to.
    TraceSink(TraceListener& listener, TraceSide side, const void* base)
        : listener_(&listener), base_(reinterpret_cast<std::uintptr_t>(base)), side_(side) {}

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
    std::uintptr_t base_;
    std::uint8_t step_ = 0;
    TraceSide side_;
};

}  // namespace edgewise::measure
