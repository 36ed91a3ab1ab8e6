// SPDX-License-Identifier: MIT
//
// The bytes of tables as plain numbers for the `bytes` probe: of one body, and over a family of growing
// triangulated spheres, from which slopes per additional edge are measured.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "edgewise/measure/probe.hpp"
#include "edgewise/bench/registry.hpp"

namespace edgewise {

[[nodiscard]] TableBytes table_bytes(const Ledger& ledger, const Polyhedron& body);

/// Tables are really built, once for each table type and parts, and kept as numbers.
class SizeFamily {
  public:
    SizeFamily();
    [[nodiscard]] const std::vector<TableBytes>& of(const TableType& type, Parts parts);

  private:
    std::vector<Polyhedron> bodies_;
    std::map<std::pair<std::string, Parts>, std::vector<TableBytes>> known_;
};

}  // namespace edgewise
