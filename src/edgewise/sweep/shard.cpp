// SPDX-License-Identifier: MIT
#include "edgewise/sweep/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "edgewise/bench/cell.hpp"
#include "edgewise/input/count.hpp"

namespace edgewise::sweep {

namespace {

constexpr input::CountRange shards_range{1, 100'000, "shards"};

struct Scheduler {
    const char *index, *count;  ///< variables; null: it does not say how many
    std::uint64_t first;        ///< index
};

constexpr Scheduler schedulers[] = {{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", 0},
                                    {"JOB_COMPLETION_INDEX", nullptr, 0},
                                    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", 0},
                                    {"PBS_ARRAY_INDEX", nullptr, 0},
                                    {"SGE_TASK_ID", "SGE_TASK_LAST", 1},
                                    {"PARALLEL_SEQ", nullptr, 1}};

/// The first scheduler that says an index; others set theirs to texts such as "undefined".
std::optional<std::pair<Scheduler, std::uint64_t>> scheduled(const Environment& environment) {
    for (const Scheduler& scheduler : schedulers) {
        const char* const text = environment(scheduler.index);
        if (!text) continue;
        const auto index = input::parse_count(text, {scheduler.first, UINT32_MAX});
        if (index) return std::pair(scheduler, *index - scheduler.first);
    }
    return std::nullopt;
}

Result<Shard> checked(std::uint64_t index, const std::string& count_text) {
    const auto count = input::parse_count(count_text, shards_range);
    if (!count) return Result<Shard>::failure("--shard " + count.error);
    if (index >= *count)
        return Result<Shard>::failure(
            fmt::format("--shard {}/{}: shards of {} count from 0 to {}", index, *count, *count, *count - 1));
    return Result<Shard>::success({index, *count});
}

Result<Shard> automatic(const std::string& count_text, const Environment& environment) {
    const auto found = scheduled(environment);
    if (!found) {
        std::string known;
        for (const Scheduler& scheduler : schedulers)
            known += std::string(known.empty() ? "" : ", ") + scheduler.index;
        return Result<Shard>::failure("--shard auto: no scheduler says which; write i/n, or set one of " +
                                      known);
    }
    const auto& [scheduler, index] = *found;
    if (!count_text.empty()) return checked(index, count_text);
    const char* const count = scheduler.count ? environment(scheduler.count) : nullptr;
    if (!count)
        return Result<Shard>::failure(
            fmt::format("--shard auto: {} says which but not of how many; write auto/n", scheduler.index));
    return checked(index, count);
}

}  // namespace

std::string Shard::text() const { return fmt::format("{}/{}", index, count); }

Result<Shard> parse_shard(const std::string& text, const Environment& environment) {
    const std::size_t slash = text.find('/');
    const std::string index = text.substr(0, slash),
                      count = slash == std::string::npos ? "" : text.substr(slash + 1);
    if (index == "auto") return automatic(count, environment);
    const auto number = input::parse_count(index, {0, shards_range.most});
    if (slash == std::string::npos || !number)
        return Result<Shard>::failure(
            fmt::format("--shard {}: write i/n, such as 0/8 to 7/8, or auto, or auto/n", text));
    return checked(*number, count);
}

void weigh(std::span<ShardUnit> units, const std::map<std::string, double>& seconds) {
    double known = 0, predicted = 0;
    for (const ShardUnit& unit : units) {
        const auto found = seconds.find(unit.name);
        if (found == seconds.end()) continue;
        known += found->second;
        predicted += unit.cost;
    }
    const double seconds_each = known > 0 && predicted > 0 ? known / predicted : 1;
    for (ShardUnit& unit : units) {
        const auto found = seconds.find(unit.name);
        unit.cost = found == seconds.end() ? unit.cost * seconds_each : found->second;
    }
}

std::vector<std::size_t> dealt_to(const Shard& shard, std::span<const ShardUnit> units) {
    std::vector<std::size_t> order(units.size()), mine;
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) {
        return std::tuple(-units[i].cost, bench::Fingerprint().add(units[i].name).value(), units[i].name);
    });
    std::vector<double> load(shard.count, 0);
    for (const std::size_t unit : order) {
        const auto least = static_cast<std::size_t>(std::ranges::min_element(load) - load.begin());
        load[least] += units[unit].cost;
        if (least == shard.index) mine.push_back(unit);
    }
    std::ranges::sort(mine);
    return mine;
}

std::set<std::string> names_dealt_to(const Shard& shard, std::vector<ShardUnit> units,
                                     const std::map<std::string, double>& seconds) {
    weigh(units, seconds);
    std::set<std::string> names;
    for (const std::size_t unit : dealt_to(shard, units)) names.insert(units[unit].name);
    return names;
}

}  // namespace edgewise::sweep
