// SPDX-License-Identifier: MIT
#include "edgewise/studies/phases/phases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace edgewise::studies {

namespace {

/// A rule of phases.json.
struct Rule {
    std::string place, function, phase;
    std::optional<Recurrence> recurrence;
};

std::vector<Rule> read_rules() {
    std::vector<Rule> rules;
    for (const auto& row : nlohmann::json::parse(phase_texts)) {
        rules.push_back({row.value("place", ""), row.value("function", ""), row.value("phase", ""), {}});
        if (row.contains("runs"))
            rules.back().recurrence = row["runs"] == "step" ? Recurrence::step : Recurrence::once;
    }
    return rules;
}

/// Returns the path within src/edgewise; nothing for other files, because they have no phase.
std::optional<std::string_view> own_file(std::string_view file) {
    constexpr std::string_view root = "src/edgewise/";
    const std::size_t at = file.rfind(root);
    return at == std::string_view::npos ? std::nullopt : std::optional(file.substr(at + root.size()));
}

const Rule* rule_of(std::string_view file, std::string_view function) {
    static const std::vector<Rule> rules = read_rules();
    for (const Rule& rule : rules) {
        const bool is_folder = rule.place.empty() || rule.place.ends_with('/');
        const bool here = is_folder ? file.starts_with(rule.place) : file == rule.place;
        if (here && (rule.function.empty() || rule.function == function)) return &rule;
    }
    return nullptr;
}

}  // namespace

PhaseOfFrames phase_of(const std::vector<measure::InlineFrame>& frames) {
    PhaseOfFrames found;
    for (const measure::InlineFrame& frame : frames) {
        const auto file = own_file(frame.file);
        if (!file && frame.file.starts_with("/")) continue;
        const Rule* rule = file ? rule_of(*file, frame.function) : nullptr;
        if (!rule) {
            if (found.phase) continue;
            found.phase = other_phase;
            found.place = file ? std::string(*file) : frame.function + ", without a line table";
            continue;
        }
        if (!found.phase && !rule->phase.empty()) found.phase = rule->phase;
        if (!found.recurrence) found.recurrence = rule->recurrence;
    }
    return found;
}

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
    /// Answer for a function, derived from its calls.
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

    /// Returns the answer for a function; calls of the function by itself do not count.
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

/// One run of `passes` passes, and its phases.
struct CountedRun {
    measure::InstructionCost total;
    PhaseCounts counts;
    std::size_t code_bytes;
};

/// Bytes of the lines with these addresses, given in order.
std::size_t bytes_of_lines(const std::vector<std::uint64_t>& addresses) {
    constexpr std::uint64_t line = 64;
    std::size_t lines = 0;
    for (std::size_t i = 0; i < addresses.size(); ++i)
        lines += i == 0 || addresses[i] / line != addresses[i - 1] / line;
    return lines * line;
}

measure::Expected<CountedRun> counted_run(const CellChoice& choice, const measure::CacheGeometry& geometry,
                                          const std::string& program, int passes) {
    const auto lines = callgrind_lines(choice, geometry, program, passes);
    if (!lines.value) return lines.refusal();
    const std::vector<std::uint64_t> addresses = addresses_in(*lines.value, program);
    if (addresses.empty())
        return measure::Refusal{"Callgrind names no instruction of " + program,
                                "call it by the path of its file, not by a link"};
    const auto frames = measure::inline_frames(program, addresses);
    if (!frames.value) return frames.refusal();
    return {CountedRun{lines.value->total, divide_by_phase(*lines.value, *frames.value, program),
                       bytes_of_lines(addresses)}};
}

std::vector<std::string> most_of(const std::map<std::string, std::uint64_t>& others) {
    std::vector<std::pair<std::uint64_t, std::string>> places;
    for (const auto& [place, instructions] : others) places.emplace_back(instructions, place);
    std::sort(places.rbegin(), places.rend());
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min<std::size_t>(places.size(), 3); ++i)
        names.push_back(places[i].second);
    return names;
}

PhaseEffort per_query(const std::string& phase, const PhaseCost& few, const PhaseCost& many, double passed) {
    const auto each = [&](auto of_few, auto of_many) {
        return (static_cast<double>(of_many) - static_cast<double>(of_few)) / passed;
    };
    return {phase, each(few.cost.instructions, many.cost.instructions),
            each(few.cost.mispredictions, many.cost.mispredictions),
            each(few.cost.d1_misses, many.cost.d1_misses), each(few.in_steps, many.in_steps)};
}

void count(const CellChoice& choice, const Effort& effort, const measure::CacheGeometry& geometry,
           const std::string& program, EffortByPhase& row) {
    row.reason = check_program(choice, effort, program);
    row.remedy = "build edgewise_sim with EDGEWISE_SIM_LAYOUTS naming the table type";
    if (!row.reason.empty()) return;
    const auto few = counted_run(choice, geometry, program, few_passes);
    const auto many = few.value ? counted_run(choice, geometry, program, many_passes) : few;
    if (!many.value) {
        row.reason = many.reason;
        row.remedy = many.remedy;
        return;
    }
    if (const std::string off = check_sum(few.value->counts, few.value->total); !off.empty()) row.wrong = off;
    if (const std::string off = check_sum(many.value->counts, many.value->total); !off.empty())
        row.wrong = off;
    const auto queries = static_cast<double>(effort.passed.queries);
    constexpr int passes = many_passes - few_passes;
    row.code_bytes = few.value->code_bytes;
    row.phases = phases_per_query(few.value->counts, many.value->counts, passes, queries);
    row.others = most_of(many.value->counts.others);
    row.total = per_query("total", {few.value->total}, {many.value->total}, passes * queries);
    for (const PhaseEffort& phase : row.phases)
        row.total.instructions_in_steps += phase.instructions_in_steps;
}

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

std::vector<PhaseEffort> phases_per_query(const PhaseCounts& few, const PhaseCounts& many, int passes,
                                          double queries) {
    std::vector<PhaseEffort> phases;
    std::map<std::string, PhaseCost> all = few.phases;
    all.insert(many.phases.begin(), many.phases.end());
    for (const auto& [phase, ignored] : all) {
        const auto find = [&name = phase](const PhaseCounts& in) {
            const auto found = in.phases.find(name);
            return found == in.phases.end() ? PhaseCost{} : found->second;
        };
        phases.push_back(per_query(phase, find(few), find(many), passes * queries));
    }
    std::ranges::stable_sort(phases, std::greater{}, &PhaseEffort::instructions);
    return phases;
}

std::vector<EffortByPhase> effort_by_phase(const EffortPlan& plan) {
    const auto geometry = geometry_of(plan.machine);
    const auto program = program_for_valgrind();
    std::vector<EffortByPhase> rows;
    for (const EffortContender& contender : contenders(plan)) {
        if (contender.type->is_peer) continue;
        EffortByPhase& row = rows.emplace_back();
        row.table = contender.type->name;
        row.algorithm = contender.choice.algorithm;
        Effort effort;
        try {
            effort = examine(contender.choice);
        } catch (const std::invalid_argument& problem) {  // a table that does not hold the body
            row.reason = problem.what();
            continue;
        }
        row.wrong = effort.wrong;
        row.steps = effort.steps.value.value_or(0);
        if (geometry.value && program.value) {
            count(contender.choice, effort, *geometry.value, *program.value, row);
        } else {
            row.reason = geometry.value ? program.reason : geometry.reason;
            row.remedy = geometry.value ? program.remedy : geometry.remedy;
        }
    }
    return rows;
}

}  // namespace edgewise::studies
