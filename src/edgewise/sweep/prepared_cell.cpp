// SPDX-License-Identifier: MIT
#include "edgewise/sweep/prepared_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/parallel.hpp"
#include "edgewise/bench/peers/peer_modules.hpp"
#include "edgewise/scene/answer_claim.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/table/canonical.hpp"
#include "edgewise/truth/moore_wilhelms.hpp"

namespace edgewise::sweep {

namespace {

/// Good enough to place pairs by; what is placed is then checked exactly like everything else.
double placing_distance(const Polyhedron& a, const Pose& pose_a, const Polyhedron& b, const Pose& pose_b) {
    SimplexPair<Canonical, Canonical> cold;
    return Gjk::query(Canonical(a), Canonical(b), relative_pose(pose_a, pose_b), cold).distance;
}

/// Returns n: the control answers every n-th checked query. It tests every vertex and edge against every
/// face: seconds per pair of the largest bodies. n is 1 up to some 400 vertices; then it keeps the time.
std::size_t control_stride(const Polyhedron& body, std::size_t checked) {
    constexpr double most_work = 2000.0 * 386 * 768;  // vertices x faces
    const double work = static_cast<double>(checked) * static_cast<double>(body.vertex_count()) *
                        static_cast<double>(body.face_count());
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(work / most_work)));
}

/// Returns true if an answer says no more than whether the bodies, or cores, are nearer than their margin:
/// rounded bodies that overlap have no distance, nor have those beyond the margin of needs=within.
bool tells_margin_alone(const Distance& answer, const bench::RunnerOptions& asked, const MarginOf& margin,
                        const scene::Query& query) {
    const bool is_separated = answer.status == Status::separated;
    if (asked.has_radius()) return asked.query.is_for_verdict() || !is_separated;
    return asked.needs == Needs::nearer ||
           (asked.needs == Needs::within && is_separated && answer.distance >= margin(query));
}

/// `gap`: between the rounded bodies; below 0 where they overlap.
void set_truth_of_rounded(double gap, truth::CheckedAnswer& checked) {
    using enum truth::ExactVerdict;
    checked.exact = gap > 0 ? separated : gap == 0 ? touching : overlapping;
    checked.in_band = std::abs(gap) <= checked.band.band;
}

std::string print_of(std::span<const Polyhedron> bodies) {
    bench::Fingerprint print;
    for (const Polyhedron& body : bodies) print.add(body);
    return print.hex();
}

}  // namespace

SharedQueries::SharedQueries(const Plan& plan, const SceneChoice& scene, const scene::NamedShape& shape)
    : asks_control_(plan.control) {
    auto recording = scene.recording;
    if (!recording && scene::names_recording(scene.name))
        recording = std::make_shared<const scene::Recording>(
            scene::read_recording(scene.name, plan.as_stored).or_throw());
    const auto kind = recording ? std::string(scene::recorded_kind) : scene.name;
    const auto parameters = scene::complete_parameters(kind, scene.parameters).or_throw();
    auto made = recording ? scene::recorded_workload(*recording, parameters, plan.queries)
                          : scene::make_scene(kind, shape.body, parameters, plan.seed, plan.queries,
                                              placing_distance);
    note_ = made.warning;
    workload_ = std::move(made).or_throw();
    const std::size_t wanted = std::min(plan.checked, workload_.queries.size());
    for (std::size_t k = 0; k < wanted; ++k) checked_.push_back(k * workload_.queries.size() / wanted);
}

std::vector<truth::KnownPair>& SharedQueries::known(std::span<const Polyhedron> bodies) {
    auto [place, is_new] = known_.try_emplace(print_of(bodies));
    std::vector<truth::KnownPair>& pairs = place->second;
    if (!is_new) return pairs;
    pairs.resize(checked_.size());
    bench::for_each_index(checked_.size(), [&](std::size_t k) {
        pairs[k].exact(scene::placed(bodies, workload_.queries[checked_[k]]));
    });
    return pairs;
}

const scene::Workload& SharedQueries::cold_workload() {
    if (!workload_.warm) return workload_;
    if (!cold_workload_) {
        cold_workload_ = workload_;
        cold_workload_->warm = false;
    }
    return *cold_workload_;
}

