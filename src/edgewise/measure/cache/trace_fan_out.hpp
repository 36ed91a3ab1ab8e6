// SPDX-License-Identifier: MIT
//
// Several listeners to one trace.
#pragma once

#include <initializer_list>
#include <vector>

#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

class TraceFanOut final : public TraceListener {
  public:
    TraceFanOut(std::initializer_list<TraceListener*> listeners) : listeners_(listeners) {}

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

}  // namespace edgewise::measure
