// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/block_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/runner_options.hpp"
#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/measure/process/thread_usage.hpp"
#include "edgewise/scene/answer_claim.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::studies::campaign {

namespace {

/// A way to ask the queries.
struct QueryKind {
    std::string suffix;  ///< of the cell's name
    Needs needs = Needs::witnesses;
    SubDistanceSolver sub_distance = SubDistanceSolver::cofactors;
    bool rounded = false;  ///< the bodies are
};

class RunnerAsker final : public Asker {
  public:
    RunnerAsker(const bench::TableType& type, const std::string& algorithm, const QueryKind& kind)
        : runner_(type.make_runner(algorithm)), has_margin_(kind.rounded || has_margin(kind.needs)) {
        bench::RunnerOptions options{.query = {.sub_distance = kind.sub_distance}};
        if (kind.rounded) options.radius = bench::usual_margin / 2;
        options.set_needs(kind.needs);
        runner_->configure(options);
    }

    [[nodiscard]] std::string load(const scene::Workload& workload) override {
        std::string error = runner_->load(workload);
        if (error.empty() && has_margin_) margin_ = runner_->margin(workload.queries.front());
        return error;
    }
    [[nodiscard]] std::vector<Distance> answer() override { return runner_->answer(); }
    [[nodiscard]] std::span<const Polyhedron> stored_bodies() const override {
        return runner_->stored_bodies();
    }
    [[nodiscard]] std::optional<double> margin() const override { return margin_; }

