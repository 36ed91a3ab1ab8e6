// SPDX-License-Identifier: MIT
//
// The dependency rule, read off the real #include lines: which room may include which. Rooms are the folders
// below src/, and layouts/, probes/, reports/. What a room may include, all above that room may include as
// well. Only generated units, which are no files of the tree, may include layouts/ and probes/: nothing else
// names a layout.
#pragma once

#include <vector>

#include "source_tree.hpp"

namespace edgewise::house {

/// Includes between rooms that the rule does not allow, and includes of our own files that are not written as
/// "edgewise/<room>/<file>".
[[nodiscard]] std::vector<Violation> forbidden_includes(const std::vector<SourceFile>& files);

/// One violation per cycle of headers, at the include that closes it.
[[nodiscard]] std::vector<Violation> include_cycles(const std::vector<SourceFile>& files);

}  // namespace edgewise::house
