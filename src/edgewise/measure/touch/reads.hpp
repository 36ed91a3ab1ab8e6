// SPDX-License-Identifier: MIT
//
// A user's loaders: code that reads every member through one of these is timed with the first, which costs
// nothing, and traced with the second. The tables of the algorithms have theirs in table/loader.hpp.
#pragma once

#include "edgewise/measure/touch/touch_trace.hpp"

namespace edgewise::measure {

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

    /// The same value, and the trace knows of it.
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
