// SPDX-License-Identifier: MIT
//
// Only the leader is enabled and disabled: its members stay enabled and count while it does. Counts are reset
// for all, which leaves the times alone. glibc has no wrapper for perf_event_open, so the system call is made
// by number.
#include "edgewise/measure/counters/counter_group.hpp"

#include <fmt/core.h>
#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/measure/statistics.hpp"

namespace edgewise::measure {

namespace {

constexpr std::size_t head_words = 3;
constexpr const char* free_counters =
    "end other users of the counters, also the NMI watchdog (sysctl kernel.nmi_watchdog=0); on a hybrid "
    "processor pin the thread to a core that counts these events (taskset)";

/// The descriptor, or -errno. `leader`: of the group to join; -1 for the first, which is pinned and starts
/// disabled.
int open_event(const EventCode& code, int leader) {
    perf_event_attr attributes{};
    attributes.size = sizeof attributes;
    attributes.type = code.type;
    attributes.config = code.config;
    attributes.disabled = leader < 0;
    attributes.pinned = leader < 0;
    attributes.exclude_kernel = !code.kernel_too;
    attributes.exclude_hv = 1;
    attributes.read_format =
        PERF_FORMAT_GROUP | PERF_FORMAT_ID | PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
    // This thread (0), on whatever processor it runs (-1).
    const long result = syscall(SYS_perf_event_open, &attributes, 0, -1, leader, PERF_FLAG_FD_CLOEXEC);
    return result < 0 ? -errno : static_cast<int>(result);
}

/// By nearest rank, so that it is a count that did occur.
std::uint64_t rank(std::vector<std::uint64_t>& counts, std::size_t numerator, std::size_t denominator) {
    const std::size_t index = (counts.size() - 1) * numerator / denominator;
    std::nth_element(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(index), counts.end());
    return counts[index];
}

struct Sorted {
    std::vector<double> good;
    std::size_t faulted = 0, switched = 0, migrated = 0, shared = 0;  ///< a sample may be in several
};

Sorted sort_out(std::span<const CounterSample> samples) {
    Sorted sorted;
    for (const CounterSample& sample : samples) {
        sorted.faulted += sample.page_faults != 0 ? 1 : 0;
        sorted.switched += sample.context_switches != 0 ? 1 : 0;
        sorted.migrated += sample.migrations != 0 ? 1 : 0;
        sorted.shared += sample.shared_its_counter() ? 1 : 0;
        if (sample.is_disturbed() || sample.shared_its_counter()) continue;
        sorted.good.push_back(static_cast<double>(sample.count));
    }
    return sorted;
}

std::string why_dropped(const Sorted& sorted, std::size_t total) {
    return fmt::format(
        "of {} samples only {} are good: {} had page faults, {} context switches, {} a change of the "
        "processor, {} shared their counter",
        total, sorted.good.size(), sorted.faulted, sorted.switched, sorted.migrated, sorted.shared);
}

}  // namespace

CounterGroup::CounterGroup(std::span<const EventCode> events) {
    if (events.empty() || events.size() > largest_group) error_ = EINVAL;
    for (; error_ == 0 && size_ < events.size(); ++size_) {
        descriptors_[size_] = open_event(events[size_], descriptors_[0]);  // -1 until there is a leader
        if (descriptors_[size_] < 0)
            error_ = -descriptors_[size_];
        else if (ioctl(descriptors_[size_], PERF_EVENT_IOC_ID, &ids_[size_]) != 0)
            error_ = errno;
    }
    if (error_ != 0) close_all();
}

void CounterGroup::close_all() {
    for (std::size_t i = largest_group; i-- > 0;) {
        if (descriptors_[i] >= 0) close(descriptors_[i]);
        descriptors_[i] = -1;
    }
}

bool CounterGroup::start() {
    return error_ == 0 && ioctl(descriptors_[0], PERF_EVENT_IOC_RESET, PERF_IOC_FLAG_GROUP) == 0 &&
           ioctl(descriptors_[0], PERF_EVENT_IOC_ENABLE, 0) == 0;
}

Expected<GroupCount> CounterGroup::stop() {
    std::array<std::uint64_t, head_words + 2 * largest_group> words{};
    if (error_ != 0) return Refusal{"the group is not open", "open it where its events exist"};
    if (ioctl(descriptors_[0], PERF_EVENT_IOC_DISABLE, 0) != 0)
        return Refusal{"the kernel does not stop the group", "try again"};
    const std::int64_t bytes = read(descriptors_[0], words.data(), sizeof words);
    Expected<GroupCount> result = parse_group(words, bytes, std::span(ids_).first(size_));
    if (!result.value) return result;
    GroupCount& count = *result.value;
    count.enabled_ns -= std::exchange(enabled_before_, count.enabled_ns);
    count.running_ns -= std::exchange(running_before_, count.running_ns);
    return whole_time_only(count);
}

Expected<GroupCount> parse_group(std::span<const std::uint64_t> words, std::int64_t bytes,
                                 std::span<const std::uint64_t> ids) {
    const std::size_t needed = head_words + 2 * ids.size();
    if (bytes == 0)
        return Refusal{"not enough free counters for the group: it is in error (end of file)", free_counters};
    if (bytes != static_cast<std::int64_t>(needed * sizeof(std::uint64_t)) || words.size() < needed ||
        words[0] != ids.size()) {
        return Refusal{fmt::format("the kernel gave {} bytes, not {} events", bytes, ids.size()),
                       "try again, or use another kernel"};
    }
    GroupCount count;
    count.enabled_ns = words[1];
    count.running_ns = words[2];
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto* const id = std::find(ids.data(), ids.data() + ids.size(), words[head_words + 2 * i + 1]);
        if (id == ids.data() + ids.size())
            return Refusal{"the kernel counted an event that was not asked for", "try again"};
        count.values[static_cast<std::size_t>(id - ids.data())] = words[head_words + 2 * i];
    }
    return {count};
}

