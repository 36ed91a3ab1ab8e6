// SPDX-License-Identifier: MIT
//
// Facts become plain values; one that is not known becomes null, and its reason goes to "unreadable" by its
// path.
#include "edgewise/measure/machine/machine_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace edgewise::measure {

namespace {

using nlohmann::json;

/// Writes facts into an object: keys and facts in turn.
struct FactWriter {
    json &target, &reasons;
    std::string prefix;

    template <class Fact, class... More>
    void put(const char* key, const Fact& fact, const More&... more) const {
        target[key] = fact.value ? json(*fact.value) : json(nullptr);
        if (!fact.value) reasons[prefix + key] = fact.reason;
        if constexpr (sizeof...(more) > 0) put(more...);
    }
};

json cpu_json(const Cpu& cpu, json& reasons) {
    json result = {{"vector_extensions", cpu.vector_extensions}};
    using Number = Expected<std::int64_t>;
    const auto threads =
        cpu.threads > 0 ? Number{cpu.threads} : Number::none("/proc/cpuinfo names no processor");
    FactWriter{result, reasons, "cpu."}.put("vendor", cpu.vendor, "name", cpu.name, "family", cpu.family,
                                            "model", cpu.model, "stepping", cpu.stepping, "cores", cpu.cores,
                                            "threads", threads);
    return result;
}

json caches_json(const std::vector<Cache>& caches, json& reasons) {
    json result = json::array();
    for (const Cache& cache : caches) {
        json row;
        FactWriter{row, reasons, fmt::format("caches[{}].", result.size())}.put(
            "level", cache.level, "type", cache.type, "bytes", cache.bytes, "ways", cache.ways, "line_bytes",
            cache.line_bytes, "sets", cache.sets, "shared_cpus", cache.shared_cpus);
        result.push_back(std::move(row));
    }
    return result;
}

/// "8 x L2 2M"; "L3 36M of 0-23" of the only copy.
std::string cache_text(const Cache& cache, const std::set<std::string>& shared_by) {
    constexpr std::int64_t kibibyte = 1024, mebibyte = kibibyte * kibibyte;
    const std::int64_t bytes = cache.bytes.value.value_or(0);
    const bool is_whole = bytes % mebibyte == 0;
    const std::string type = cache.type.value.value_or("Unified").substr(0, 1);
    const std::string text = fmt::format(
        "L{}{} {}", cache.level.value.value_or(0), type == "U" ? "" : type,
        bytes == 0 ? "of unknown size"
                   : fmt::format("{}{}", bytes / (is_whole ? mebibyte : kibibyte), is_whole ? "M" : "K"));
    if (shared_by.size() == 1) return fmt::format("{} of {}", text, *shared_by.begin());
    return shared_by.empty() ? text : fmt::format("{} x {}", shared_by.size(), text);
}

/// The topology: a row for each kind of cores.
json cores_json(const std::vector<CoreKind>& kinds) {
    json result = json::array();
    for (const CoreKind& kind : kinds) {
        std::vector<std::string> caches;
        for (std::size_t i = 0; i < kind.caches.size(); ++i)
            caches.push_back(cache_text(kind.caches[i], kind.shared_by[i]));
        const std::string processors = processor_list(kind.processors);
        result.push_back({{"processors", processors},
                          {"allowed", processor_list(kind.allowed)},
                          {"caches", fmt::format("{}", fmt::join(caches, ", "))},
                          {"bind", "taskset -c " + processors}});
    }
    return result;
}

template <class Value>
json or_null(const std::optional<Value>& value) {
    return value ? json(*value) : json(nullptr);
}

json counter_json(const CounterRecord& record) {
    const bool counted = record.value.has_value();
    return {{"event", record.event},
            {"status", counted ? "counted" : "unavailable"},
            {"by", record.by},
            {"encoding", record.encoding},
            {"level", or_null(record.level)},
            {"meaning", record.meaning},
            {"unit", record.unit},
            {"value", or_null(record.value)},
            {"errno", record.error != 0 ? json(record.error) : json(nullptr)},
            {"reason", counted ? json(nullptr) : json(record.refusal.reason)},
            {"remedy", counted ? json(nullptr) : json(record.refusal.remedy)}};
}

}  // namespace

json machine_json() {
    const Machine machine = read_machine();
    return machine_json(machine, read_counters(machine.cpu));
}

json machine_json(const Machine& machine, const std::vector<CounterRecord>& counters) {
    json result;
    json reasons = json::object();
    result["cpu"] = cpu_json(machine.cpu, reasons);
    const auto kinds = machine.cores.value.value_or(std::vector<CoreKind>());
    result["cores"] = cores_json(kinds);
    result["caches"] = caches_json(kinds.empty() ? std::vector<Cache>() : kinds.front().caches, reasons);
    result["binding"] = kinds.empty() ? json(nullptr) : json(binding_advice(kinds));
    if (kinds.empty()) reasons["caches"] = reasons["binding"] = machine.cores.reason;
    FactWriter{result, reasons, ""}.put(
        "page_bytes", machine.page_bytes, "memory_bytes", machine.memory_bytes, "kernel", machine.kernel,
        "hypervisor", machine.cpu.hypervisor, "clock_source", machine.clock_source, "governor",
        machine.governor, "turbo", machine.turbo, "aslr", machine.aslr, "aslr_this_process",
        machine.aslr_this_process, "transparent_huge_pages", machine.transparent_huge_pages,
        "perf_event_paranoid", machine.perf_event_paranoid);
    result["counters"] = json::array();
    for (const CounterRecord& record : counters) result["counters"].push_back(counter_json(record));
    result["counted_over"] = reference_work;
    result["unreadable"] = std::move(reasons);
    return result;
}

std::string machine_identity(const json& machine) {
    json identity = machine;
    for (const char* key : {"counters", "counted_over", "perf_event_paranoid", "memory_bytes", "unreadable",
                            "cores", "binding"})
        identity.erase(key);
    return identity.dump();
}

}  // namespace edgewise::measure
