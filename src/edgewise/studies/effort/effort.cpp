// SPDX-License-Identifier: MIT
#include "edgewise/studies/effort/effort.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/bench/build_info.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"
#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/table/canonical.hpp"

namespace edgewise::studies {

namespace {

namespace fs = std::filesystem;

/// Returns a file name for this pass; no other pass of this process has the same.
fs::path output_file() {
    static std::atomic<int> number = 0;
    return fs::temp_directory_path() / fmt::format("edgewise-callgrind-{}-{}", getpid(), number++);
}

/// Runs the passes under Callgrind with these further options, which writes to a file of ours, and returns
/// what `parse` makes of that file. The file is removed afterwards.
template <class Parse>
auto counted(const CellChoice& choice, const measure::CacheGeometry& geometry, const std::string& program,
             int passes, const std::vector<std::string>& options, const Parse& parse) {
    const fs::path file = output_file();
    auto command = measure::callgrind_command(geometry, file, pass_command(choice, program, passes));
    command.insert(command.begin() + 2, options.begin(), options.end());  // after the tool's name
    const auto outcome = measure::run_program(command);
    std::ifstream output(file);
    using Answer = decltype(parse(output));
    std::error_code ignored;
    fs::remove(file, ignored);  // an open file can still be read
    if (!outcome.value) return Answer::none(outcome.reason, "install valgrind");
    if (outcome.value->exit_code != 0) {
        const std::string& err = outcome.value->err;
        return Answer::none(fmt::format("valgrind ended with {}: {}", outcome.value->exit_code,
                                        err.substr(err.size() > 300 ? err.size() - 300 : 0)));
    }
    return parse(output);
}

}  // namespace

std::vector<std::string> pass_command(const CellChoice& choice, const std::string& program, int passes) {
    std::vector<std::string> command = {program,     "pass",
                                        "--scene",   choice.scene,
                                        "--shape",   choice.shape,
                                        "--queries", std::to_string(choice.queries),
                                        "--seed",    std::to_string(choice.seed),
                                        "--passes",  std::to_string(passes)};
    const auto add = [&](const char* option, const std::string& value) {
        command.emplace_back(option);
        command.push_back(value);
    };
    if (choice.peer.empty()) {
        add("--table", choice.table);
        add("--algorithm", choice.algorithm);
    } else {
        add("--peer", choice.peer);
    }
    if (choice.as_stored) command.emplace_back("--as-stored");
    if (choice.needs != Needs::witnesses) add("--needs", std::string(to_string(choice.needs)));
    if (choice.margin) add("--margin", fmt::format("{}", *choice.margin));
    if (choice.sub_distance != SubDistanceSolver::cofactors)
        add("--sub-distance", std::string(to_string(choice.sub_distance)));
    for (const auto& [name, value] : choice.parameters) add("--parameter", fmt::format("{}={}", name, value));
    return command;
}

measure::Expected<measure::CallgrindCounts> callgrind_pass(const CellChoice& choice,
                                                           const measure::CacheGeometry& geometry,
                                                           const std::string& program, int passes) {
    return counted(choice, geometry, program, passes, {}, [](std::istream& output) {
        return measure::parse_callgrind(std::string(std::istreambuf_iterator<char>(output), {}));
    });
}

measure::Expected<measure::CallgrindLines> callgrind_lines(const CellChoice& choice,
                                                           const measure::CacheGeometry& geometry,
                                                           const std::string& program, int passes) {
    return counted(choice, geometry, program, passes, {"--dump-instr=yes"}, measure::parse_callgrind_lines);
}

measure::Expected<std::string> program_for_valgrind() {
    const fs::path self = fs::read_symlink("/proc/self/exe");
    const std::string flags = bench::this_build().flags;
    if (flags.find("-march=native") == std::string::npos && flags.find("v4") == std::string::npos)
        return {self.string()};
    const fs::path sim = self.parent_path() / "edgewise_sim";
    if (fs::exists(sim)) return {sim.string()};
    return measure::Refusal{
        fmt::format("this program may use instructions that Valgrind does not know, and {} is not there",
                    sim.string()),
        "make it with sh cmake/build_preset.sh release edgewise_sim"};
}

namespace {

constexpr double line_bytes = 64;
constexpr double dot_flops = 5, turn_flops = 15, offset_flops = 7;
constexpr int contact_vertices = 5;
constexpr double contact_flops = 3 * (2 * contact_vertices - 2) + 18;

double lines_of(double bytes) { return std::ceil(bytes / line_bytes); }

/// Returns the fewest lines over all ways to divide the five between the bodies, at least one each.
double contact_lines(double vertex_bytes) {
    double fewest = lines_of(contact_vertices * vertex_bytes) + 1;
    for (int of_a = 1; of_a < contact_vertices; ++of_a)
        fewest = std::min(fewest,
                          lines_of(of_a * vertex_bytes) + lines_of((contact_vertices - of_a) * vertex_bytes));
    return fewest;
}

ProofFloor separated_floor(const Polyhedron& a, const Polyhedron& b, const Vec3d& normal,
                           const Transform<double>& a_from_b, const ProofReads& reads) {
    const auto of_a = static_cast<double>(proof_vertices(a, normal, reads.knows_neighbours));
    const auto of_b = static_cast<double>(
        proof_vertices(b, a_from_b.direction_back(Vec3d(-normal)), reads.knows_neighbours));
    return {of_a + of_b, dot_flops * (of_a + of_b) + turn_flops + offset_flops,
            lines_of(of_a * reads.vertex_bytes) + lines_of(of_b * reads.vertex_bytes)};
}

ProofFloor query_floor(const Polyhedron& a, const Polyhedron& b, const scene::Query& query,
                       const ProofReads& reads) {
    const Transform<double> a_from_b = relative_pose(query.pose_a, query.pose_b);
    SimplexPair<Canonical, Canonical> cold;
    const Distance answer = Gjk::query(Canonical(a), Canonical(b), a_from_b, cold);
    if (answer.status == Status::separated) return separated_floor(a, b, answer.normal, a_from_b, reads);
    return {contact_vertices, contact_flops, contact_lines(reads.vertex_bytes)};
}

}  // namespace

std::size_t proof_vertices(const Polyhedron& body, const Vec3d& direction, bool knows_neighbours) {
    const std::size_t count = body.vertex_count();
    if (!knows_neighbours) return count;
    std::vector<double> heights;
    double reach = 0;
    for (const Vec3d& v : body.vertices) {
        heights.push_back(dot(v, direction));
        reach = std::max(reach, max_abs(v));
    }
    const double level = Tolerance<double>::level * reach * max_abs(direction);
    const double top = *std::max_element(heights.begin(), heights.end());
    std::size_t fewest = count;
    for (Index v = 0; v < count; ++v)
        if (heights[v] >= top - level) fewest = std::min(fewest, 1 + body.ring_of_vertex(v).size());
    return fewest;
}

measure::Expected<ProofFloor> proof_floor(const scene::Workload& workload, std::span<const Polyhedron> bodies,
                                          const ProofReads& reads) {
    if (workload.queries.empty()) return measure::Refusal{"there are no queries"};
    ProofFloor sum;
    for (const scene::Query& query : workload.queries) {
        const ProofFloor one = query_floor(bodies[query.body_a], bodies[query.body_b], query, reads);
        sum.vertices += one.vertices;
        sum.flops += one.flops;
        sum.lines += one.lines;
    }
    const auto queries = static_cast<double>(workload.queries.size());
    return {ProofFloor{sum.vertices / queries, sum.flops / queries, sum.lines / queries}};
}

namespace {

using Count = measure::Expected<double>;
using Counts = measure::Expected<measure::CallgrindCounts>;

class ReadCounter final : public measure::TraceListener {
  public:
    void on_access(const measure::TracedAccess& access) override {
        lines_.on_access(access);
        if (access.side == measure::TraceSide::scene) return;
        if (access.field == static_cast<std::uint8_t>(Field::vertex)) vertex_bytes_ += access.bytes;
    }

