// SPDX-License-Identifier: MIT
//
// One cell made ready apart from any sweep: for commands that look at one closely.
#pragma once

#include <memory>
#include <string>

#include "edgewise/sweep/shared_queries.hpp"
#include "edgewise/bench/registry.hpp"

namespace edgewise {

struct CellChoice {
    std::string table = "aos_f64", algorithm = "vclip", scene = "tumble", shape = "sphere386";
    SceneParameters parameters = {};  ///< those that differ from the scene's defaults
    std::size_t queries = 1000;
    std::uint64_t seed = 1;
};

class SingleCell {
  public:
    /// Throws std::invalid_argument: what, where, what to do.
    explicit SingleCell(const CellChoice& choice, const TableOptions& placing = {});

    [[nodiscard]] const TableType& type() const { return *type_; }
    [[nodiscard]] const Workload& workload() const { return group_->workload(); }
    [[nodiscard]] const Runner& runner() const { return *runner_; }

  private:
    const TableType* type_;
    std::unique_ptr<Group> group_;
    std::unique_ptr<Runner> runner_;
};

}  // namespace edgewise
