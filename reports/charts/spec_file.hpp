// SPDX-License-Identifier: MIT
//
// Chart specifications as files. A *.vl.json file holds all of a chart but its data: title, how to read it,
// and a Vega-Lite specification in which "$name" is replaced by a value: a slot that the code fills, a part
// of the same file, or a part that all charts share (shared.vl.json). A slot's value is data and is never
// read as a name.
//
//   "$name"                    the value of that name; "$absent" leaves its member out
//   "$*name"      in a list    each item of that value
//   {"$let": {...}, ...}       these parts are known inside
//   {"$with": "$name", ...}    the members of that value, then these in their place
// in a list: one item for each of that list; the item's members are slots in it
#pragma once

#include <string>

#include "edgewise/reports/charts/charts.hpp"

namespace edgewise::reports {

/// The parsed file NAME.vl.json.
[[nodiscard]] ChartJson spec_file(const std::string& name);

/// The specification of a chart file, filled; throws std::out_of_range at a name that nothing has.
[[nodiscard]] ChartJson fill_spec(const ChartJson& file, const ChartJson& slots);

}  // namespace edgewise::reports
