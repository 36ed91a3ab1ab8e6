// SPDX-License-Identifier: MIT
//
// What Callgrind's output says instruction by instruction (`--dump-instr=yes`): what each cost by itself, and
// what the calls from it cost with all that they called. "Callgrind Format Specification", Valgrind's
// technical documentation; names and positions are compressed there as we read them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

/// Of the events that Callgrind counts, those of instructions, branches and the first level; whole numbers.
struct InstructionCost {
    std::uint64_t instructions = 0, mispredictions = 0, d1_misses = 0;

    [[nodiscard]] bool operator==(const InstructionCost&) const = default;
    InstructionCost& operator+=(const InstructionCost& other);
};

/// Cost of one line of the output. `function` and `object` number the names beside it.
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

}  // namespace edgewise::measure
