// SPDX-License-Identifier: MIT
//
// An algorithm on a table type made ready: its tables built, its answers checked, each of them ready to be
// timed; and the turns that such cells take, so that all are affected equally by changes in machine speed.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/measure/answer_counts.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/sweep/plan.hpp"
#include "edgewise/truth/checked_answer.hpp"
#include "edgewise/truth/known_pair.hpp"

namespace edgewise::sweep {

// One scene on one shape: the queries that every cell of a comparison answers, and their exact answers. Exact
// answers depend on the bodies alone, so cells that store the same bodies share them.

class SharedQueries {
  public:
    /// Throws std::invalid_argument when the scene cannot be made.
    SharedQueries(const Plan& plan, const SceneChoice& scene, const scene::NamedShape& shape);

    [[nodiscard]] const scene::Workload& workload() const { return workload_; }
    /// The same queries, none of which knows its pair's last answer.
    [[nodiscard]] const scene::Workload& cold_workload();

    /// Positions of the checked queries, spread evenly over the workload.
    [[nodiscard]] const std::vector<std::size_t>& checked() const { return checked_; }

    /// The checked queries between these bodies, in the order of checked(): their exact distances are known.
    [[nodiscard]] std::vector<truth::KnownPair>& known(std::span<const Polyhedron> bodies);

    /// What the paper's control says of them, in contact or not (truth/moore_wilhelms.hpp); empty where
    /// the plan does not ask it, and nothing for most of large bodies, where it takes too long.
    [[nodiscard]] const std::vector<std::optional<bool>>& control(std::span<const Polyhedron> bodies);

  private:
    bool asks_control_;
    scene::Workload workload_;
    std::optional<scene::Workload> cold_workload_;  ///< once it was asked for
    std::vector<std::size_t> checked_;
    std::map<std::string, std::vector<truth::KnownPair>> known_;  // by the bodies' fingerprint
    std::map<std::string, std::vector<std::optional<bool>>> control_;
};

using MarginOf = std::function<double(const scene::Query&)>;

/// The checked answers of one cell. `stored` are the bodies its tables hold; eps the rounding step that
/// computes, which alone decides the errors allowed; `options` what the answers were allowed to give away.
/// With a margin they are verdicts on nearness (bench::near_answer).
[[nodiscard]] std::vector<truth::CheckedAnswer> check_answers(SharedQueries& shared,
                                                              std::span<const Polyhedron> stored,
                                                              std::span<const Distance> answers, double eps,
                                                              const QueryOptions& options = {},
                                                              const MarginOf& margin = {});

/// Empty when every checked answer is right; else what is wrong, with the first case as example.
[[nodiscard]] std::string what_is_wrong(const SharedQueries& shared,
                                        std::span<const truth::CheckedAnswer> checked, double eps);

/// `cold`: a flag per query, as cold_starts says; of a scene without warm pairs all count as cold.
[[nodiscard]] measure::AnswerCounts count_answers(std::span<const Distance> answers,
                                                  std::span<const std::uint8_t> cold = {});

class PreparedCell {
  public:
    PreparedCell(const bench::TableType& type, const std::string& algorithm,
                 const bench::RunnerOptions& options = {});

    /// Builds the tables. An error line when a body cannot be stored. The workload must stay.
    [[nodiscard]] std::string load(const scene::Workload& workload);

    /// Answers every loaded query and checks the sample: `shared` has the same queries.
    void check(SharedQueries& shared);

    [[nodiscard]] const bench::TableType& type() const { return *type_; }
    [[nodiscard]] const bench::Runner& runner() const { return *runner_; }
    [[nodiscard]] const scene::Workload& workload() const { return *workload_; }

    /// What check() found: the sample's answers, what is wrong with them (empty: nothing), and counts of all.
    [[nodiscard]] const std::vector<truth::CheckedAnswer>& checked() const { return checked_; }
    [[nodiscard]] const std::string& wrong() const { return wrong_; }
    [[nodiscard]] const measure::AnswerCounts& counts() const { return counts_; }
    [[nodiscard]] double mean_steps() const;
    /// Sum of the first answers' distances, in order.
    [[nodiscard]] double distances(std::size_t queries) const;

    /// One timed pass; contact is booked apart where check() found any.
    [[nodiscard]] measure::Timing time(double clock_cost_ns) const {
        return runner_->time(in_contact_, clock_cost_ns);
    }
    /// ns per query: the faster of two passes. The first finds its tables out of the caches, and an interrupt
    /// seldom hits both.
    [[nodiscard]] double ns_per_query(double clock_cost_ns) const;

  private:
    const bench::TableType* type_;
    bench::RunnerOptions options_;
    std::unique_ptr<bench::Runner> runner_;
    const scene::Workload* workload_ = nullptr;
    std::vector<std::uint8_t> in_contact_;  ///< of every query; empty where the answers do not say
    std::vector<double> distances_;         ///< the answers' sums, query by query
    std::vector<truth::CheckedAnswer> checked_;
    std::string wrong_;
    measure::AnswerCounts counts_;
};

/// Calls `take(i)` once for each i below `count`, in an order drawn from the seed: that of a round.
void take_turns(std::size_t count, std::uint64_t seed, const std::function<void(std::size_t)>& take);

}  // namespace edgewise::sweep
