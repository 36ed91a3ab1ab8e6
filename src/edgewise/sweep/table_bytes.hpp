// SPDX-License-Identifier: MIT
//
// The bytes of tables as plain numbers for the `bytes` probe: of one body, and over a family of growing
// triangulated spheres, from which slopes per additional edge are measured.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/measure/probe.hpp"

namespace edgewise::sweep {

[[nodiscard]] measure::TableBytes table_bytes(const Ledger& ledger, const Polyhedron& body);

/// Tables are really built, once for each table type and parts, and kept as numbers.
class SizeFamily {
  public:
    SizeFamily();
    [[nodiscard]] const std::vector<measure::TableBytes>& of(const bench::TableType& type, Parts parts);

  private:
    std::vector<Polyhedron> bodies_;
    std::map<std::pair<std::string, Parts>, std::vector<measure::TableBytes>> known_;
};

}  // namespace edgewise::sweep
