// SPDX-License-Identifier: MIT
#include "edgewise/bench/runner.hpp"

#include <algorithm>
#include <cassert>
#include <exception>
#include <limits>
#include <new>

#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise::bench {

namespace {

/// Queries first .. end - 1 are of one class, with no cold start after the first.
std::size_t end_of_stretch(const std::vector<std::uint8_t>& cold, std::span<const std::uint8_t> in_contact,
                           std::size_t first) {
    const auto is_one_class = [&](std::size_t i) {
        return in_contact.empty() || in_contact[i] == in_contact[first];
    };
    std::size_t end = first + 1;
    while (end < cold.size() && is_one_class(end) && !cold[end]) ++end;
    return end;
}

void book(measure::Timing& timing, std::span<const std::uint8_t> in_contact, std::size_t first,
          std::size_t last, double ns) {
    const bool known = !in_contact.empty(), overlapping = known && in_contact[first] != 0;
    (overlapping ? timing.overlapping_ns : known ? timing.separated_ns : timing.either_ns) += ns;
    (overlapping ? timing.overlapping_queries
     : known     ? timing.separated_queries
                 : timing.either_queries) += last - first;
}

/// Passes before a timed one. One is not enough where it is short: processors may keep a line in the last
/// cache only when it comes again. After one pass of 2000 queries of 200 tables of 193 kB a query took 1.5
/// times as long as after many, after two 1.08 times.
int untimed_passes(const scene::Workload& workload) { return workload.queries.size() < 3000 ? 2 : 1; }

measure::Timing time_pass(const Runner::RangePass& run, const scene::Workload& workload,
                          std::span<const std::uint8_t> in_contact, double clock_cost_ns) {
    measure::Timing timing;
    double sum = 0;  // sum of all distances: without a use of the answers the compiler might drop them
    for (int pass = 0; pass < untimed_passes(workload); ++pass)
        sum += run(0, workload.queries.size(), nullptr);
    // Time to set back all pairs, which the first stretch includes. The least of three: an interrupt in a
    // single reading would be subtracted from the queries' time.
    double setting_back = std::numeric_limits<double>::infinity();
    for (int reading = 0; reading < 3; ++reading) {
        const measure::Stopwatch watch;
        sum += run(0, 0, nullptr);
        setting_back = std::min(setting_back, watch.elapsed_ns());
    }
    const std::vector<std::uint8_t> cold = cold_starts(workload);
    for (std::size_t first = 0; first < cold.size();) {
        const std::size_t last = cold[first] ? first + 1 : end_of_stretch(cold, in_contact, first);
        const measure::Stopwatch watch;
        sum += run(first, last, nullptr);
        const double beside = first == 0 ? std::max(setting_back, clock_cost_ns) : clock_cost_ns;
        const double ns = std::max(0.0, watch.elapsed_ns() - beside);
        if (cold[first]) {
            ++timing.first_queries;
            timing.first_ns += ns;
        } else {
            book(timing, in_contact, first, last, ns);
        }
        first = last;
    }
    volatile double sink = sum;
    static_cast<void>(sink);
    return timing;
}

}  // namespace

void Runner::configure(const RunnerOptions& options) {
    given_options_ = options;
    given_options_.set_needs(options.needs);
}

std::string Runner::load(std::span<const Polyhedron> bodies) { return load_tables(bodies, {}); }

std::string Runner::load(const scene::Workload& workload) {
    const Sharing sharing = given_options_.tables.sharing;
    const bool each =
        sharing == Sharing::per_instance || (sharing == Sharing::as_scene && workload.table_each);
    std::string error = load_tables(workload.bodies, each ? std::span<const std::uint32_t>(workload.instances)
                                                          : std::span<const std::uint32_t>());
    if (!error.empty()) return error;
    prepared_.take_queries(workload);
    return take_radii(workload);
}

/// The given bodies' extents count, so that every table is asked the same.
std::string Runner::take_radii(const scene::Workload& workload) {
    const LengthScale& scale = prepared_.scale();
    if (options_.recorded_radii && workload.radii.empty())
        return "the scene records no radii: leave radius=recorded out";
    if (options_.recorded_radii)
        for (const double radius : workload.radii) radii_.push_back(scale.into(radius));
    else if (options_.radius > 0)
        for (const std::uint32_t body : workload.instances)
            radii_.push_back(options_.radius * extent(scale.into(workload.bodies[body]).vertices));
    return {};
}

std::string Runner::load_tables(std::span<const Polyhedron> bodies,
                                std::span<const std::uint32_t> instances) {
    build_tables({});
    std::string error = prepared_.take_bodies(bodies, given_options_.tables.order,
                                              [this](const Polyhedron& body) { return store(body); });
    if (!error.empty()) return error;
    options_ = given_options_;
    options_.query = prepared_.scale().into(given_options_.query);
    margins_ = {};
    radii_.clear();
    if (asks_nearness())
        margins_ = {options_.margin, options_.needs == Needs::within, bodies, prepared_.bodies(),
                    prepared_.scale()};
    table_each_ = !instances.empty();
    std::vector<const Polyhedron*> of_tables;
    for (const std::uint32_t body : instances) of_tables.push_back(&prepared_.bodies()[body]);
    if (!table_each_) {
        for (const Polyhedron& body : prepared_.bodies()) of_tables.push_back(&body);
    }
    try {
        memory_ = make_allocator(options_.tables.allocator);
        const TablesIn placed(*memory_);
        build_tables(of_tables);
    } catch (const std::bad_alloc&) {
        return "tables: out of memory: ask for fewer or smaller bodies";
    } catch (const std::exception& problem) {  // an allocator that is not there, or has no more
        return std::string("tables: ") + problem.what();
    }
    return {};
}

double Runner::margin(const scene::Query& query) const {
    if (asks_nearness()) return prepared_.scale().back(margins_.margin(query));
    return radii_.empty() ? 0 : prepared_.scale().back(radii_[query.instance_a] + radii_[query.instance_b]);
}

std::vector<Distance> Runner::answer() const {
    const std::vector<scene::Query>& queries = prepared_.workload().queries;
    std::vector<Distance> answers(queries.size());
    prepared_range()(0, queries.size(), answers.data());
    for (std::size_t i = 0; i < answers.size(); ++i)
        answers[i] = in_range(queries[i]) ? prepared_.scale().back(answers[i]) : Distance{};
    return answers;
}

measure::Timing Runner::time(std::span<const std::uint8_t> in_contact, double clock_cost_ns) const {
    assert(in_contact.empty() || in_contact.size() == prepared_.workload().queries.size());
    if (options_.batch && !in_contact.empty()) {
        const ClassByClass sorted(prepared_.workload(), in_contact);
        if (const RangePass batches = batches_of(sorted.workload))
            return time_pass(batches, sorted.workload, sorted.in_contact, clock_cost_ns);
    }
    return time_pass(prepared_range(), prepared_.workload(), in_contact, clock_cost_ns);
}

std::function<PassSum()> Runner::prepared_pass() const {
    return [this, count = prepared_.workload().queries.size(), pass = prepared_range()] {
        return prepared_.scale().back(PassSum{count, pass(0, count, nullptr)});
    };
}

MemoryUse Runner::memory() const {
    MemoryUse use;
    use.tables = table_count();
    use.requested = static_cast<double>(memory_->requested());
    use.taken = static_cast<double>(memory_->taken());
    if (const auto resident = memory_->resident()) use.resident = static_cast<double>(*resident);
    use.materialised = materialised();
    return use;
}

}  // namespace edgewise::bench
