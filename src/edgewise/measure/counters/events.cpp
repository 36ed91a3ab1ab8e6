// SPDX-License-Identifier: MIT
//
// Names in events.json: libpfm 4.13 for the x86 processors it has; for Zen 5 libpfm's later tables; for Arm
// libpfm's names. AMD's L3 counters are left out: they belong to a whole core complex, not to a thread, so
// the last level is seen through the core's own fills from memory. The generic events are defined in the
// kernel's tables in arch/x86/events/intel/core.c, amd/core.c and drivers/perf/arm_pmuv3.c.
//
// Family and model numbers of processors: libpfm 4.13 (pfmlib_intel_*.c, pfmlib_amd64.c) and, for what is
// newer, the kernel's arch/x86/include/asm/intel-family.h and arch/x86/kernel/cpu/amd.c. 4.13 itself does not
// recognise some desktop models of Zen 3 and 4 (family 25, model 0x61).
#include "edgewise/measure/counters/events.hpp"

#include <fmt/core.h>
#include <linux/perf_event.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "edgewise/measure/counters/counter_group.hpp"

namespace edgewise::measure {

namespace {

constexpr std::string_view own_event = "libpfm", generic_event = "generic";

/// An event by libpfm's name, with its PMU.
struct NamedEvent {
    std::string_view by;
    std::string name, meaning;
};

/// Maker of the processor, from the vendor's name in /proc/cpuinfo.
CpuMaker maker_of(const Cpu& cpu) {
    const std::string vendor = cpu.vendor.value.value_or("");
    if (vendor == "GenuineIntel") return CpuMaker::intel;
    if (vendor == "AuthenticAMD" || vendor == "HygonGenuine") return CpuMaker::amd;
    if (vendor.starts_with("0x")) return CpuMaker::arm;
    return CpuMaker::other;
}

/// Named events in the order in which they are tried.
std::vector<NamedEvent> names_of(const MetricName& metric, const Cpu& cpu) {
    std::vector<NamedEvent> names;
    const Processor* const processor = find_processor(cpu);
    if (const EventRow* const row = processor ? find_event(metric.name, processor->generation) : nullptr)
        names.push_back({own_event, fmt::format("{}::{}", processor->pmu, row->name), meaning(*row)});
    if (const GenericEvent* const generic = find_generic(metric.name, maker_of(cpu)))
        names.push_back(
            {generic_event, fmt::format("perf::{}", generic->name), std::string(generic->meaning)});
    return names;
}

/// The errno of opening the event; 0 if it opens.
int error_of(const EventCode& code) { return CounterGroup(std::span(&code, 1)).error(); }

/// Names of the processors that have an event for the metric, as "Intel Skylake, AMD Zen 3".
std::string processors_with(std::string_view metric) {
    std::string names;
    for (const Processor& processor : processors()) {
        if (find_event(metric, processor.generation) == nullptr) continue;
        names += fmt::format("{}{}", names.empty() ? "" : ", ", processor.name);
    }
    return names;
}

Refusal why_no_event(const MetricName& metric, const Cpu& cpu) {
    if (const auto names = names_of(metric, cpu); !names.empty())
        return {encode_by_libpfm(names.front().name).reason,
                "build with a version of libpfm4 that knows the event"};
    const Processor* const processor = find_processor(cpu);
    const std::string where = processor != nullptr
                                  ? std::string(processor->name)
                                  : fmt::format("this processor ({})", cpu.name.value.value_or("unknown"));
    return {fmt::format("no event that counts this is known on {}", where),
            fmt::format("measure on one of: {}", processors_with(metric.name))};
}

}  // namespace

std::string encoding_text(const EventCode& code) {
    const char* const type = code.type == PERF_TYPE_HARDWARE   ? "PERF_TYPE_HARDWARE"
                             : code.type == PERF_TYPE_HW_CACHE ? "PERF_TYPE_HW_CACHE"
                             : code.type == PERF_TYPE_SOFTWARE ? "PERF_TYPE_SOFTWARE"
                             : code.type == PERF_TYPE_RAW      ? "PERF_TYPE_RAW"
                                                               : nullptr;
    const std::string name = type != nullptr ? type : fmt::format("type {}", code.type);
    return fmt::format("{}:{:#x}{}", name, code.config, code.kernel_too ? "" : ":u");
}

Refusal explain_error(int error, bool hardware, const Cpu& cpu) {
    const bool guest = cpu.hypervisor.value.value_or(false);
    const std::string words = std::strerror(error);
    const auto is_one_of = [&](auto... codes) { return ((error == codes) || ...); };
    if (is_one_of(EACCES, EPERM)) {
        return {"no permission: " + words,
                "as root: sysctl kernel.perf_event_paranoid=1, or give the program CAP_PERFMON; "
                "in a container also allow perf_event_open in its seccomp profile"};
    }
    if (is_one_of(ENOENT, EOPNOTSUPP, ENODEV) && hardware && guest) {
        return {"this virtual machine has no performance counters for it: " + words,
                "have the hypervisor pass the PMU through (KVM: -cpu host,pmu=on), or run on the bare "
                "machine"};
    }
    if (is_one_of(ENOENT, EOPNOTSUPP, ENODEV, EINVAL)) {
        return {"this processor or kernel does not have the event: " + words,
                "use a kernel that knows the processor"};
    }
    if (error == ENOSYS) {
        return {"the kernel has no perf_event_open: " + words,
                "use a kernel with CONFIG_PERF_EVENTS, outside of a sandbox that emulates system calls"};
    }
    if (is_one_of(EBUSY, EMFILE, ENOSPC)) {
        return {"no counter or file descriptor free: " + words,
                "end other users of the counters, or raise ulimit -n"};
    }
    return {words, "see man 2 perf_event_open"};
}

std::vector<ChosenEvent> event_candidates(const MetricName& metric, const Cpu& cpu) {
    std::vector<ChosenEvent> found;
    for (const auto& [by, name, meaning] : names_of(metric, cpu)) {
        const Expected<EventCode> code = encode_by_libpfm(name);
        if (!code.value) continue;
        const std::string encoding = encoding_text(*code.value);
        found.push_back({std::string(metric.name), std::string(by),
                         by == own_event ? fmt::format("{} = {}", name, encoding) : encoding,
                         std::string(metric.level), meaning});
        found.back().code = *code.value;
        found.back().must_happen = metric.must_happen;
    }
    return found;
}

ChosenEvent choose_event(const MetricName& metric, const Cpu& cpu) {
    const std::vector<ChosenEvent> candidates = event_candidates(metric, cpu);
    if (candidates.empty()) {
        ChosenEvent none{std::string(metric.name), "none", "none", std::nullopt, "not known here"};
        none.must_happen = metric.must_happen;
        none.refusal = why_no_event(metric, cpu);
        return none;
    }
    ChosenEvent first = candidates.front();
    for (const ChosenEvent& candidate : candidates) {
        const int error = error_of(candidate.code);
        if (error == 0) return candidate;
        if (first.error == 0) first.error = error;
    }
    first.refusal = explain_error(first.error, true, cpu);
    return first;
}

const std::vector<ChosenEvent>& chosen_events(const Cpu& cpu) {
    static const std::vector<ChosenEvent> chosen = [&] {
        std::vector<ChosenEvent> events;
        for (const MetricName& metric : metrics) events.push_back(choose_event(metric, cpu));
        return events;
    }();
    return chosen;
}

/// Context switches and migrations are counted in the kernel too: they happen there, and a count of user mode
/// only would be 0 without any error.
ChosenEvent software_event(std::string_view name, std::uint64_t config, std::string_view meaning,
                           const Cpu& cpu) {
    const bool in_kernel = config == PERF_COUNT_SW_CONTEXT_SWITCHES || config == PERF_COUNT_SW_CPU_MIGRATIONS;
    const EventCode code{PERF_TYPE_SOFTWARE, config, in_kernel};
    ChosenEvent event{std::string(name), "software", encoding_text(code), "kernel", std::string(meaning)};
    event.code = code;
    event.error = error_of(code);
    if (event.error != 0) event.refusal = explain_error(event.error, false, cpu);
    return event;
}

namespace {

struct EventTables {
    std::vector<EventRow> own;
    std::vector<GenericEvent> generic;
};

/// Reads events.json. Throws nlohmann::json::exception if a member is missing, std::out_of_range if a maker
/// is unknown.
EventTables read_tables() {
    const std::map<std::string, CpuMaker> makers = {{"intel", CpuMaker::intel},
                                                    {"amd", CpuMaker::amd},
                                                    {"arm", CpuMaker::arm},
                                                    {"other", CpuMaker::other}};
    const auto texts = nlohmann::json::parse(event_texts);
    EventTables read;
    for (const MetricName& metric : metrics) {
        const std::string name(metric.name);
        for (const auto& row : texts.at("own").at(name)) {
            read.own.push_back({metric, row.at("on").get<std::vector<std::string>>(),
                                row.at("name").get<std::string>(), row.at("counts").get<std::string>(),
                                row.value("prefetches", false), row.value("retired", false)});
        }
        for (const auto& row : texts.at("generic").at(name))
            read.generic.push_back({metric.name, makers.at(row.at("maker").get<std::string>()),
                                    row.at("name").get<std::string>(), row.at("meaning").get<std::string>()});
    }
    return read;
}

const EventTables& tables() {
    static const EventTables read = read_tables();
    return read;
}

}  // namespace

std::span<const EventRow> event_table() { return tables().own; }

const EventRow* find_event(std::string_view metric, std::string_view generation) {
    for (const EventRow& row : tables().own) {
        if (row.metric.name == metric && std::ranges::count(row.generations, generation) > 0) return &row;
    }
    return nullptr;
}

const GenericEvent* find_generic(std::string_view metric, CpuMaker maker) {
    for (const GenericEvent& event : tables().generic) {
        if (event.metric == metric && (event.maker == CpuMaker::other || event.maker == maker)) return &event;
    }
    return nullptr;
}

std::string meaning(const EventRow& row) {
    if (row.metric.name == "cycles") return row.counts;
    const char* const when = row.retired ? "retired" : "speculative ones too";
    // Prefetches are a question of what moves between caches only.
    if (row.metric.level == "core" || row.metric.name == "line_crossing_loads")
        return fmt::format("{} ({})", row.counts, when);
    return fmt::format("{} ({}, {})", row.counts, row.prefetches ? "prefetches too" : "without prefetches",
                       when);
}

std::span<const Processor> processors() {
    using enum CpuMaker;
    static constexpr Processor known[] = {
        // To Kaby, Coffee and Whiskey Lake (0x8e, 0x9e) and Comet Lake (0xa5).
        {"skl", "Intel Skylake", "skylake", intel, 6, {{0x4e}, {0x5e}, {0x8e}, {0x9e}, {0xa5, 0xa6}}},
        {"skx", "Intel Skylake server", "skylake", intel, 6, {{0x55}}, {0, 4}},
        {"clx", "Intel Cascade Lake server", "skylake", intel, 6, {{0x55}}, {5, 0xf}},
        // To Tiger Lake (0x8c) and Rocket Lake (0xa7).
        {"icl", "Intel Ice Lake", "skylake", intel, 6, {{0x7d, 0x7e}, {0x8c, 0x8d}, {0x9d}, {0xa7}}},
        {"icx", "Intel Ice Lake server", "skylake", intel, 6, {{0x6a}, {0x6c}}},
        // To Emerald Rapids (0xcf).
        {"spr", "Intel Sapphire Rapids", "sapphire_rapids", intel, 6, {{0x8f}, {0xcf}}},
        {"amd64_fam17h_zen2", "AMD Zen 2", "zen2", amd, 0x17, {{0x30, 0xff}}},
        {"amd64_fam19h_zen3", "AMD Zen 3", "zen3", amd, 0x19, {{0x00, 0x0f}, {0x20, 0x5f}}},
        {"amd64_fam19h_zen4", "AMD Zen 4", "zen4", amd, 0x19, {{0x10, 0x1f}, {0x60, 0xaf}}},
        {"amd64_fam1ah_zen5", "AMD Zen 5", "zen5", amd, 0x1a, {{0x00, 0x2f}, {0x40, 0x4f}, {0x60, 0x7f}}},
        {"arm_n1", "Arm Neoverse N1", "neoverse_n1", arm, 8, {{0xd0c}}},
        {"arm_v2", "Arm Neoverse V2", "neoverse_v2", arm, 8, {{0xd4f}}},
        {"amd64_k7", "AMD K7", "k7", amd, 6, {{0x00, 0xff}}},
    };
    return known;
}

const Processor* find_processor(const Cpu& cpu) {
    const std::int64_t model = cpu.model.value.value_or(-1);
    for (const Processor& processor : processors()) {
        if (processor.maker != maker_of(cpu) || processor.family != cpu.family.value.value_or(-1)) continue;
        if (!processor.steppings.holds(cpu.stepping.value.value_or(0))) continue;
        for (const NumberRange& models : processor.models) {
            if (models.holds(model)) return &processor;
        }
    }
    return nullptr;
}

}  // namespace edgewise::measure