const std::vector<std::optional<bool>>& SharedQueries::control(std::span<const Polyhedron> bodies) {
    auto [place, is_new] = control_.try_emplace(print_of(bodies));
    if (!is_new || !asks_control_) return place->second;
    std::vector<std::optional<bool>>& says = place->second;
    says.resize(checked_.size());
    const std::size_t stride = control_stride(bodies.front(), checked_.size());
    bench::for_each_index((checked_.size() + stride - 1) / stride, [&](std::size_t nth) {
        const std::size_t k = nth * stride;
        const scene::Query& query = workload_.queries[checked_[k]];
        says[k] = truth::moore_wilhelms(bodies[query.body_a], bodies[query.body_b],
                                        relative_pose(query.pose_a, query.pose_b));
    });
    return says;
}

std::vector<truth::CheckedAnswer> check_answers(SharedQueries& shared, std::span<const Polyhedron> stored,
                                                std::span<const Distance> answers, double eps,
                                                const bench::RunnerOptions& asked, const MarginOf& margin) {
    auto& known_stored = shared.known(stored);
    auto& known_given = shared.known(shared.workload().bodies);
    const auto& control = shared.control(stored);
    truth::AllowedErrors allowed = truth::allowed_errors(eps);
    allowed.beyond_band = false;
    const truth::Leeway leeway{asked.query.contact_tolerance, asked.query.gap_tolerance};
    std::vector<truth::CheckedAnswer> result;
    for (std::size_t k = 0; k < shared.checked().size(); ++k) {
        const Distance& answer = answers[shared.checked()[k]];
        const scene::Query& query = shared.workload().queries[shared.checked()[k]];
        const truth::PlacedBodies bodies = scene::placed(stored, query);
        const truth::AccuracyBand band = bodies.band(eps);
        truth::KnownPair& known = known_stored[k];
        truth::Claim claim = scene::claim_of(answer, asked.query.is_for_verdict());
        if (asked.has_radius()) claim.distance += margin(query);
        const bool margin_alone = tells_margin_alone(answer, asked, margin, query);
        truth::CheckedAnswer& checked = result.emplace_back(
            margin_alone ? truth::check_nearness(!claim.separated, known.exact(bodies), margin(query), band,
                                                 leeway.gap_tolerance)
                         : truth::check(claim, bodies, known, band, allowed, leeway));
        if (asked.has_radius()) set_truth_of_rounded(known.exact(bodies).distance - margin(query), checked);
        if (margin_alone) {
            if (claim.failed) checked.verdict_wrong = true;
            continue;
        }
        const auto& given = known_given[k].exact(scene::placed(shared.workload().bodies, query));
        if (!claim.verdict_only)
            checked.error_given = truth::distance_error(claim, given, leeway.contact_tolerance);
        if (k < control.size() && control[k]) checked.control_disagrees = *control[k] == claim.separated;
    }
    return result;
}

std::string what_is_wrong(const SharedQueries& shared, std::span<const truth::CheckedAnswer> checked,
                          double eps) {
    const auto first = std::ranges::find_if(checked, &truth::CheckedAnswer::wrong);
    if (first == checked.end()) return {};
    return fmt::format(
        "{} of {} checked answers are wrong; first: query {} ({}), error {:.3g} of scale, witness error "
        "{:.3g}, allowed {:.0e}",
        std::ranges::count_if(checked, &truth::CheckedAnswer::wrong), checked.size(),
        shared.checked()[static_cast<std::size_t>(first - checked.begin())],
        first->verdict_wrong ? "wrong verdict" : "wrong distance", first->band.over_scale(first->error),
        first->band.over_scale(first->witness_error), truth::allowed_errors(eps).distance);
}

bench::AnswerCounts count_answers(std::span<const Distance> answers, std::span<const std::uint8_t> cold) {
    bench::AnswerCounts counts;
    counts.queries = answers.size();
    counts.follows_pairs = !cold.empty();
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const Distance& answer = answers[i];
        const bool warm = !cold.empty() && !cold[i];
        int& most = warm ? counts.max_warm_steps : counts.max_cold_steps;
        most = std::max(most, answer.steps);
        counts.warm += warm;
        if (warm) counts.warm_steps += static_cast<std::uint64_t>(answer.steps);
        counts.unchanged += warm && answer.steps == 1;
        counts.told += warm && answer.steps == 0 && answer.status != Status::failed;
        counts.steps += static_cast<std::uint64_t>(answer.steps);
        counts.fallbacks += static_cast<std::uint64_t>(answer.fallbacks);
        counts.refinements += static_cast<std::uint64_t>(answer.refinements);
        counts.escapes += static_cast<std::uint64_t>(answer.escapes);
        counts.cycles += static_cast<std::uint64_t>(answer.cycles);
        counts.max_steps = std::max(counts.max_steps, answer.steps);
    }
    return counts;
}

