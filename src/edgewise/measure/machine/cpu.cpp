// SPDX-License-Identifier: MIT
//
// /proc/cpuinfo: blocks of "key : value" lines, one block per logical processor. On a hybrid processor the
// blocks differ; the first one is described.
#include "edgewise/measure/machine/cpu.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace edgewise::measure {

namespace {

using Keys = std::map<std::string, std::string, std::less<>>;

std::string trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return std::string(text.substr(begin, text.find_last_not_of(" \t") - begin + 1));
}

/// One map per logical processor. Lines outside a "processor" block (Arm's board name) are left out.
std::vector<Keys> parse_blocks(std::string_view cpuinfo) {
    std::vector<Keys> blocks;
    std::istringstream lines{std::string(cpuinfo)};
    for (std::string line; std::getline(lines, line);) {
        const auto colon = line.find(':');
        if (colon == std::string::npos) continue;
        const std::string key = trimmed(std::string_view(line).substr(0, colon));
        if (key == "processor") blocks.emplace_back();
        if (!blocks.empty()) blocks.back()[key] = trimmed(std::string_view(line).substr(colon + 1));
    }
    return blocks;
}

/// The value of the first key that is there: x86's name for it, then Arm's.
Expected<std::string> find_text(const Keys& keys, std::string_view x86, std::string_view arm) {
    for (const std::string_view key : {x86, arm}) {
        const auto found = keys.find(key);
        if (found != keys.end() && !found->second.empty()) return {found->second};
    }
    return Refusal{fmt::format("/proc/cpuinfo has no \"{}\"", x86)};
}

Expected<std::int64_t> find_number(const Keys& keys, std::string_view x86, std::string_view arm) {
    const Expected<std::string> text = find_text(keys, x86, arm);
    if (!text.value) return text.refusal();
    const auto number = parse_number(*text.value);
    if (!number) return Refusal{fmt::format("/proc/cpuinfo: {} is {}", x86, *text.value)};
    return {number};
}

Expected<std::int64_t> count_cores(const std::vector<Keys>& blocks) {
    std::set<std::pair<std::string, std::string>> cores;
    for (const Keys& keys : blocks) {
        const auto package = keys.find("physical id");
        const auto core = keys.find("core id");
        if (package == keys.end() || core == keys.end()) return Refusal{"/proc/cpuinfo has no \"core id\""};
        cores.emplace(package->second, core->second);
    }
    if (cores.empty()) return Refusal{"/proc/cpuinfo names no processor"};
    return {static_cast<std::int64_t>(cores.size())};
}

constexpr const char* known_extensions[] = {
    "sse2",        "ssse3",      "sse4_1",   "sse4_2",  "avx",      "avx2",     "fma",
    "f16c",        "bmi2",       "avx_vnni", "avx512f", "avx512dq", "avx512bw", "avx512vl",
    "avx512_vnni", "avx512vbmi", "amx_tile", "asimd",   "asimdhp",  "sve",      "sve2"};

}  // namespace

Cpu parse_cpu(std::string_view cpuinfo) {
    const std::vector<Keys> blocks = parse_blocks(cpuinfo);
    const Keys keys = blocks.empty() ? Keys{} : blocks.front();
    Cpu cpu;
    cpu.vendor = find_text(keys, "vendor_id", "CPU implementer");
    cpu.name = find_text(keys, "model name", "model name");
    cpu.family = find_number(keys, "cpu family", "CPU architecture");
    cpu.model = find_number(keys, "model", "CPU part");
    cpu.stepping = find_number(keys, "stepping", "CPU revision");
    cpu.cores = count_cores(blocks);
    cpu.threads = static_cast<std::int64_t>(blocks.size());

    std::istringstream words(find_text(keys, "flags", "Features").value.value_or(""));
    std::set<std::string> flags;
    for (std::string word; words >> word;) flags.insert(word);
    for (const char* name : known_extensions) {
        if (flags.contains(name)) cpu.vector_extensions.emplace_back(name);
    }
    const bool x86 = keys.find("flags") != keys.end();
    cpu.hypervisor = x86 ? Expected<bool>{flags.count("hypervisor") != 0}
                         : Expected<bool>::none("only x86 processors tell a guest that it is one");
    return cpu;
}

}  // namespace edgewise::measure
