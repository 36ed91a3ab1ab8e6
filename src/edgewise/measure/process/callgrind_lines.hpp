// SPDX-License-Identifier: MIT
//
// What Callgrind's output says instruction by instruction (`--dump-instr=yes`): what each cost by itself, and
// what the calls from it cost with all that they called. "Callgrind Format Specification", Valgrind's
// technical documentation; names and positions are compressed there as we read them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <map>
#include <string>
#include <vector>

#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

/// Callgrind's events of instructions, branches and the first level; whole numbers.
struct InstructionCost {
    std::uint64_t instructions = 0, mispredictions = 0, d1_misses = 0;

    [[nodiscard]] bool operator==(const InstructionCost&) const = default;
    InstructionCost& operator+=(const InstructionCost& other);
};

/// Cost of one line of the output. `function` and `object` are numbers of names.
struct CallgrindLine {
    std::uint64_t address = 0;  ///< in the object's file, as addr2line takes it
    std::size_t function = 0, object = 0;
    InstructionCost cost;
};

/// Calls from one address to one function, with all that they cost in the end.
struct CallgrindCall {
    CallgrindLine from;      ///< its cost: inclusive
    std::size_t callee = 0;  ///< a function
};

struct CallgrindLines {
    std::vector<CallgrindLine> lines;  ///< what instructions cost by themselves
    std::vector<CallgrindCall> calls;
    std::vector<std::string> functions, objects;  ///< names, by number
    InstructionCost total;                        ///< as the output's last line has it, not added up
};

/// Unknown: it has no addresses, lacks an event or its total, or a line cannot be read.
[[nodiscard]] Expected<CallgrindLines> parse_callgrind_lines(std::istream& output);

// Which functions of the source an instruction belongs to: the one it was written in, the one that was
// inlined into, and so on out to the function that has a symbol. Asked of addr2line (Debian: binutils), of a
// program with line tables (-g1).

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

/// Inlined functions at addresses in the program's file. Unknown: there is no addr2line, or it fails.
[[nodiscard]] Expected<InlineFrames> inline_frames(const std::string& program,
                                                   const std::vector<std::uint64_t>& addresses);

}  // namespace edgewise::measure