PreparedCell::PreparedCell(const bench::TableType& type, const std::string& algorithm,
                           const bench::RunnerOptions& options)
    : PreparedCell(type, type.make_runner(algorithm), options) {}

PreparedCell::PreparedCell(const bench::TableType& type, std::unique_ptr<bench::Runner> runner,
                           const bench::RunnerOptions& options)
    : type_(&type), options_(options), runner_(std::move(runner)) {
    runner_->configure(options);
}

void PreparedCell::check(SharedQueries& shared) {
    const std::vector<Distance> answers = runner_->answer();
    counts_ = count_answers(answers,
                            workload_->warm ? bench::cold_starts(*workload_) : std::vector<std::uint8_t>{});
    double sum = 0;
    for (const Distance& answer : answers) {
        if (!has_margin(options_.needs)) in_contact_.push_back(answer.status != Status::separated);
        distances_.push_back(sum += answer.distance);
    }
    const auto stored = runner_->stored_bodies();
    bench::RunnerOptions asked = options_;
    if (type_->verdict_only) asked.query.cutoff = 0;
    checked_ = check_answers(shared, stored, answers, type_->eps, asked,
                             [&](const scene::Query& query) { return runner_->margin(query); });
    wrong_ = what_is_wrong(shared, checked_, type_->eps);
}

void take_turns(std::size_t count, std::uint64_t seed, const std::function<void(std::size_t)>& take) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    scene::Rng rng(seed);
    rng.shuffle(order);
    for (const std::size_t i : order) take(i);
}

std::string body_json(const Polyhedron& body) {
    nlohmann::json vertices = nlohmann::json::array(), edges = nlohmann::json::array(),
                   faces = nlohmann::json::array();
    for (const Vec3d& vertex : body.vertices)
        for (int axis = 0; axis < 3; ++axis) vertices.push_back(vertex[axis]);
    for (const PolyhedronEdge& edge : body.edges) edges.push_back(edge.tail), edges.push_back(edge.head);
    for (Index f = 0; f < body.face_count(); ++f) {
        nlohmann::json face = nlohmann::json::array();
        for (const HalfEdge h : body.ring_of_face(f)) face.push_back(body.tail(h));
        faces.push_back(std::move(face));
    }
    return nlohmann::json{{"vertices", vertices}, {"edges", edges}, {"faces", faces}}.dump();
}

namespace {

nlohmann::json walk_json(const bench::Walk& walk) {
    nlohmann::json steps = nlohmann::json::array();
    for (const bench::WalkStep& step : walk.steps)
        steps.push_back({{"state", bench::step_names()[static_cast<std::size_t>(step.state)]},
                         {"a", step.a},
                         {"b", step.b},
                         {"lines", step.lines}});
    return {{"query", walk.query}, {"tables", walk.tables}, {"steps", steps}};
}

/// {"queries": n, "vertices": [reads, ...], "edges": ..., "faces": ...}, in the body's order; null for a kind
/// of feature that has no bytes of its own in the layout. "walk" is one query of the scene
/// (bench/trace/walk.hpp):
/// {"query": n, "tables": [lines, ...], "steps": [{"state", "a": [vertex, ...], "b": ..., "lines": [line,
/// ...]}]}, or null.
std::string heat_json(const bench::FeatureHeat& heat, const std::optional<bench::Walk>& walk) {
    const auto reads = [&](FeatureKind kind) {
        const auto& counts = heat.reads(kind);
        return counts ? nlohmann::json(*counts) : nlohmann::json();
    };
    return nlohmann::json{{"queries", heat.queries()},
                          {"vertices", reads(FeatureKind::vertex)},
                          {"edges", reads(FeatureKind::edge)},
                          {"faces", reads(FeatureKind::face)},
                          {"walk", walk ? walk_json(*walk) : nlohmann::json()}}
        .dump();
}

/// Returns true if a picture of the body can show the heat of this table type: it numbers features as the
/// body does, it is the layout's type in double precision, and the body has few enough vertices.
bool shows_heat(const bench::TableType& type, std::int64_t vertices) {
    constexpr std::int64_t most_vertices = 2000;
    return !type.is_peer && type.precision == "f64" && !type.input_order_bytes && vertices <= most_vertices;
}

}  // namespace