  private:
    std::unique_ptr<bench::Runner> runner_;
    bool has_margin_;
    std::optional<double> margin_;
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

/// For the distance, within a margin, of rounded bodies; GJK also with Johnson's search and for the verdict.
std::vector<QueryKind> query_kinds(std::string_view algorithm) {
    std::vector<QueryKind> kinds = {
        {}, {.suffix = " within", .needs = Needs::within}, {.suffix = " rounded", .rounded = true}};
    if (algorithm != "gjk") return kinds;
    kinds.push_back({.suffix = " johnson", .sub_distance = SubDistanceSolver::johnson});
    kinds.push_back({.suffix = " verdict", .needs = Needs::verdict});
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

/// Checks a verdict on nearness: by the interval where that proves it, else by exact arithmetic.
truth::CheckedAnswer check_nearness(bool nearer, double margin, const truth::AccuracyBand& band,
                                    const truth::StoredPair& stored, const truth::PosesOfPair& poses,
                                    truth::ProvenPair& known) {
    if (nearer ? known.upper < margin : known.lower >= margin)
        return {.is_bound = true, .has_distance = false, .band = band};
    return truth::check_nearness(nearer, known.answers.exact(stored.placed(poses)), margin, band, 0);
}

}  // namespace

std::vector<Cell> cells_of(std::span<const bench::TableType* const> types,
                           std::span<const std::string> algorithms) {
    std::vector<Cell> cells;
    for (const std::string& algorithm : algorithms) {
        for (const bench::TableType* type : types) {
            if (!type->serves(algorithm)) continue;
            for (const QueryKind& kind : query_kinds(algorithm)) {
                cells.push_back({algorithm + " " + type->name + kind.suffix, type->eps,
                                 allowed_errors(*type, algorithm).distance, kind.needs == Needs::verdict,
                                 kind.rounded,
                                 [=] { return std::make_unique<RunnerAsker>(*type, algorithm, kind); }});
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

truth::CheckedAnswer check_answer(const Distance& answer, const Cell& cell, std::optional<double> margin,
                                  const truth::StoredPair& stored, const truth::PosesOfPair& poses,
                                  truth::ProvenPair& known) {
    const truth::AccuracyBand band = stored.band(known, cell.eps);
    truth::Claim claim = scene::claim_of(answer, cell.verdict_only);
    if (cell.verdict_only) claim.distance = 0;  // a bound, which may be any
    if (margin) {
        const bool nearer = !claim.separated || (!cell.rounded && !(claim.distance >= *margin));
        const auto verdict = check_nearness(nearer, *margin, band, stored, poses, known);
        // Rounded bodies that overlap, and bodies beyond the margin, have no distance.
        if (verdict.wrong() || nearer == cell.rounded) return verdict;
        if (cell.rounded) claim.distance += *margin;
    }
    return truth::check(claim, stored, poses, known, band, {cell.error_allowed});
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

namespace {

/// Adds the thread's seconds since the last call to a sum.
class SecondsBetween {
  public:
    void add_to(double& sum) {
        const double now = measure::thread_seconds();
        sum += now - last_;
        last_ = now;
    }

  private:
    double last_ = measure::thread_seconds();
};

void count_verdict(const truth::ProvenPair& known, FamilyTally& family) {
    family.grazing += known.is_grazing;
    if (known.is_grazing) return;
    family.separated += known.is_separated();
    family.touching += known.verdict == truth::ExactVerdict::touching;
    family.overlapping += known.verdict == truth::ExactVerdict::overlapping;
}

void count_proof(const truth::ProvenPair& known, FamilyTally& family) {
    family.double_proofs += known.by == truth::KnownBy::double_proof;
    family.wide_proofs += known.by == truth::KnownBy::wide_proof;
    family.exact_proofs += known.by == truth::KnownBy::exact;
}

void count_answer(const truth::CheckedAnswer& checked, std::uint64_t pair, FamilyTally& family,
                  CellTally& cell) {
    cell.add({1, 0, checked.in_band, checked.wrong(), checked.worst_beyond(), pair});
    ++family.answers;
    family.in_band += checked.in_band;
    family.wrong += checked.wrong();
    family.exact_answers += !checked.is_bound;
}

void count_block(const Block& block, std::uint64_t count, FamilyTally& family) {
    FamilyTally one;
    one.blocks = 1;
    one.pairs = block.poses.size();
    if (!block.refusal.empty()) one.refused_pairs = count;
    one.least_vertices = std::min(block.a.vertex_count(), block.b.vertex_count());
    one.most_vertices = std::max(block.a.vertex_count(), block.b.vertex_count());
    family.add(one);
}

}  // namespace

BlockRun::BlockRun(std::span<const Cell> cells) : cells_(cells), storage_(cells.size()) {
    for (const Cell& cell : cells) askers_.push_back({cell.make_asker(), cell.make_asker()});
}

std::size_t BlockRun::storage_of(std::span<const Polyhedron> stored) {
    for (std::size_t i = 0; i < storages_.size(); ++i) {
        const auto known = storages_[i].bodies;
        if (known[0].vertices == stored[0].vertices && known[1].vertices == stored[1].vertices) return i;
    }
    storages_.push_back(
        {stored, truth::StoredPair(stored[0].vertices, stored[1].vertices), {}, storages_.empty()});
    return storages_.size() - 1;
}

void BlockRun::load(const scene::Workload& cold, const scene::Workload& warm) {
    storages_.clear();
    refusals_.clear();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        refusals_.push_back(askers_[i].cold->load(cold));
        if (!refusals_.back().empty()) continue;
        (void)askers_[i].warm->load(warm);  // the same bodies
        storage_[i] = storage_of(askers_[i].cold->stored_bodies());
        storages_[storage_[i]].known.resize(cold.queries.size());
    }
}

void BlockRun::ask(std::size_t cell, bool warm, const Block& block, FamilyTally& family, CellTally& tally) {
    SecondsBetween seconds;
    const ColdAndWarm& askers = askers_[cell];
    const std::vector<Distance> answers = (warm ? askers.warm : askers.cold)->answer();
    seconds.add_to(family.asking_s);
    BlockStorage& storage = storages_[storage_[cell]];
    for (std::size_t i = 0; i < answers.size(); ++i) {
        truth::ProvenPair& known = storage.known[i];
        const auto& poses = block.poses[i];
        if (known.by == truth::KnownBy::nothing) {
            known = storage.pair.know(poses, multiply(poses.first.rotation, answers[i].normal));
            count_proof(known, family);
            if (storage.counts) count_verdict(known, family);
        }
        if (answers[i].status == Status::failed) {  // too far from each other for the precision
            ++family.refused;
            ++tally.refused;
            continue;
        }
        const truth::CheckedAnswer checked =
            check_answer(answers[i], cells_[cell], askers.cold->margin(), storage.pair, poses, known);
        const std::uint64_t pair = PairPlace{block_, i}.pair();
        count_answer(checked, pair, family, tally);
        if (const std::string wrong = what_is_wrong(checked, answers[i], storage.pair, poses, known);
            !wrong.empty())
            failures_.push_back({pair, cells_[cell].name, block.family, (warm ? "warm, " : "") + wrong});
    }
    seconds.add_to(family.proving_s);
}

void BlockRun::run(const PairSource& source, std::uint64_t number, std::uint64_t count, Tally& tally,
                   const std::function<void(const Failure&)>& on_failure) {
    SecondsBetween seconds;
    block_ = number;
    const Block block = source.block(number, count);
    FamilyTally& family = tally.families[block.family];
    count_block(block, count, family);
    if (!block.refusal.empty()) return;
    const scene::Workload cold = workload_of(block);
    scene::Workload warm = cold;
    warm.warm = true;
    load(cold, warm);
    seconds.add_to(family.making_s);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        CellTally& cell = tally.cells[cells_[i].name];
        if (refusals_[i].empty()) {
            for (const bool is_warm : {false, true}) ask(i, is_warm, block, family, cell);
        } else {
            cell.refused += 2 * cold.queries.size();
            family.refused += 2 * cold.queries.size();
        }
    }
    for (const Failure& failure : failures_) on_failure(failure);
    failures_.clear();
}

}  // namespace edgewise::studies::campaign
