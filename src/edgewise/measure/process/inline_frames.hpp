// SPDX-License-Identifier: MIT
//
// Which functions of the source an instruction belongs to: the one it was written in, the one that was
// inlined into, and so on out to the function that has a symbol. Asked of addr2line (Debian: binutils), of a
// program with line tables (-g1).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

struct InlineFrame {
    std::string function;  ///< its name alone, without scope, template arguments, parameters
    std::string file;      ///< as the compiler was given it; "??" where the program has no line tables
};

/// By address, each from the innermost frame outwards.
using InlineFrames = std::map<std::uint64_t, std::vector<InlineFrame>>;

/// "edgewise::Step edgewise::step<T<int>, U>(Body&) const" is "step".
[[nodiscard]] std::string plain_function_name(const std::string& demangled);

/// What `addr2line -a -i -f -C` prints.
[[nodiscard]] InlineFrames parse_inline_frames(const std::string& printed);

/// Of addresses in the program's file. Unknown: there is no addr2line, or it fails.
[[nodiscard]] Expected<InlineFrames> inline_frames(const std::string& program,
                                                   const std::vector<std::uint64_t>& addresses);

}  // namespace edgewise::measure
