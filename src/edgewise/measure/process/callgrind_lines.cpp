// SPDX-License-Identifier: MIT
#include "edgewise/measure/process/callgrind_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "edgewise/measure/process/child_process.hpp"

namespace edgewise::measure {
namespace {

/// "(3) name" the first time, "(3)" from then on; a name without a number is its own.
class Names {
  public:
    explicit Names(std::vector<std::string>& names) : names_(names) {}

    std::size_t number_of(const std::string& text) {
        const std::size_t end = text.empty() || text[0] != '(' ? std::string::npos : text.find(')');
        const std::string key = end == std::string::npos ? text : text.substr(0, end + 1);
        const auto [found, is_new] = numbers_.try_emplace(key, names_.size());
        if (is_new) names_.push_back(key == text ? text : text.substr(std::min(end + 2, text.size())));
        return found->second;
    }

  private:
    std::vector<std::string>& names_;
    std::map<std::string, std::size_t> numbers_;
};

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
    explicit Reader(CallgrindLines& into) : into_(into), functions_(into.functions), objects_(into.objects) {}

    /// False: the line makes no sense.
    [[nodiscard]] bool take(const std::string& line) {
        if (line.empty() || line[0] == '#') return true;
        if (line[0] == '+' || line[0] == '-' || line[0] == '*' || std::isdigit(line[0]) != 0)
            return take_cost(line);
        const std::size_t equals = line.find('='), colon = line.find(':');
        if (colon < equals) return take_header(line.substr(0, colon), line.substr(colon + 1));
        if (equals != std::string::npos) take_name(line.substr(0, equals), line.substr(equals + 1));
        return true;
    }

    /// Empty, or what the output lacks.
    [[nodiscard]] std::string missing() const {
        for (const char* event : {"Ir", "D1mr", "D1mw", "Bcm", "Bim"})
            if (std::find(events_.begin(), events_.end(), event) == events_.end())
                return std::string("the event ") + event;
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
        if (key == "ob") object_ = objects_.number_of(value);
        if (key == "fn") function_ = functions_.number_of(value);
        if (key == "cob") static_cast<void>(objects_.number_of(value));  // it may be named here first
        if (key == "cfn") callee_ = functions_.number_of(value);
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
    Names functions_, objects_;
    std::vector<std::string> events_;
    std::uint64_t address_ = 0;
    std::size_t function_ = 0, object_ = 0, callee_ = 0;
    bool is_call_ = false, has_addresses_ = false, has_total_ = false;
};

}  // namespace

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
