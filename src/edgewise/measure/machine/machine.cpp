// SPDX-License-Identifier: MIT
//
// Reads /proc and /sys (Documentation/admin-guide of the Linux kernel) and asks two system calls. Files there
// have no size, so they are read to their end. /proc/cpuinfo has blocks of "key : value" lines, one block per
// logical processor; on a hybrid machine the blocks and the caches of processors differ.
#include "edgewise/measure/machine/machine.hpp"

#include <fmt/core.h>
#include <sched.h>
#include <sys/personality.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>
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

Cpu read_cpu(const std::filesystem::path& root, std::int64_t processor) {
    const Expected<std::string> text = read_text(root / "proc/cpuinfo");
    Cpu cpu = parse_cpu(text.value.value_or(""), processor);
    if (!text.value) {
        for (Expected<std::string>* fact : {&cpu.vendor, &cpu.name}) fact->reason = text.reason;
        for (Expected<std::int64_t>* fact : {&cpu.family, &cpu.model, &cpu.stepping, &cpu.cores}) {
            fact->reason = text.reason;
        }
        cpu.hypervisor.reason = text.reason;
    }
    return cpu;
}

Expected<std::int64_t> read_memory(const std::filesystem::path& root) {
    const Expected<std::string> text = read_text(root / "proc/meminfo");
    if (!text.value) return text.refusal();
    std::istringstream lines(*text.value);
    std::string key;
    std::int64_t kibibytes = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        if (words >> key >> kibibytes && key == "MemTotal:") return {kibibytes * 1024};
    }
    return Refusal{"/proc/meminfo has no MemTotal"};
}

/// Intel's own driver has a switch for "no turbo", the others one for "boost".
Expected<bool> read_turbo(const std::filesystem::path& root) {
    const Expected<std::int64_t> off = read_number(root / "sys/devices/system/cpu/intel_pstate/no_turbo");
    if (off.value) return {*off.value == 0};
    const Expected<std::int64_t> boost = read_number(root / "sys/devices/system/cpu/cpufreq/boost");
    if (boost.value) return {*boost.value != 0};
    return Refusal{fmt::format("{}; {}", off.reason, boost.reason)};
}

/// The choice in brackets: "always [madvise] never".
Expected<std::string> read_choice(const std::filesystem::path& file) {
    const Expected<std::string> text = read_text(file);
    if (!text.value) return text;
    const auto open = text.value->find('[');
    const auto close = text.value->find(']');
    if (open == std::string::npos || close == std::string::npos || close < open)
        return Refusal{fmt::format("{}: no choice in brackets: {}", file.string(), *text.value)};
    return {text.value->substr(open + 1, close - open - 1)};
}

Expected<bool> read_own_aslr() {
    const int flags = personality(0xffffffff);  // asks, changes nothing
    if (flags < 0) return Refusal{"personality() is not allowed here"};
    return {(flags & ADDR_NO_RANDOMIZE) == 0};
}

Cache read_cache(const std::filesystem::path& index) {
    Cache cache;
    cache.level = read_number(index / "level");
    cache.type = read_text(index / "type");
    cache.bytes = read_number(index / "size");
    cache.ways = read_number(index / "ways_of_associativity");
    cache.line_bytes = read_number(index / "coherency_line_size");
    cache.sets = read_number(index / "number_of_sets");
    cache.shared_cpus = read_text(index / "shared_cpu_list");
    // The kernel writes 0 where it does not know (Arm without firmware tables): that is not a number of ways.
    for (Expected<std::int64_t>* number : {&cache.bytes, &cache.ways, &cache.line_bytes, &cache.sets}) {
        if (number->value == 0) *number = Refusal{"the kernel says 0: it does not know"};
    }
    return cache;
}

std::vector<Cache> read_caches(const std::filesystem::path& processor) {
    std::vector<Cache> caches;
    std::error_code error;
    const auto index = [&] { return processor / fmt::format("cache/index{}", caches.size()); };
    while (std::filesystem::is_directory(index(), error)) caches.push_back(read_cache(index()));
    return caches;
}

bool is_alike(const Cache& a, const Cache& b) {
    const auto facts = [](const Cache& cache) {
        return std::tie(cache.level.value, cache.type.value, cache.bytes.value, cache.ways.value,
                        cache.line_bytes.value);
    };
    return facts(a) == facts(b);
}

/// The numbers of the folders cpu0, cpu1, ... in ascending order.
std::set<std::int64_t> processors_of(const std::filesystem::path& folder) {
    std::set<std::int64_t> numbers;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename();
        const auto number = name.starts_with("cpu") ? parse_number(name.substr(3)) : std::nullopt;
        if (number) numbers.insert(*number);
    }
    return numbers;
}

}  // namespace

Expected<std::string> read_text(const std::filesystem::path& file) {
    errno = 0;
    std::ifstream stream(file);
    if (!stream) return Refusal{fmt::format("{}: {}", file.string(), std::strerror(errno))};
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const auto end = text.find_last_not_of(" \t\r\n");
    text.erase(end == std::string::npos ? 0 : end + 1);
    if (text.empty()) return Refusal{fmt::format("{}: empty", file.string())};
    return {std::move(text)};
}

Expected<std::int64_t> read_number(const std::filesystem::path& file) {
    const Expected<std::string> text = read_text(file);
    if (!text.value) return text.refusal();
    const auto number = parse_number(*text.value);
    if (!number) return Refusal{fmt::format("{}: not a number: {}", file.string(), *text.value)};
    return {number};
}

