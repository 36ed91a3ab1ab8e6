// SPDX-License-Identifier: MIT
//
// Facts become plain values; one that is not known becomes null, and its reason goes to "unreadable" by its
// path.
#include "edgewise/measure/machine/machine_json.hpp"

#include <fmt/core.h>

namespace edgewise::measure {

namespace {

using nlohmann::json;

class FactWriter {
  public:
    FactWriter(json& target, json& reasons, std::string prefix)
        : target_(target), reasons_(reasons), prefix_(std::move(prefix)) {
        target_ = json::object();
    }

    template <class Value>
    void put(const char* key, const Expected<Value>& fact) {
        if (fact.value) {
            target_[key] = *fact.value;
        } else {
            target_[key] = nullptr;
            reasons_[prefix_ + key] = fact.reason;
        }
    }

  private:
    json& target_;
    json& reasons_;
    std::string prefix_;
};

json cpu_json(const Cpu& cpu, json& reasons) {
    json result;
    FactWriter writer(result, reasons, "cpu.");
    writer.put("vendor", cpu.vendor);
    writer.put("name", cpu.name);
    writer.put("family", cpu.family);
    writer.put("model", cpu.model);
    writer.put("stepping", cpu.stepping);
    writer.put("cores", cpu.cores);
    writer.put("threads", cpu.threads > 0 ? Expected<std::int64_t>{cpu.threads}
                                          : Expected<std::int64_t>::none("/proc/cpuinfo names no processor"));
    result["vector_extensions"] = cpu.vector_extensions;
    return result;
}

json caches_json(const Expected<std::vector<Cache>>& caches, json& reasons) {
    json result = json::array();
    if (!caches.value) {
        reasons["caches"] = caches.reason;
        return result;
    }
    for (const Cache& cache : *caches.value) {
        json row;
        FactWriter writer(row, reasons, fmt::format("caches[{}].", result.size()));
        writer.put("level", cache.level);
        writer.put("type", cache.type);
        writer.put("bytes", cache.bytes);
        writer.put("ways", cache.ways);
        writer.put("line_bytes", cache.line_bytes);
        writer.put("sets", cache.sets);
        writer.put("shared_cpus", cache.shared_cpus);
        result.push_back(std::move(row));
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
    FactWriter writer(result, reasons, "");
    result["cpu"] = cpu_json(machine.cpu, reasons);
    result["caches"] = caches_json(machine.caches, reasons);
    writer.put("page_bytes", machine.page_bytes);
    writer.put("memory_bytes", machine.memory_bytes);
    writer.put("kernel", machine.kernel);
    writer.put("hypervisor", machine.cpu.hypervisor);
    writer.put("clock_source", machine.clock_source);
    writer.put("governor", machine.governor);
    writer.put("turbo", machine.turbo);
    writer.put("aslr", machine.aslr);
    writer.put("aslr_this_process", machine.aslr_this_process);
    writer.put("transparent_huge_pages", machine.transparent_huge_pages);
    writer.put("perf_event_paranoid", machine.perf_event_paranoid);
    result["counters"] = json::array();
    for (const CounterRecord& record : counters) result["counters"].push_back(counter_json(record));
    result["counted_over"] = reference_work;
    result["unreadable"] = std::move(reasons);
    return result;
}

std::string machine_identity(const json& machine) {
    json identity = machine;
    for (const char* key : {"counters", "counted_over", "perf_event_paranoid", "memory_bytes", "unreadable"})
        identity.erase(key);
    return identity.dump();
}

}  // namespace edgewise::measure
