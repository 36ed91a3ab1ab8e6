// SPDX-License-Identifier: MIT
//
// What a probe is given to measure: a cell at work. The tables are loaded and the answers checked; whatever
// else a probe wants to know it finds out itself, by asking the runner.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <typeindex>

#include "edgewise/bench/registry.hpp"
#include "edgewise/bench/runner.hpp"
#include "edgewise/bench/trace/cache_order.hpp"
#include "edgewise/measure/checked_answer.hpp"
#include "edgewise/measure/round.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

/// Results that several probes of one cell need, each made once, by the first that asks.
class SharedResults {
  public:
    template <class Value, class Make>
    [[nodiscard]] const Value& get(const Make& make) const {
        std::shared_ptr<const void>& known = known_[typeid(Value)];
        if (!known) known = std::make_shared<const Value>(make());
        return *static_cast<const Value*>(known.get());
    }

  private:
    mutable std::map<std::type_index, std::shared_ptr<const void>> known_;
};

struct ProbedCell {
    const TableType& type;
    const AlgorithmInfo& algorithm;
    const Runner& runner;  ///< with the workload loaded
    const scene::Workload& workload;
    bool plain = true;                                     ///< without further axes
    bool verified = true;                                  ///< else a checked answer is wrong
    std::span<const std::size_t> checked_positions = {};   ///< of the queries that were checked
    std::span<const measure::CheckedAnswer> checked = {};  ///< in that order
    measure::AnswerCounts counts = {};                     ///< of all answers
    std::span<const measure::Round> rounds = {};           ///< timed so far
    CacheOrder caches = {};                                ///< what is to be modelled
    SharedResults shared = {};
};

}  // namespace edgewise::bench
