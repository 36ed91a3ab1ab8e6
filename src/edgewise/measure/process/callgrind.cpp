// SPDX-License-Identifier: MIT
//
// Geometry is always given: what Callgrind reads from the processor is wrong on many (a last level of 512 MB,
// of one way). `--cache-sim` is given because its default has changed once.
#include "edgewise/measure/process/callgrind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdlib>
#include <initializer_list>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

#include "edgewise/measure/process/child_process.hpp"

namespace edgewise::measure {

namespace {

/// Returns e.g. "the event Ir" for the first needed event that the output lacks; empty if it has all.
std::string lacking(const std::vector<std::string>& events, std::initializer_list<const char*> needed) {
    for (const char* event : needed)
        if (std::ranges::find(events, event) == events.end()) return std::string("the event ") + event;
    return {};
}

using Numbers = std::map<std::string, std::size_t>;

/// Number of a name: "(3) name" the first time, "(3)" from then on; a name without a number is its own.
std::size_t number_of(const std::string& text, Numbers& numbers, std::vector<std::string>& names) {
    const std::size_t end = text.empty() || text[0] != '(' ? std::string::npos : text.find(')');
    const std::string key = end == std::string::npos ? text : text.substr(0, end + 1);
    const auto [found, is_new] = numbers.try_emplace(key, names.size());
    if (is_new) names.push_back(key == text ? text : text.substr(std::min(end + 2, text.size())));
    return found->second;
}

/// An address: "0x1f", or "+3", "-3", "*" from the one before; nothing if it is none.
std::optional<std::uint64_t> address_of(const std::string& word, std::uint64_t before) {
    if (word == "*") return before;
    const bool relative = !word.empty() && (word[0] == '+' || word[0] == '-');
    char* end = nullptr;
    const std::uint64_t number = std::strtoull(word.c_str() + (relative ? 1 : 0), &end, 0);
    if (word.empty() || *end != '\0') return std::nullopt;
    if (!relative) return number;
    return word[0] == '+' ? before + number : before - number;
}

class Reader {
  public:
    explicit Reader(CallgrindLines& into) : into_(into) {}

    /// False if the line makes no sense.
    [[nodiscard]] bool take(const std::string& line) {
        if (line.empty() || line[0] == '#') return true;
        if (line[0] == '+' || line[0] == '-' || line[0] == '*' || std::isdigit(line[0]) != 0)
            return take_cost(line);
        const std::size_t equals = line.find('='), colon = line.find(':');
        if (colon < equals) return take_header(line.substr(0, colon), line.substr(colon + 1));
        if (equals != std::string::npos) take_name(line.substr(0, equals), line.substr(equals + 1));
        return true;
    }

    /// The first thing that the output lacks; empty if it is complete.
    [[nodiscard]] std::string missing() const {
        if (const std::string event = lacking(events_, {"Ir", "D1mr", "D1mw", "Bcm", "Bim"}); !event.empty())
            return event;
        if (!has_addresses_) return "addresses";
        return has_total_ ? "" : "a total";
    }

  private:
    [[nodiscard]] InstructionCost cost_of(std::istream& words) const {
        InstructionCost cost;
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < events_.size() && words >> value; ++i) {
            const std::string& event = events_[i];
            if (event == "Ir") cost.instructions += value;
            if (event == "Bcm" || event == "Bim") cost.mispredictions += value;
            if (event == "D1mr" || event == "D1mw") cost.d1_misses += value;
        }
        return cost;
    }

    [[nodiscard]] bool take_header(const std::string& key, const std::string& value) {
        std::istringstream words(value);
        if (key == "positions") has_addresses_ = value == " instr line";
        if (key == "events") events_.assign(std::istream_iterator<std::string>(words), {});
        if (key == "totals") {
            into_.total = cost_of(words);
            has_total_ = true;
        }
        return true;
    }

    void take_name(const std::string& key, const std::string& value) {
        if (key == "ob") object_ = number_of(value, objects_, into_.objects);
        if (key == "fn") function_ = number_of(value, functions_, into_.functions);
        if (key == "cob") number_of(value, objects_, into_.objects);  // it may be named here first
        if (key == "cfn") callee_ = number_of(value, functions_, into_.functions);
        if (key == "calls") is_call_ = true;
    }

    /// Reads a cost. After "calls=" it is the cost of the callees, which their own lines have already.
    [[nodiscard]] bool take_cost(const std::string& line) {
        std::istringstream words(line);
        std::string address, source_line;
        words >> address >> source_line;
        const auto at = address_of(address, address_);
        if (!at || source_line.empty()) return false;
        address_ = *at;
        const CallgrindLine cost{address_, function_, object_, cost_of(words)};
        if (is_call_)
            into_.calls.push_back({cost, callee_});
        else
            into_.lines.push_back(cost);
        is_call_ = false;
        return true;
    }

    CallgrindLines& into_;
    Numbers functions_, objects_;
    std::vector<std::string> events_;
    std::uint64_t address_ = 0;
    std::size_t function_ = 0, object_ = 0, callee_ = 0;
    bool is_call_ = false, has_addresses_ = false, has_total_ = false;
};

}  // namespace

