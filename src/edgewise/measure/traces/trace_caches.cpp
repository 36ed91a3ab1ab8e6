// SPDX-License-Identifier: MIT
#include "edgewise/measure/traces/trace_caches.hpp"

namespace edgewise::measure {

namespace {

constexpr std::uint64_t line_bytes = 64;

}  // namespace

TraceCaches::TraceCaches(std::span<const CacheMachine> machines) {
    for (const CacheMachine& machine : machines) {
        std::vector<CacheModel>& models = machines_.emplace_back();
        models.emplace_back(machine.caches);
        if (!machine.tlbs.levels.empty()) models.emplace_back(machine.tlbs);
    }
}

void TraceCaches::access(const FileAccess& access) {
    for (std::vector<CacheModel>& models : machines_)
        for (CacheModel& model : models) model.access(access.address, access.bytes, access.kind);
    const std::uint64_t last = (access.address + (access.bytes - 1)) / line_bytes;
    for (std::uint64_t line = access.address / line_bytes; line <= last; ++line) {
        // Addresses of programs lie far apart, and reuse distances want small numbers.
        if (line != last_line_ || numbers_.empty())
            last_number_ = numbers_.try_emplace(line, numbers_.size()).first->second;
        last_line_ = line;
        reuse_.use(last_number_);
    }
}

std::vector<TraceCaches::Level> TraceCaches::levels(std::size_t machine) const {
    std::vector<Level> all;
    for (const CacheModel& model : machines_[machine])
        for (std::size_t i = 0; i < model.counts().size(); ++i)
            all.push_back({model.geometry().levels[i].name, model.counts(i)});
    return all;
}

std::uint64_t TraceCaches::knee_bytes() const { return knee(reuse_.curve(), reuse_.lines()) * line_bytes; }

std::uint64_t TraceCaches::misses(std::uint64_t bytes) const {
    return reuse_.curve().misses(bytes / line_bytes);
}

}  // namespace edgewise::measure
