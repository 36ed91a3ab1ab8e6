// SPDX-License-Identifier: MIT
//
// Callgrind, an independent simulator of two levels of caches and of a branch predictor: its command line for
// a given geometry, and readers of its output ("Callgrind Format Specification", Valgrind's technical
// documentation). No processor has its predictor: two-bit counters by address and recent history, and the
// last target of an indirect jump.
//
// With `--dump-instr=yes` the output has the cost of each instruction by itself, and of the calls from it
// with all that they called. addr2line (Debian: binutils) says which functions an instruction belongs to, in
// a program with line tables (-g1): the function it was written in, the one that was inlined into, and so on
// out to the function that has a symbol.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

struct CallgrindCounts {
    double instructions = 0, accesses = 0, d1_misses = 0, ll_misses = 0;
    /// Modelled mispredictions of conditional and indirect branches; no value if no branches were simulated.
    std::optional<double> mispredictions = {};
};

/// The machine's first two levels as Callgrind simulates them: LRU, an access across lines counted once.
/// Refused if the machine has one level only, or a number of sets that is no power of two.
[[nodiscard]] Expected<CacheGeometry> callgrind_geometry(const CacheMachine& machine);

/// The command line. Nothing is collected before the program toggles collection (cli/command_crosscheck.cpp).
[[nodiscard]] std::vector<std::string> callgrind_command(const CacheGeometry& geometry,
                                                         const std::filesystem::path& output,
                                                         const std::vector<std::string>& program);

/// Counts of the whole run, from the text of the output file. Refused if an event is missing.
[[nodiscard]] Expected<CallgrindCounts> parse_callgrind(const std::string& text);

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

/// Costs line by line. Refused if the output has no addresses, lacks an event or its total, or has a line
/// that cannot be read.
[[nodiscard]] Expected<CallgrindLines> parse_callgrind_lines(std::istream& output);

/// A function that an instruction belongs to.
struct InlineFrame {
    std::string function;  ///< its name alone, without scope, template arguments, parameters
    std::string file;      ///< as the compiler was given it; "??" where the program has no line tables
};

/// Frames by address, each from the innermost frame outwards.
using InlineFrames = std::map<std::uint64_t, std::vector<InlineFrame>>;

/// The name alone: "step" for "edgewise::Step edgewise::step<T<int>, U>(Body&) const".
[[nodiscard]] std::string plain_function_name(const std::string& demangled);

/// Frames from the text that `addr2line -a -i -f -C` prints.
[[nodiscard]] InlineFrames parse_inline_frames(const std::string& printed);

/// Inlined functions at addresses in the program's file. Refused if there is no addr2line, or it fails.
[[nodiscard]] Expected<InlineFrames> inline_frames(const std::string& program,
                                                   const std::vector<std::uint64_t>& addresses);

}  // namespace edgewise::measure
