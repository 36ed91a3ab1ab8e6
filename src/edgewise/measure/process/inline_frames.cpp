// SPDX-License-Identifier: MIT
#include "edgewise/measure/process/inline_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "edgewise/measure/process/child_process.hpp"

namespace edgewise::measure {

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
