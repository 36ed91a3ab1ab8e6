// SPDX-License-Identifier: MIT
#include "edgewise/studies/phases/phase_counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "edgewise/studies/phases/phases.hpp"

namespace edgewise::studies {

namespace {

class Divider {
  public:
    Divider(const measure::CallgrindLines& lines, const measure::InlineFrames& frames,
            const std::string& program)
        : lines_(lines), frames_(frames), callers_(lines.functions.size()), known_(lines.functions.size()) {
        const auto at = std::find(lines.objects.begin(), lines.objects.end(), program);
        program_ = static_cast<std::size_t>(at - lines.objects.begin());
        for (const measure::CallgrindCall& call : lines.calls) callers_[call.callee].push_back(&call);
    }

    [[nodiscard]] PhaseCounts divide() {
        PhaseCounts counts;
        for (const measure::CallgrindLine& line : lines_.lines) {
            const PhaseOfFrames said = frames_of(line);
            PhaseCost& phase = counts.phases[std::string(phase_at(line, said))];
            phase.cost += line.cost;
            phase.in_steps += steps_at(line, said) * static_cast<double>(line.cost.instructions);
            if (said.phase == other_phase) counts.others[said.place] += line.cost.instructions;
        }
        return counts;
    }

  private:
    /// What its calls say of a function.
    struct Answer {
        std::string_view phase;
        double in_steps = 0;
    };

    [[nodiscard]] PhaseOfFrames frames_of(const measure::CallgrindLine& line) const {
        if (line.object != program_) return {library_phase, std::nullopt, {}};
        const auto found = frames_.find(line.address);
        if (found == frames_.end()) return {other_phase, std::nullopt, "an address that addr2line left out"};
        return phase_of(found->second);
    }

    [[nodiscard]] std::string_view phase_at(const measure::CallgrindLine& line, const PhaseOfFrames& said) {
        return said.phase ? *said.phase : answer_of(line.function).phase;
    }
    [[nodiscard]] double steps_at(const measure::CallgrindLine& line, const PhaseOfFrames& said) {
        if (said.recurrence) return *said.recurrence == Recurrence::step ? 1 : 0;
        return answer_of(line.function).in_steps;
    }

    /// Of one that calls itself, without those calls.
    [[nodiscard]] const Answer& answer_of(std::size_t function) {
        std::optional<Answer>& known = known_[function];
        if (known) return *known;
        known = Answer{arithmetic_phase, 0};
        double all = 0, in_steps = 0;
        std::vector<std::string_view> phases;
        for (const measure::CallgrindCall* call : callers_[function]) {
            if (call->from.function == function) continue;
            const PhaseOfFrames said = frames_of(call->from);
            const auto cost = static_cast<double>(call->from.cost.instructions);
            all += cost;
            in_steps += cost * steps_at(call->from, said);
            phases.push_back(phase_at(call->from, said));
        }
        const bool agree = !phases.empty() && std::count(phases.begin(), phases.end(), phases[0]) ==
                                                  static_cast<std::ptrdiff_t>(phases.size());
        known = Answer{agree ? phases[0] : arithmetic_phase, all > 0 ? in_steps / all : 0};
        return *known;
    }

    const measure::CallgrindLines& lines_;
    const measure::InlineFrames& frames_;
    std::size_t program_;
    std::vector<std::vector<const measure::CallgrindCall*>> callers_;  ///< by function
    std::vector<std::optional<Answer>> known_;
};

}  // namespace

std::vector<std::uint64_t> addresses_in(const measure::CallgrindLines& lines, const std::string& object) {
    std::vector<std::uint64_t> addresses;
    const auto add = [&](const measure::CallgrindLine& line) {
        if (lines.objects[line.object] == object) addresses.push_back(line.address);
    };
    for (const measure::CallgrindLine& line : lines.lines) add(line);
    for (const measure::CallgrindCall& call : lines.calls) add(call.from);
    std::sort(addresses.begin(), addresses.end());
    addresses.erase(std::unique(addresses.begin(), addresses.end()), addresses.end());
    return addresses;
}

PhaseCounts divide_by_phase(const measure::CallgrindLines& lines, const measure::InlineFrames& frames,
                            const std::string& program) {
    return Divider(lines, frames, program).divide();
}

std::string check_sum(const PhaseCounts& counts, const measure::InstructionCost& total) {
    measure::InstructionCost sum;
    for (const auto& [phase, counted] : counts.phases) sum += counted.cost;
    if (sum == total) return {};
    return fmt::format(
        "the phases add up to {} instructions, {} mispredictions and {} misses, Callgrind to {}, {} and {}",
        sum.instructions, sum.mispredictions, sum.d1_misses, total.instructions, total.mispredictions,
        total.d1_misses);
}

}  // namespace edgewise::studies
