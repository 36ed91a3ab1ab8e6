// SPDX-License-Identifier: MIT
//
// The phases of a query, in the words of GJK (Gilbert, Johnson, Keerthi 1988; Cameron 1997) and V-Clip
// (Mirtich, TR-97-05), and which functions of the source belong to which. Arithmetic and helpers belong to
// the function that they are inlined into: a dot product in a climb is the climb's, in a state the state's.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/process/callgrind.hpp"
#include "edgewise/studies/effort/effort.hpp"

namespace edgewise::studies {

/// Phase of code that no rule knows: our source files that are not in the table, or without line tables.
inline constexpr std::string_view other_phase = "other";

/// The text of phases.json: rules, of which the first that fits counts. `place`: a file of src/edgewise, or
/// all of a folder; `function`: its plain name (`operator`: a lambda's), else any. No `phase`: that of
/// whoever the code is inlined into; no `runs`: likewise.
extern const char* const phase_texts;

/// How often code runs.
enum class Recurrence { once, step };  ///< per query, or per V-Clip state or GJK iteration

/// Phase and recurrence by the frames of one instruction; nothing if they leave it to the caller.
struct PhaseOfFrames {
    std::optional<std::string_view> phase;
    std::optional<Recurrence> recurrence;
    std::string place;  ///< of `other`: the file that is not in the table, or a function without one
};

/// Searches from the innermost frame outwards for the first with a phase, and for the first that is known
/// to run once or each step.
[[nodiscard]] PhaseOfFrames phase_of(const std::vector<measure::InlineFrame>& frames);

// The effort of one cell's queries (effort.hpp) divided by phase (phases.hpp): counted in the same region, as
// the same difference of passes, by the same Callgrind; only asked where every instruction came from.

// Callgrind's counts of some passes, divided by phase (phases.hpp). Nothing is dropped: code that no rule
// knows is `other`, so the phases add up to the run's total.
//
// If the frames of a called, not inlined, function leave a question open, its calls decide: its phase is
// that of all its callers, if they agree; it runs once or in each step in the proportion of the
// instructions that its calls of either kind cost.

/// Arithmetic in functions that several phases call, and code of the C library.
inline constexpr std::string_view arithmetic_phase = "arithmetic, shared", library_phase = "C library";

struct PhaseCost {
    measure::InstructionCost cost;
    double in_steps = 0;  ///< of the instructions
};

struct PhaseCounts {
    std::map<std::string, PhaseCost> phases;
    std::map<std::string, std::uint64_t> others;  ///< instructions of `other`, by file or function
};

/// Returns the addresses of the counted instructions of this object, each once.
[[nodiscard]] std::vector<std::uint64_t> addresses_in(const measure::CallgrindLines& lines,
                                                      const std::string& object);

/// `program`: the object that the frames are of; all other objects are libraries.
[[nodiscard]] PhaseCounts divide_by_phase(const measure::CallgrindLines& lines,
                                          const measure::InlineFrames& frames, const std::string& program);

/// Returns "", or how the phases' sum differs from the run's own total.
[[nodiscard]] std::string check_sum(const PhaseCounts& counts, const measure::InstructionCost& total);

/// Means per query over all queries of the scene.
struct PhaseEffort {
    std::string phase;
    double instructions = 0, mispredictions = 0, d1_misses = 0;
    double instructions_in_steps = 0;  ///< the others: once a query
};

struct EffortByPhase {
    std::string table, algorithm;
    std::string wrong;                ///< of checked answers, or of the phases' sum; empty: nothing
    std::string reason, remedy;       ///< why there are no phases
    double steps = 0;                 ///< V-Clip states or GJK iterations per query
    std::size_t code_bytes = 0;       ///< of the lines of 64 bytes with an instruction that the queries ran
    std::vector<PhaseEffort> phases;  ///< those that take most instructions first; empty: `reason`
    std::vector<std::string> others;  ///< the files and functions that take most of `other`, up to three
    PhaseEffort total;                ///< as Callgrind counts it, not added up; its `in_steps` is the sum
};

/// Returns one pass of two runs' phases: `many` less `few`, divided by the difference in passes and by the
/// queries.
[[nodiscard]] std::vector<PhaseEffort> phases_per_query(const PhaseCounts& few, const PhaseCounts& many,
                                                        int passes, double queries);

/// Counts the plan's own table types in its order, without its peers. Throws like `examine`.
[[nodiscard]] std::vector<EffortByPhase> effort_by_phase(const EffortPlan& plan);

}  // namespace edgewise::studies