    void on_query_end(bool /*counts*/) override { lines_.on_query_end(true); }

    /// Sums over the queries.
    [[nodiscard]] std::uint64_t vertex_bytes() const { return vertex_bytes_; }
    [[nodiscard]] std::uint64_t lines() const { return lines_.sums().all.lines; }

  private:
    measure::LineCounter lines_;
    std::uint64_t vertex_bytes_ = 0;
};

/// Returns the bytes of a vertex's coordinates; a lossy layout has no simple number, so its ledger decides.
double vertex_bytes(const SingleCell& cell, const Ledger& ledger) {
    const std::string& storage = cell.type().storage;
    if (storage == "double") return 3 * sizeof(double);
    if (storage == "single") return 3 * sizeof(float);
    return static_cast<double>(ledger[Component::vertex_coordinates]) /
           static_cast<double>(cell.runner().stored_bodies()[0].vertex_count());
}

void take_trace(const SingleCell& cell, double bytes_of_vertex, Effort& effort) {
    if (effort.is_peer) {
        effort.vertices_read = effort.lines_read =
            Count::none("the reads of a library cannot be counted from outside");
        return;
    }
    ReadCounter counter;
    cell.runner().trace(bench::TraceExtent::everything(), counter);
    const auto queries = static_cast<double>(cell.workload().queries.size());
    effort.vertices_read = {static_cast<double>(counter.vertex_bytes()) / bytes_of_vertex / queries};
    effort.lines_read = {static_cast<double>(counter.lines()) / queries};
}

}  // namespace

Counts counts_per_query(const measure::CallgrindCounts& few, const measure::CallgrindCounts& many, int passes,
                        double queries) {
    if (many.instructions <= few.instructions)
        return measure::Refusal{"a run of more passes took no more instructions"};
    const auto each = [&](double of_few, double of_many) { return (of_many - of_few) / passes / queries; };
    measure::CallgrindCounts counts{each(few.instructions, many.instructions),
                                    each(few.accesses, many.accesses), each(few.d1_misses, many.d1_misses),
                                    each(few.ll_misses, many.ll_misses)};
    if (few.mispredictions && many.mispredictions)
        counts.mispredictions = each(*few.mispredictions, *many.mispredictions);
    return {counts};
}

std::string compare_passes(const std::string& printed, const bench::PassSum& expected, bool is_peer) {
    std::istringstream words(printed);
    std::size_t queries = 0;
    double distances = 0;
    if (!(words >> queries >> distances)) return "it did not say what its pass gave";
    const double allowed = is_peer ? verified_error_single * std::abs(expected.distances) : 0;
    if (queries == expected.queries && std::abs(distances - expected.distances) <= allowed) return {};
    return fmt::format("its pass gave other answers: {} distances add up to {}, not {} to {}", queries,
                       distances, expected.queries, expected.distances);
}

std::string check_program(const CellChoice& choice, const Effort& effort, const std::string& program) {
    const auto outcome = measure::run_program(pass_command(choice, program, few_passes));
    if (!outcome.value) return outcome.reason;
    if (outcome.value->exit_code != 0) {
        const std::string& err = outcome.value->err;
        return fmt::format("{} cannot run it: {}", program, err.substr(0, err.find('\n')));
    }
    return compare_passes(outcome.value->out, effort.passed, effort.is_peer);
}

Counts count_effort(const CellChoice& choice, const Effort& effort,
                    const measure::Expected<measure::CacheGeometry>& geometry,
                    const measure::Expected<std::string>& program) {
    if (!geometry.value) return geometry.refusal();
    if (!program.value) return program.refusal();
    if (const std::string wrong = check_program(choice, effort, *program.value); !wrong.empty())
        return Counts::none(
            wrong, effort.is_peer ? "build edgewise_sim, and the library for a processor without AVX-512"
                                  : "build edgewise_sim with EDGEWISE_SIM_LAYOUTS naming the table type");
    const Counts few = callgrind_pass(choice, *geometry.value, *program.value, few_passes);
    if (!few.value) return few;
    const Counts many = callgrind_pass(choice, *geometry.value, *program.value, many_passes);
    if (!many.value) return many;
    return counts_per_query(*few.value, *many.value, many_passes - few_passes,
                            static_cast<double>(effort.passed.queries));
}

Effort examine(const CellChoice& choice) {
    const SingleCell cell(choice);
    const bench::TableType& type = cell.type();
    const Ledger ledger = cell.runner().ledger();
    Effort effort;
    effort.table = type.name;
    effort.algorithm = cell.algorithm();
    effort.is_peer = type.is_peer;
    effort.table_bytes = static_cast<double>(ledger.total());
    effort.object_bytes = static_cast<double>(cell.runner().object_bytes());
    effort.pair_bytes = static_cast<double>(cell.runner().pair_bytes());
    effort.wrong = cell.prepared().wrong();
    effort.steps =
        type.is_peer ? Count::none("a library reports no steps") : Count{cell.prepared().mean_steps()};
    const double bytes_of_vertex = vertex_bytes(cell, ledger);
    take_trace(cell, bytes_of_vertex, effort);
    // A library may know neighbours that it does not expose: the lower of the two floors.
    const bool knows_neighbours = type.is_peer || ledger[Component::topology] > 0;
    effort.floor =
        proof_floor(cell.workload(), cell.runner().stored_bodies(), {knows_neighbours, bytes_of_vertex});
    effort.passed = cell.runner().prepared_pass()();
    return effort;
}

}  // namespace edgewise::studies
