// SPDX-License-Identifier: MIT
#include "edgewise/studies/threads/scaling.hpp"

#include <fmt/format.h>
#include <tbb/info.h>

#include <set>
#include <stdexcept>
#include <thread>

#include "edgewise/measure/statistics.hpp"
#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::studies {

CellCopy::CellCopy(const SingleCell& cell, const bench::RunnerOptions& options)
    : workload_(std::make_unique<scene::Workload>(cell.workload())),
      cell_(cell.type(), cell.algorithm(), options) {
    if (const std::string error = cell_.load(*workload_); !error.empty()) throw std::invalid_argument(error);
    pass_ = cell_.runner().prepared_frames();
}

TimedPass time_shared(bench::ThreadedPass& pass, int threads) {
    pass.set_back();
    pass.run(threads);
    pass.set_back();
    const measure::Stopwatch watch;
    pass.run(threads);
    const double ns = watch.elapsed_ns();
    return {ns, pass.sum()};
}

std::vector<TimedPass> time_apart(std::span<const CellCopy> copies) {
    std::vector<TimedPass> times(copies.size());
    std::atomic<std::size_t> ready = 0, done = 0;
    const auto race = [&](std::size_t i) {
        bench::ThreadedPass& pass = copies[i].pass();
        pass.set_back();
        pass.run(1);
        ++ready;
        while (ready < copies.size()) pass.run(1);
        pass.set_back();
        const measure::Stopwatch watch;
        pass.run(1);
        times[i].ns = watch.elapsed_ns();
        ++done;
        times[i].sum = pass.sum();
        while (done < copies.size()) pass.run(1);
    };
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < copies.size(); ++i) threads.emplace_back(race, i);
    }
    return times;
}

namespace {

/// What one number of threads took, by round.
struct RoundTimes {
    std::vector<double> shared_rate, apart_rate;  ///< queries per second of all threads
    std::vector<double> apart_ns;                 ///< median of the threads' own, of a pass
};

bench::RunnerOptions runner_options(const CellChoice& choice) {
    if (has_margin(choice.needs) || choice.needs > Needs::witnesses)
        throw std::invalid_argument(
            fmt::format("needs {}: batches answer verdict, distance or witnesses only; choose one",
                        to_string(choice.needs)));
    bench::RunnerOptions options;
    options.query.sub_distance = choice.sub_distance;
    options.set_needs(choice.needs);
    return options;
}

double middle(std::vector<double> values) { return measure::median(values).value_or(0); }

/// Rates of the same rounds over those of one thread.
WayOfSharing way_of(int threads, const std::vector<double>& rates, const std::vector<double>& of_one) {
    WayOfSharing way;
    way.queries_per_second = middle(rates);
    way.speed_up = middle(measure::paired_ratios(rates, of_one));
    way.efficiency = way.speed_up / threads;
    return way;
}

class ScalingRun {
  public:
    explicit ScalingRun(const ScalingPlan& plan)
        : plan_(plan), options_(runner_options(plan.cell)), cell_(plan.cell), times_(plan.threads.size()) {
        shared_ = cell_.runner().prepared_frames();
        if (!shared_)
            throw std::invalid_argument(fmt::format(
                "{}: queries write to this table, so it serves one thread at a time: name another table",
                cell_.type().name));
        for (int i = 0; i < plan.threads.back(); ++i) copies_.emplace_back(cell_, options_);
        const std::size_t queries = cell_.workload().queries.size();
        single_sum_ = cell_.runner().prepared_range()(0, queries, nullptr);
        found_.table = cell_.type().name;
        found_.algorithm = cell_.algorithm();
        found_.queries = queries;
        found_.frames = shared_->frames();
        found_.table_bytes = cell_.runner().memory().requested;
        found_.checked = cell_.prepared().checked().size();
        found_.wrong = cell_.prepared().wrong();
    }

    [[nodiscard]] bool is_wrong() const { return !found_.wrong.empty(); }

    void round() {
        for (std::size_t i = 0; i < plan_.threads.size() && !is_wrong(); ++i) {
            const int threads = plan_.threads[i];
            const TimedPass together = time_shared(*shared_, threads);
            check_sum(together, threads, "share the tables");
            const std::vector<TimedPass> alone =
                time_apart(std::span(copies_).first(static_cast<std::size_t>(threads)));
            for (const TimedPass& pass : alone) check_sum(pass, threads, "have their own");
            book(together, alone, times_[i]);
        }
        ++found_.rounds;
    }

    [[nodiscard]] Scaling take() {
        const bool nothing = is_wrong() || times_.front().shared_rate.empty();
        for (std::size_t i = 0; i < plan_.threads.size() && !nothing; ++i) found_.rows.push_back(row(i));
        return found_;
    }

  private:
    void check_sum(const TimedPass& pass, int threads, const char* how) {
        ++found_.passes;
        if (!is_wrong()) found_.wrong = compare_sums(pass.sum, single_sum_, threads, how);
    }

    void book(const TimedPass& together, const std::vector<TimedPass>& alone, RoundTimes& times) const {
        const double pass_of_seconds = static_cast<double>(found_.queries) * 1e9;
        std::vector<double> ns;
        double rate = 0;
        for (const TimedPass& pass : alone) {
            ns.push_back(pass.ns);
            rate += pass_of_seconds / pass.ns;
        }
        times.shared_rate.push_back(pass_of_seconds / together.ns);
        times.apart_ns.push_back(middle(ns));
        times.apart_rate.push_back(rate);
    }

    /// The plan's first number of threads is one.
    [[nodiscard]] ScalingRow row(std::size_t i) const {
        const int threads = plan_.threads[i];
        return {threads, way_of(threads, times_[i].shared_rate, times_[0].shared_rate),
                way_of(threads, times_[i].apart_rate, times_[0].apart_rate),
                middle(measure::paired_ratios(times_[i].apart_ns, times_[0].apart_ns))};
    }

    const ScalingPlan& plan_;
    bench::RunnerOptions options_;
    SingleCell cell_;
    std::vector<CellCopy> copies_;
    std::unique_ptr<bench::ThreadedPass> shared_;
    double single_sum_ = 0;
    std::vector<RoundTimes> times_;  ///< by place in the plan
    Scaling found_;
};

}  // namespace

int usable_cores() { return tbb::info::default_concurrency(); }

std::vector<int> scaling_threads(std::span<const int> asked, int cores) {
    std::set<int> threads = {1};
    for (const int count : asked) {
        if (count < 1 || count > cores)
            throw std::invalid_argument(fmt::format(
                "--threads {}: this program has {} cores, and threads that take turns on one do not scale; "
                "ask for 1 to {}",
                count, cores, cores));
        threads.insert(count);
    }
    if (asked.empty()) {
        for (int count = 1; count < cores; count *= 2) threads.insert(count);
        threads.insert(cores);
    }
    return {threads.begin(), threads.end()};
}

std::string compare_sums(double sum, double single, int threads, const char* that_do) {
    if (sum == single) return {};
    return fmt::format("{} threads that {} gave other answers: distances add up to {}, not {}", threads,
                       that_do, sum, single);
}

Scaling measure_scaling(const ScalingPlan& plan, const std::function<void()>& on_round,
                        const std::atomic<bool>& stop) {
    ScalingRun run(plan);
    for (int i = 0; i < plan.rounds && !stop && !run.is_wrong(); ++i) {
        run.round();
        on_round();
    }
    return run.take();
}

}  // namespace edgewise::studies