std::optional<std::int64_t> parse_number(std::string text) {
    if (text.empty()) return std::nullopt;
    const auto unit = std::string_view("KMG").find(text.back());
    const std::int64_t factor = unit < 3 ? std::int64_t{1024} << 10 * unit : 1;
    if (factor > 1) text.pop_back();
    const bool hexadecimal = text.starts_with("0x");
    const char* const begin = text.data() + (hexadecimal ? 2 : 0);
    const char* const end = text.data() + text.size();
    std::int64_t value = 0;
    const auto [rest, error] = std::from_chars(begin, end, value, hexadecimal ? 16 : 10);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return value * factor;
}

Cpu parse_cpu(std::string_view cpuinfo, std::int64_t processor) {
    const std::vector<Keys> blocks = parse_blocks(cpuinfo);
    Keys keys = blocks.empty() ? Keys{} : blocks.front();
    for (const Keys& block : blocks)
        if (block.at("processor") == std::to_string(processor)) keys = block;
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
                         : Expected<bool>::none("only x86 processors report a hypervisor");
    return cpu;
}

std::vector<std::int64_t> allowed_processors() {
    cpu_set_t mask;
    if (sched_getaffinity(0, sizeof mask, &mask) != 0) return {};
    std::vector<std::int64_t> allowed;
    for (int i = 0; i < CPU_SETSIZE; ++i)
        if (CPU_ISSET(i, &mask)) allowed.push_back(i);
    return allowed;
}

std::string processor_list(std::span<const std::int64_t> processors) {
    std::string list;
    for (std::size_t first = 0, last = 0; first < processors.size(); first = ++last) {
        while (last + 1 < processors.size() && processors[last + 1] == processors[last] + 1) ++last;
        list += fmt::format("{}{}", first == 0 ? "" : ",", processors[first]);
        if (last > first) list += fmt::format("-{}", processors[last]);
    }
    return list;
}

Expected<std::vector<CoreKind>> read_cores(const std::filesystem::path& root,
                                           std::span<const std::int64_t> allowed) {
    const std::filesystem::path folder = root / "sys/devices/system/cpu";
    std::vector<CoreKind> kinds;
    for (const std::int64_t processor : processors_of(folder)) {
        const std::vector<Cache> caches = read_caches(folder / fmt::format("cpu{}", processor));
        if (caches.empty()) continue;
        auto kind = std::ranges::find_if(
            kinds, [&](const CoreKind& other) { return std::ranges::equal(other.caches, caches, is_alike); });
        if (kind == kinds.end())
            kind = kinds.insert(kind, {{}, {}, caches, std::vector<std::set<std::string>>(caches.size())});
        kind->processors.push_back(processor);
        if (std::ranges::find(allowed, processor) != allowed.end()) kind->allowed.push_back(processor);
        for (std::size_t i = 0; i < caches.size(); ++i)
            if (const auto& list = caches[i].shared_cpus.value) kind->shared_by[i].insert(*list);
    }
    if (kinds.empty()) return Refusal{fmt::format("{}: no caches described", folder.string())};
    std::ranges::stable_sort(kinds, {}, [](const CoreKind& kind) {
        return kind.allowed.empty() ? std::numeric_limits<std::int64_t>::max() : kind.allowed.front();
    });
    return {std::move(kinds)};
}

std::string binding_advice(std::span<const CoreKind> kinds) {
    const CoreKind& here = kinds.front();
    if (kinds.size() == 1)
        return fmt::format("all cores have equal caches; to keep a measurement on one: taskset -c {}",
                           (here.allowed.empty() ? here.processors : here.allowed).back());
    const auto allowed = std::ranges::count_if(kinds, [](const auto& kind) { return !kind.allowed.empty(); });
    if (allowed == 1)
        return fmt::format("bound to cores of one kind, {}; host has their caches",
                           processor_list(here.processors));
    return fmt::format(
        "bound to no kind of cores, so times mix several; host has the caches of {}; to measure these: "
        "taskset -c {}",
        processor_list(here.processors), processor_list(here.processors));
}

Machine read_machine(const std::filesystem::path& root) {
    Machine machine;
    machine.cores = read_cores(root);
    const std::int64_t here = machine.cores.value ? machine.cores.value->front().processors.front() : 0;
    machine.cpu = read_cpu(root, here);
    machine.page_bytes = {sysconf(_SC_PAGESIZE)};
    machine.memory_bytes = read_memory(root);
    machine.kernel = read_text(root / "proc/sys/kernel/osrelease");
    machine.clock_source =
        read_text(root / "sys/devices/system/clocksource/clocksource0/current_clocksource");
    machine.governor =
        read_text(root / fmt::format("sys/devices/system/cpu/cpu{}/cpufreq/scaling_governor", here));
    machine.turbo = read_turbo(root);
    machine.aslr = read_number(root / "proc/sys/kernel/randomize_va_space");
    machine.aslr_this_process = read_own_aslr();
    machine.transparent_huge_pages = read_choice(root / "sys/kernel/mm/transparent_hugepage/enabled");
    machine.perf_event_paranoid = read_number(root / "proc/sys/kernel/perf_event_paranoid");
    return machine;
}

}  // namespace edgewise::measure