CellRun::CellRun(const bench::TableType& type, const std::string& algorithm, const Axes& axes,
                 store::CellRow row, const Polyhedron& body)
    : cell_(type,
            axes.default_build ? bench::make_default_build(type, algorithm) : type.make_runner(algorithm),
            axes),
      axes_(axes),
      row_(std::move(row)) {
    row_.axes = axes.text();
    row_.algorithm = algorithm;
    bench::describe_cell(row_, type, body);
    bench::name_cell(row_, body);
}

void CellRun::verify(SharedQueries& shared) {
    const scene::Workload& workload = axes_.starts_cold ? shared.cold_workload() : shared.workload();
    if (cell_.type().is_peer && has_margin(axes_.needs))
        return make_unavailable("other libraries are not asked about a margin");
    if (cell_.type().verdict_only && axes_.has_radius())
        return make_unavailable("bodies with a radius need distances, which this library does not give");
    if (const std::string error = cell_.load(workload); !error.empty()) return make_unavailable(error);
    shared_ = &shared;
    row_.queries = workload.queries.size();  // more than the plan's number if the scene needs more steps
    cell_.check(shared);
    row_.reason = cell_.wrong();
    // A peer's errors, and those of V-Clip as published, are figures; they are no failure of this program.
    row_.status = cell_.type().is_peer || !axes_.query.hardened ? store::CellStatus::judged
                  : row_.reason.empty()                         ? store::CellStatus::verified
                                                                : store::CellStatus::failed;
}

void CellRun::measure(Stage stage, std::span<const measure::Round> rounds) {
    if (!shared_) return;
    const bench::ProbedCell cell{.type = cell_.type(),
                                 .algorithm = bench::algorithm_called(row_.algorithm),
                                 .runner = cell_.runner(),
                                 .workload = cell_.workload(),
                                 .plain = row_.axes.empty(),
                                 .needs = axes_.needs,
                                 .verified = verified(),
                                 .checked_positions = shared_->checked(),
                                 .checked = cell_.checked(),
                                 .counts = cell_.counts(),
                                 .rounds = rounds,
                                 .caches = caches_};
    for (const bench::Probe& probe : bench::registered_probes()) {
        if (probe.beside_others != (stage == Stage::beside_others)) continue;
        if (cell_.type().is_peer && !probe.of_peers) continue;
        // All but its times and errors is that of the plain cell.
        if (axes_.default_build && probe.name != "time" && probe.name != "error") continue;
        if (!only_.empty() && std::ranges::find(only_, probe.name) == only_.end()) continue;
        bench::Findings found = probe.measure(cell);
        if (found.passed) hold_against_answers(*found.passed, probe.name);
        for (measure::Figure& figure : found.figures)
            figures_.push_back({std::move(figure), std::string(probe.name)});
    }
}

std::string CellRun::heat_on_body() const {
    const bench::Runner& runner = cell_.runner();
    const bool of_one_body = row_.scene_kind != scene::recorded_kind;
    const bool traced = !caches_.machines.empty() && runner.table_allocator().base() && of_one_body;
    if (!verified() || !shared_ || !row_.axes.empty() || !traced || !shows_heat(cell_.type(), row_.vertices))
        return {};
    const std::vector<bench::TableMap> maps = runner.memory_maps();
    const bench::TraceExtent extent = caches_.queries > 0 ? bench::TraceExtent(caches_.queries, caches_.steps)
                                                          : bench::TraceExtent::everything();
    bench::FeatureHeat heat(maps);
    bench::WalkTrace walk(row_.algorithm, runner.stored_bodies(), cell_.workload(), extent.counted);
    measure::TraceFanOut both({&heat, &walk});
    static_cast<void>(runner.trace(extent, both));
    return heat_json(heat, walk.walk(maps));
}

void CellRun::hold_against_answers(const bench::PassSum& sum, std::string_view probe) {
    const double expected = cell_.distances(sum.queries);
    if (sum.queries > 0 && expected == sum.distances) return;
    row_.status = store::CellStatus::failed;
    row_.reason = fmt::format("the pass of probe {} gave other answers: distances add up to {}, not {}",
                              probe, sum.distances, expected);
}

}  // namespace edgewise::sweep
