// SPDX-License-Identifier: MIT
#include "edgewise/studies/stability/stability.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/certificates.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/answer_claim.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/studies/single_cell.hpp"
#include "edgewise/truth/exact_body.hpp"
#include "edgewise/truth/moore_wilhelms.hpp"

namespace edgewise::studies {

namespace {

bool same_bodies(const scene::hard::Pair& p, const scene::hard::Pair& q) {
    return p.a.vertices == q.a.vertices && p.b.vertices == q.b.vertices && p.a.faces == q.a.faces &&
           p.b.faces == q.b.faces;
}

}  // namespace

StabilityCases::StabilityCases(const scene::HardFamily& family, std::size_t count, std::uint64_t seed,
                               bool single, std::span<const Polyhedron> real) {
    scene::hard::Maker maker(seed, single, real);
    scene::hard::Pair last;
    for (std::size_t poses = 0; poses < count;) {
        scene::hard::Pair pair = family.make(maker);
        poses += pair.poses.size();
        if (!family.warm && !cases_.empty() && same_bodies(pair, last)) {
            auto& known = cases_.back().poses;
            known.insert(known.end(), pair.poses.begin(), pair.poses.end());
            truths_.back().resize(known.size());
            continue;
        }
        auto a = scene::body_from_case(pair.a);
        auto b = scene::body_from_case(pair.b);
        std::string error = !a ? a.error : !b ? b.error : "";
        for (const auto& [pose_a, pose_b] : pair.poses) {
            if (error.empty()) error = truth::pair_error(a->vertices, pose_a, b->vertices, pose_b);
        }
        if (error.empty()) {
            truths_.emplace_back(pair.poses.size());
            cases_.push_back({std::move(*a), std::move(*b), pair.poses});
            last = std::move(pair);
        } else {
            refused_ += pair.poses.size();
            if (first_refusal_.empty()) first_refusal_ = error;
        }
    }
}

std::optional<bool> StabilityCases::control(StabilityPose at, std::span<const Polyhedron> stored) {
    std::optional<std::optional<bool>>& known = truth_of(at).control;
    const auto& [pose_a, pose_b] = poses_of(at);
    if (!known) known = truth::moore_wilhelms(stored[0], stored[1], relative_pose(pose_a, pose_b));
    return *known;
}

namespace {

constexpr int timed_rounds = 5;

/// Returns the bin of a signed gap over scale: "0" near contact, else the lower edge, negative for overlaps.
std::string bin_of(double gap) {
    double edge = 0;
    for (const double e : stability_gaps) {
        if (std::abs(gap) >= e) edge = e;
    }
    return edge == 0 ? "0" : fmt::format("{}{:.0e}", gap < 0 ? "-" : "", edge);
}

bool holds(const truth::Certificate& known, const truth::ExactDistance& exact) {
    return known.lower <= exact.distance && exact.distance <= known.upper;
}

std::vector<std::string> all_bins() {
    std::vector<std::string> bins;
    for (std::size_t i = stability_gaps.size(); i-- > 0;) bins.push_back(bin_of(-stability_gaps[i]));
    bins.push_back("0");
    for (const double e : stability_gaps) bins.push_back(bin_of(e));
    return bins;
}

/// One algorithm on one table type over the cases of one family: asks, checks, proves and times.
class StabilitySubject {
  public:
    /// `warm`: poses of a case keep the pair's cache. At most `proofs` poses get depth, certificate and time.
    StabilitySubject(const bench::TableType& type, const std::string& algorithm, bool warm,
                     StabilityCases& cases, std::size_t proofs)
        : type_(type),
          algorithm_(algorithm),
          runner_(type.make_runner(algorithm)),
          warm_(warm),
          cases_(cases),
          proofs_(proofs) {}

    /// Before it runs: as raw V-Clip.
    void make_raw() { runner_->configure({.query = {.hardened = false}}); }

    void run(StabilityTally& tally) {
        if (cases_.refused() > 0) tally.add_refusal(cases_.refused(), cases_.first_refusal());
        for (std::size_t i = 0; i < cases_.all().size(); ++i) ask(i, tally);
        time(tally);
    }

  private:
    [[nodiscard]] scene::Workload workload_of(std::size_t index) const {
        const StabilityCase& given = cases_.all()[index];
        scene::Workload workload;
        workload.bodies = {given.a, given.b};
        workload.pair_count = 1;
        workload.warm = warm_;
        for (const auto& [pose_a, pose_b] : given.poses)
            workload.queries.push_back({0, 1, 0, pose_a, pose_b});
        return workload;
    }

    void ask(std::size_t index, StabilityTally& tally) {
        const scene::Workload workload = workload_of(index);
        const std::string error = runner_->load(workload);
        if (!error.empty()) return tally.add_refusal(workload.queries.size(), error);
        const auto answers = runner_->answer();
        for (std::size_t pose = 0; pose < answers.size(); ++pose) {
            check_pose({index, pose}, answers[pose], tally);
            if (proven_ < proofs_) prove_pose({index, pose}, tally);
        }
    }

