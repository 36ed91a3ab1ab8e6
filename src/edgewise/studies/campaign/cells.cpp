// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/cells.hpp"

#include <fmt/format.h>

#include <map>

#include "edgewise/bench/cell.hpp"
#include "edgewise/scene/answer_claim.hpp"
#include "edgewise/studies/campaign/pair_source.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::studies::campaign {

namespace {

class RunnerAsker final : public Asker {
  public:
    RunnerAsker(const bench::TableType& type, const std::string& algorithm, const QueryOptions& query)
        : runner_(type.make_runner(algorithm)) {
        bench::RunnerOptions options;
        options.query = query;
        if (query.verdict_only) options.set_needs(Needs::verdict);
        runner_->configure(options);
    }

    [[nodiscard]] std::string load(const scene::Workload& workload) override {
        return runner_->load(workload);
    }
    [[nodiscard]] std::vector<Distance> answer() override { return runner_->answer(); }
    [[nodiscard]] std::span<const Polyhedron> stored_bodies() const override {
        return runner_->stored_bodies();
    }

  private:
    std::unique_ptr<bench::Runner> runner_;
};

void add(bench::Fingerprint& print, const Vec3d& v) { print.add(v.x()).add(v.y()).add(v.z()); }

constexpr std::uint64_t class_seed = 20010168;  ///< of the pairs that distinguish the classes
constexpr std::uint64_t class_pairs = 200;      ///< of each family

std::vector<Block> class_blocks() {
    const PairSource source(class_seed, {}, {"tetra4", "cube8", "sphere38", "sphere386"});
    std::vector<Block> blocks;
    for (std::uint64_t i = 0; i < 2 * source.families().size(); ++i) {
        Block block = source.block(i, class_pairs);
        if (block.refusal.empty()) blocks.push_back(std::move(block));
    }
    return blocks;
}

struct QueryKind {
    std::string suffix;  ///< of the cell's name
    QueryOptions options;
};

std::vector<QueryKind> query_kinds(std::string_view algorithm) {
    std::vector<QueryKind> kinds(1);
    if (algorithm != "gjk") return kinds;
    kinds.push_back({" johnson", {.sub_distance = SubDistanceSolver::johnson}});
    kinds.push_back({" verdict", {.verdict_only = true}});
    return kinds;
}

std::string answers_of(const Cell& cell, const std::vector<scene::Workload>& workloads) {
    bench::Fingerprint print;
    for (const scene::Workload& workload : workloads) {
        const auto asker = cell.make_asker();
        const std::string error = asker->load(workload);
        print.add(error);
        if (!error.empty()) continue;
        for (const Distance& answer : asker->answer()) {
            print.add(static_cast<std::uint64_t>(answer.status)).add(answer.distance);
            add(print, answer.point_a);
            add(print, answer.point_b);
            add(print, answer.normal);
        }
    }
    return print.hex();
}

}  // namespace

std::vector<Cell> cells_of(std::span<const bench::TableType* const> types,
                           std::span<const std::string> algorithms) {
    std::vector<Cell> cells;
    for (const std::string& algorithm : algorithms) {
        for (const bench::TableType* type : types) {
            if (!type->serves(algorithm)) continue;
            for (const QueryKind& kind : query_kinds(algorithm)) {
                const QueryOptions query = kind.options;
                cells.push_back({algorithm + " " + type->name + kind.suffix, type->eps,
                                 allowed_errors(*type, algorithm).distance, query.verdict_only,
                                 [=] { return std::make_unique<RunnerAsker>(*type, algorithm, query); }});
            }
        }
    }
    return cells;
}

std::vector<Cell> one_of_each_class(std::vector<Cell> cells) {
    std::vector<scene::Workload> workloads;
    for (const Block& block : class_blocks()) workloads.push_back(workload_of(block));
    std::map<std::string, std::size_t> first;  // answers -> place in the result
    std::vector<Cell> result;
    for (Cell& cell : cells) {
        const auto [place, is_new] = first.try_emplace(answers_of(cell, workloads), result.size());
        if (is_new)
            result.push_back(std::move(cell));
        else
            result[place->second].as_well.push_back(cell.name);
    }
    return result;
}

truth::CheckedAnswer check_answer(const Distance& answer, const Cell& cell, const truth::StoredPair& stored,
                                  const truth::PosesOfPair& poses, truth::ProvenPair& known) {
    truth::Claim claim = scene::claim_of(answer, cell.verdict_only);
    if (cell.verdict_only) claim.distance = 0;  // a bound, which may be any
    return truth::check(claim, stored, poses, known, stored.band(known, cell.eps), {cell.error_allowed});
}

std::string what_is_wrong(const truth::CheckedAnswer& checked, const Distance& answer,
                          const truth::StoredPair& stored, const truth::PosesOfPair& poses,
                          truth::ProvenPair& known) {
    if (!checked.wrong()) return {};
    const truth::PlacedBodies bodies = stored.placed(poses);
    const truth::ExactDistance& exact = known.answers.exact(bodies);
    const bool deep = answer.status == Status::separated && exact.verdict != truth::ExactVerdict::separated;
    return fmt::format(
        "{}: {} at {:.17g}, witness points {:.3g} off, exactly {} at {:.17g}{}; band {:.3g}, scale {:.3g}",
        checked.verdict_wrong ? "wrong verdict" : "wrong distance", to_string(answer.status), answer.distance,
        checked.witness_error, to_string(exact.verdict), exact.distance,
        deep ? fmt::format(", {:.3g} deep", known.answers.depth(bodies)) : "", checked.band.band,
        checked.band.scale);
}

}  // namespace edgewise::studies::campaign
