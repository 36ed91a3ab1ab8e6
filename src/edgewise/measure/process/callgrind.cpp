// SPDX-License-Identifier: MIT
//
// "Callgrind Format Specification", Valgrind's technical documentation. Geometry is always given: what it
// reads off the processor is wrong on many (a last level of 512 MB, of one way). `--cache-sim` is given since
// its default has changed once.
#include "edgewise/measure/process/callgrind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <sstream>

namespace edgewise::measure {

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

/// A total leaves out zeros at its end: missing events are none.
Expected<CallgrindCounts> parse_callgrind(const std::string& text) {
    std::map<std::string, double> events;
    std::vector<std::string> names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "events:") {
            while (words >> word) names.push_back(word);
        } else if (word == "totals:" || word == "summary:") {
            double value = 0;
            for (std::size_t i = 0; i < names.size() && words >> value; ++i) events[names[i]] = value;
        }
    }
    const auto has = [&](const char* name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const char* needed : {"Ir", "Dr", "Dw", "D1mr", "D1mw", "DLmr", "DLmw"})
        if (!has(needed)) return Refusal{fmt::format("Callgrind's output lacks the event {}", needed)};
    CallgrindCounts counts{events["Ir"], events["Dr"] + events["Dw"], events["D1mr"] + events["D1mw"],
                           events["DLmr"] + events["DLmw"]};
    if (has("Bcm") && has("Bim")) counts.mispredictions = events["Bcm"] + events["Bim"];
    return {counts};
}

}  // namespace edgewise::measure