    [[nodiscard]] truth::CheckedAnswer checked(StabilityPose at, const truth::Claim& claim) const {
        const truth::PlacedBodies bodies = cases_.placed(at, runner_->stored_bodies());
        return truth::check(claim, bodies, cases_.known(at), bodies.band(type_.eps),
                            allowed_errors(type_, algorithm_));
    }

    void check_pose(StabilityPose at, const Distance& answer, StabilityTally& tally) {
        const auto stored = runner_->stored_bodies();
        StabilityAnswer asked{checked(at, scene::claim_of(answer)), answer,
                              cases_.known(at).exact(cases_.placed(at, stored)).distance};
        if (const auto control = cases_.control(at, stored))
            asked.checked.control_disagrees = *control == (answer.status == Status::separated);
        tally.add(asked);
    }

    void prove_pose(StabilityPose at, StabilityTally& tally) {
        ++proven_;
        const StabilityCase& given = cases_.all()[at.index];
        const auto& [pose_a, pose_b] = given.poses[at.pose];
        const auto stored = runner_->stored_bodies();
        const scene::Query query{0, 1, 0, pose_a, pose_b};
        const bench::NamedAnswer answer = runner_->answer(query);
        const std::vector<Polyhedron> bodies = {given.a, given.b};
        const auto certificates = bench::certificates_of(answer, query, bodies, stored);
        truth::Claim claim = scene::claim_of(answer.distance);
        claim.depth = answer.depth;
        const truth::CheckedAnswer found = checked(at, claim);
        const truth::AccuracyBand& band = found.band;
        StabilityProof proof;
        proof.depth_error = band.beyond(found.depth_error);
        proof.depth_wrong = found.depth_wrong;
        proof.certificate_missed = true;
        proof.depth_cut_short = answer.depth_cut_short;
        if (certificates) {
            const auto of_given = truth::exact_distance(given.a.vertices, pose_a, given.b.vertices, pose_b);
            proof.certificate_width = certificates->stored.width() / (band.scale > 0 ? band.scale : 1);
            const double allowed = allowed_errors(type_, algorithm_).distance * band.scale + band.band;
            const truth::ExactDistance& exact = cases_.known(at).exact(cases_.placed(at, stored));
            proof.certificate_missed =
                !holds(certificates->stored, exact) || !of_given || !holds(certificates->given, *of_given) ||
                !bench::contradiction(answer.distance.distance, certificates->stored, allowed, allowed)
                     .empty();
        }
        tally.add(proof);
    }

    /// Returns the queries of the first cases by gap, one workload per gap.
    [[nodiscard]] std::map<std::string, scene::Workload> by_gap() {
        std::map<std::string, scene::Workload> bins;
        std::size_t taken = 0;
        for (std::size_t i = 0; i < cases_.all().size() && taken < proofs_; ++i) {
            const scene::Workload one = workload_of(i);
            if (!runner_->load(one.bodies).empty()) continue;
            const auto stored = runner_->stored_bodies();
            std::map<std::string, std::uint32_t> first;  // of the case's bodies in a bin
            for (std::size_t pose = 0; pose < one.queries.size() && taken < proofs_; ++pose, ++taken) {
                const truth::PlacedBodies placed = cases_.placed({i, pose}, stored);
                truth::KnownPair& known = cases_.known({i, pose});
                const auto& query = one.queries[pose];
                const double scale = placed.band(type_.eps).scale;
                const truth::ExactDistance& exact = known.exact(placed);
                const bool separated = exact.verdict == truth::ExactVerdict::separated;
                const double gap = separated ? exact.distance : -known.depth(placed);
                const std::string bin = bin_of(gap / (scale > 0 ? scale : 1));
                auto& bodies = bins[bin].bodies;
                const auto [place, is_new] =
                    first.try_emplace(bin, static_cast<std::uint32_t>(bodies.size()));
                if (is_new) bodies.insert(bodies.end(), one.bodies.begin(), one.bodies.end());
                bins[bin].queries.push_back(
                    {place->second, place->second + 1, 0, query.pose_a, query.pose_b});
            }
        }
        return bins;
    }

    /// Times cold queries of the first cases, gap by gap.
    void time(StabilityTally& tally) {
        const std::map<std::string, scene::Workload> bins = by_gap();
        const double clock = measure::calibrate();
        const char* none = proofs_ == 0 ? "not asked for" : "no case of this family has such a gap";
        for (const std::string& bin : all_bins()) {
            std::vector<double> ns;
            if (const auto found = bins.find(bin);
                found != bins.end() && runner_->load(found->second).empty()) {
                const std::vector<std::uint8_t> one_class(found->second.queries.size(), 0);
                for (int round = 0; round < timed_rounds; ++round)
                    ns.push_back(runner_->time(one_class, clock).separated_ns /
                                 static_cast<double>(one_class.size()));
            }
            tally.add_time(bin, measure::median(ns), none);
        }
    }