Expected<CacheGeometry> callgrind_geometry(const CacheMachine& machine) {
    const auto& levels = machine.caches.levels;
    if (levels.size() < 2) return Refusal{"Callgrind has two levels, this machine one"};
    CacheGeometry geometry{machine.caches.line_bytes, {levels[0], levels[1]}, LineCrossing::merge};
    for (LevelGeometry& level : geometry.levels) {
        if (!std::has_single_bit(level.sets)) return Refusal{"Callgrind wants a power of two of sets"};
        level.inclusion = Inclusion::non_inclusive;
        level.replacement = Replacement::lru;
    }
    return {geometry};
}

std::vector<std::string> callgrind_command(const CacheGeometry& geometry, const std::filesystem::path& output,
                                           const std::vector<std::string>& program) {
    const auto cache = [&](const char* name, std::size_t level) {
        return fmt::format("--{}={},{},{}", name, geometry.bytes_of(level), geometry.levels[level].ways,
                           geometry.line_bytes);
    };
    std::vector<std::string> command = {"valgrind",
                                        "--tool=callgrind",
                                        "--cache-sim=yes",
                                        "--branch-sim=yes",
                                        fmt::format("--I1=32768,8,{}", geometry.line_bytes),
                                        cache("D1", 0),
                                        cache("LL", 1),
                                        "--collect-atstart=no",
                                        "--callgrind-out-file=" + output.string()};
    command.insert(command.end(), program.begin(), program.end());
    return command;
}

/// A total leaves out zeros at its end: missing values are 0.
Expected<CallgrindCounts> parse_callgrind(const std::string& text) {
    std::map<std::string, double> events;
    std::vector<std::string> names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "events:") names.assign(std::istream_iterator<std::string>(words), {});
        if (word != "totals:" && word != "summary:") continue;
        double value = 0;
        for (std::size_t i = 0; i < names.size() && words >> value; ++i) events[names[i]] = value;
    }
    if (const std::string event = lacking(names, {"Ir", "Dr", "Dw", "D1mr", "D1mw", "DLmr", "DLmw"});
        !event.empty())
        return Refusal{"Callgrind's output lacks " + event};
    CallgrindCounts counts{events["Ir"], events["Dr"] + events["Dw"], events["D1mr"] + events["D1mw"],
                           events["DLmr"] + events["DLmw"]};
    if (lacking(names, {"Bcm", "Bim"}).empty()) counts.mispredictions = events["Bcm"] + events["Bim"];
    return {counts};
}

InstructionCost& InstructionCost::operator+=(const InstructionCost& other) {
    instructions += other.instructions;
    mispredictions += other.mispredictions;
    d1_misses += other.d1_misses;
    return *this;
}

Expected<CallgrindLines> parse_callgrind_lines(std::istream& output) {
    CallgrindLines lines;
    Reader reader(lines);
    for (std::string line; std::getline(output, line);)
        if (!reader.take(line)) return Refusal{fmt::format("Callgrind's output has a line '{}'", line)};
    if (const std::string lacks = reader.missing(); !lacks.empty())
        return Refusal{"Callgrind's output lacks " + lacks};
    return {std::move(lines)};
}

std::string plain_function_name(const std::string& demangled) {
    std::string bare;
    int depth = 0;
    for (const char c : demangled) {
        depth += c == '<';
        if (depth == 0) bare += c;
        depth -= c == '>' && depth > 0;
    }
    constexpr std::string_view unnamed = "(anonymous namespace)";
    for (std::size_t at = bare.find(unnamed); at != std::string::npos; at = bare.find(unnamed))
        bare.erase(at, unnamed.size());
    bare.erase(std::min(bare.find('('), bare.size()));
    return bare.substr(bare.find_last_of(": ") + 1);
}

InlineFrames parse_inline_frames(const std::string& printed) {
    InlineFrames frames;
    std::vector<InlineFrame>* here = nullptr;
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("0x")) {
            here = &frames[std::strtoull(line.c_str(), nullptr, 16)];
            here->clear();
            continue;
        }
        std::string place;
        if (!here || !std::getline(lines, place)) break;
        here->push_back({plain_function_name(line), place.substr(0, place.rfind(':'))});
    }
    return frames;
}

Expected<InlineFrames> inline_frames(const std::string& program,
                                     const std::vector<std::uint64_t>& addresses) {
    std::vector<std::string> command = {"addr2line", "-a", "-i", "-f", "-C", "-e", program};
    for (const std::uint64_t address : addresses) command.push_back(fmt::format("{:#x}", address));
    const auto outcome = run_program(command);
    if (!outcome.value) return Expected<InlineFrames>::none(outcome.reason, "install binutils");
    if (outcome.value->exit_code != 0)
        return Expected<InlineFrames>::none("addr2line failed: " + outcome.value->err.substr(0, 200));
    return {parse_inline_frames(outcome.value->out)};
}

}  // namespace edgewise::measure