Expected<GroupCount> whole_time_only(const GroupCount& count) {
    if (count.enabled_ns != 0 && count.running_ns == count.enabled_ns) return {count};
    return Refusal{fmt::format("on the counters for only {} of {} ns, and a scaled count is a guess",
                               count.running_ns, count.enabled_ns),
                   free_counters};
}

Expected<CountingCost> counting_cost(std::span<const std::uint64_t> empty_batches) {
    if (empty_batches.size() < least_empty_batches)
        return Refusal{
            fmt::format("{} empty batches say too little of what counting costs", empty_batches.size()),
            fmt::format("count at least {}", least_empty_batches)};
    std::vector<std::uint64_t> counts(empty_batches.begin(), empty_batches.end());
    const std::uint64_t overhead = rank(counts, 1, 2);
    return {CountingCost{overhead, std::max<std::uint64_t>(rank(counts, 9, 10), 1)}};
}

Expected<CounterFigure> count_per_query(std::span<const CounterSample> samples, const CountingCost& cost,
                                        std::size_t queries) {
    if (queries == 0) return Refusal{"no queries in the batch", "count a batch that has some"};
    const Sorted sorted = sort_out(samples);
    if (sorted.good.size() < least_samples)
        return Refusal{why_dropped(sorted, samples.size()),
                       "leave the machine to this program, pin it to a processor, and count more often or in "
                       "shorter batches"};
    const double batch = median(sorted.good).value_or(0) - static_cast<double>(cost.overhead);
    const double least = static_cast<double>(least_to_floor * cost.floor);
    if (batch < least)
        return Refusal{
            fmt::format("fewer than {} in a batch of {} queries, so below {:.3g} per query: too few to "
                        "distinguish from events that counting itself may cause ({})",
                        least, queries, least / static_cast<double>(queries), cost.floor),
            "count a batch of more queries"};
    return {CounterFigure{batch / static_cast<double>(queries), sorted.good.size(),
                          samples.size() - sorted.good.size()}};
}

}  // namespace edgewise::measure