    const bench::TableType& type_;
    std::string algorithm_;
    std::unique_ptr<bench::Runner> runner_;
    bool warm_;
    StabilityCases& cases_;
    std::size_t proofs_, proven_ = 0;
};

std::vector<const scene::HardFamily*> chosen_families(const StabilityPlan& plan) {
    std::vector<const scene::HardFamily*> result;
    std::vector<std::string> names;
    for (const scene::HardFamily& family : scene::hard_families()) {
        names.push_back(family.name);
        if (plan.families.empty()) result.push_back(&family);
    }
    for (const std::string& name : plan.families) {
        const auto found = std::ranges::find(scene::hard_families(), name, &scene::HardFamily::name);
        if (found == scene::hard_families().end())
            throw std::invalid_argument(unknown_name("family", name, names));
        result.push_back(&*found);
    }
    return result;
}

/// One algorithm on one table type.
struct Subject {
    const bench::TableType* type;
    std::string algorithm;
    bool raw = false;
};

std::vector<Subject> subjects_of(const StabilityPlan& plan) {
    std::vector<Subject> subjects;
    for (const bench::TableType* type : plan.types) {
        for (const std::string& algorithm : plan.algorithms) {
            if (!type->serves(algorithm)) continue;
            subjects.push_back({type, algorithm});
            if (plan.raw && algorithm == "vclip" && type->name == raw_type)
                subjects.push_back({type, algorithm, true});
        }
    }
    return subjects;
}

store::StoredCell row_for(const StabilityPlan& plan, const scene::HardFamily& family,
                          const Subject& subject) {
    store::StoredCell row;
    row.run = row.scene = stability_run;
    scene::SceneParameters asked = {{"count", static_cast<double>(plan.count)}};
    if (plan.proofs != plan.count) asked["proofs"] = static_cast<double>(plan.proofs);
    row.scene_parameters = bench::parameters_json(asked);
    row.shape = family.name;
    row.shape_source = "generated";
    row.algorithm = subject.algorithm;
    if (subject.raw) row.axes = "hardening=off";
    bench::describe_cell(row, *subject.type, Polyhedron{});
    row.seed = plan.seed;
    row.queries = plan.count;
    Polyhedron real;  // rows of other hulls are others
    if (family.name == real_family)
        for (const Polyhedron& body : plan.real)
            real.vertices.insert(real.vertices.end(), body.vertices.begin(), body.vertices.end());
    bench::name_cell(row, real);
    return row;
}

/// By storage of the bodies: exact answers are shared.
using SharedCases = std::map<std::string, StabilityCases>;

/// Raw V-Clip is judged: what is wrong with it fails nothing, and nothing of it is proven.
void measure_row(store::StoredCell& row, const StabilityPlan& plan, const scene::HardFamily& family,
                 const Subject& subject, SharedCases& cases) {
    if (family.name == real_family && plan.real.empty()) {
        row.status = store::CellStatus::unavailable;
        row.reason = "no real meshes here: name some with --shape";
        return;
    }
    const bench::TableType& type = *subject.type;
    StabilityTally tally;
    const auto of_storage =
        cases.try_emplace(type.storage, family, plan.count, plan.seed, type.single_storage, plan.real);
    StabilitySubject asked(type, subject.algorithm, family.warm, of_storage.first->second,
                           subject.raw ? 0 : plan.proofs);
    if (subject.raw) asked.make_raw();
    asked.run(tally);
    for (measure::Figure& figure : tally.figures()) row.figures.push_back({std::move(figure), "stability"});
    row.reason = tally.what_is_wrong();
    row.status = subject.raw          ? store::CellStatus::judged
                 : row.reason.empty() ? store::CellStatus::verified
                                      : store::CellStatus::failed;
}

}  // namespace

std::size_t stability_rows(const StabilityPlan& plan) {
    return subjects_of(plan).size() * chosen_families(plan).size();
}

bool run_stability(const StabilityPlan& plan, store::Store& store,
                   const std::function<void(const store::StoredCell&)>& on_row,
                   const std::atomic<bool>& stop) {
    const store::BuildRow build = bench::this_build();
    store.put_build(build);
    store.set_meta("build", build.id);
    store.set_meta("seed", std::to_string(plan.seed));
    for (const scene::HardFamily* family : chosen_families(plan)) {
        SharedCases cases;
        const measure::Stopwatch watch;
        for (const Subject& subject : subjects_of(plan)) {
            if (stop) return false;
            store::StoredCell row = row_for(plan, *family, subject);
            if (auto stored = store.find_cell(build.id, row.hash))
                row = *std::move(stored);
            else
                measure_row(row, plan, *family, subject, cases);
            store.put_cell(build.id, row, row.figures);
            on_row(row);
        }
        if (const double took = watch.elapsed_ns() * 1e-9; took > 0.01)  // else it was there
            store.set_meta(store::took_key + sweep::unit_name(stability_run, family->name),
                           fmt::format("{:.3f}", took));
    }
    return true;
}

}  // namespace edgewise::studies
