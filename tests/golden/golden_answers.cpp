// SPDX-License-Identifier: MIT
//
// golden_answers [--some] [--answers] FILE | --update FILE | --details | --questions FILE TYPE
//
// One hash of all answers of each table type x algorithm to a fixed, seeded set of queries: every scene,
// small and large bodies; status, distance, witness points, steps, fallbacks and refinements, bit by bit.
// Another one of its answers to the corpus, and to random pairs of bodies; one of the bytes of its tables by
// purpose, of the object that holds a table, and of a pair's cache; and one of its trace. And one hash of the
// queries themselves for each scene. All are the same on every compiler and machine, except traces: the
// compiler chooses in which order the operands of an expression are read, and the file has g++'s traces. A
// difference means that a change moved some bits. If a change is meant, --update and commit the file with it.
// --some: this program has only some layouts, and rows of other layouts in the file do not count. --answers:
// traces do not count. --questions: writes the queries to the file, as numbers, with bodies as the table type
// stores them, for processors/answers.hpp.
#include <fmt/core.h>

#include <bit>
#include <fstream>
#include <iomanip>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "corpus.hpp"
#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/prepared_workload.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/sweep/prepared_cell.hpp"
#include "golden_main.hpp"
#include "random_workloads.hpp"

namespace edgewise {
namespace {

constexpr const char* shapes[] = {"tetra4", "cube8", "sphere38", "sphere386"};

/// What was hashed -> the hash, so far.
using Prints = std::map<std::string, bench::Fingerprint>;

sweep::Plan golden_plan() {
    sweep::Plan plan;
    plan.seed = 20010168;
    plan.queries = 2000;
    return plan;
}

void add(bench::Fingerprint& print, const Vec3d& v) { print.add(v.x()).add(v.y()).add(v.z()); }

void add(bench::Fingerprint& print, const Pose& pose) {
    for (int row = 0; row < 3; ++row) add(print, Vec3d(pose.rotation.row(row)));
    add(print, pose.translation);
}

void add(bench::Fingerprint& print, const scene::Workload& workload) {
    for (const Polyhedron& body : workload.bodies) print.add(body);
    for (const scene::Query& query : workload.queries) {
        print.add(std::uint64_t{query.body_a})
            .add(std::uint64_t{query.body_b})
            .add(std::uint64_t{query.pair});
        add(print, query.pose_a);
        add(print, query.pose_b);
    }
}

void add(bench::Fingerprint& print, const Distance& answer) {
    print.add(static_cast<std::uint64_t>(answer.status)).add(answer.distance);
    add(print, answer.point_a);
    add(print, answer.point_b);
    print.add(static_cast<std::uint64_t>(answer.steps));
    print.add(static_cast<std::uint64_t>(answer.cycles)).add(static_cast<std::uint64_t>(answer.fallbacks));
    print.add(static_cast<std::uint64_t>(answer.refinements));
}

/// Adds the bytes of the first table by purpose, of the object that holds it, and of a pair's cache.
void add_bytes(bench::Fingerprint& print, const bench::Runner& runner) {
    for (const std::uint64_t bytes : runner.ledger().bytes) print.add(bytes);
    print.add(std::uint64_t{runner.object_bytes()}).add(std::uint64_t{runner.pair_bytes()});
}

/// Every table type and algorithm on one workload, if the layout can hold its bodies. Rows begin with `set`.
void add_answers(Prints& prints, const std::string& set, const scene::Workload& workload,
                 const std::string& detail) {
    for (const bench::TableType& type : bench::table_types()) {
        for (const std::string& algorithm : type.algorithms) {
            const auto runner = type.make_runner(algorithm);
            if (!runner->load(workload).empty()) continue;
            const std::string cell = type.name + " " + algorithm + detail;
            add_bytes(prints["bytes " + cell], *runner);
            bench::Fingerprint& print = prints[set + cell];
            for (const Distance& answer : runner->answer()) add(print, answer);
        }
    }
}

/// Every access of a trace: addresses, sizes, kinds, fields and steps.
class TracePrint final : public measure::TraceListener {
  public:
    explicit TracePrint(bench::Fingerprint& print) : print_(print) {}

    void on_access(const measure::TracedAccess& access) override {
        print_.add(access.address).add(std::uint64_t{access.bytes});
        print_.add(static_cast<std::uint64_t>(access.kind)).add(std::uint64_t{access.field});
        print_.add(std::uint64_t{access.step}).add(static_cast<std::uint64_t>(access.side));
    }
    void on_query_end(bool counts) override { print_.add(static_cast<std::uint64_t>(counts)); }
    void on_frame_end() override { print_.add(std::uint64_t{1} << 32); }

  private:
    bench::Fingerprint& print_;
};

/// What every table type and algorithm reads and writes in a scene with a broad phase, of cubes where the
/// layout cannot hold a sphere.
void add_traces(Prints& prints) {
    sweep::Plan plan = golden_plan();
    plan.queries = 600;
    const sweep::SceneChoice scene{"tumble", {{"bodies", 30}, {"in_time_order", 1}, {"rotation_step", 0.3}}};
    const auto asked = [&](const char* shape) {
        return sweep::SharedQueries(plan, scene,
                                    {shape, "built-in", scene::make_shape(shape).or_throw(), ""});
    };
    const sweep::SharedQueries spheres = asked("sphere38"), cubes = asked("cube8");
    for (const bench::TableType& type : bench::table_types()) {
        for (const std::string& algorithm : type.algorithms) {
            const bool holds = static_cast<bool>(type.stored_body(spheres.workload().bodies[0]));
            const auto runner = type.make_runner(algorithm);
            const std::string error = runner->load((holds ? spheres : cubes).workload());
            if (!error.empty()) throw std::runtime_error(type.name + ": " + error);
            TracePrint print(prints["trace " + type.name + " " + algorithm]);
            runner->trace(plan.queries, print);
        }
    }
}

/// The workload in a runner's unit of length, with rotations made orthonormal.
scene::Workload prepared(scene::Workload given) {
    bench::PreparedWorkload ready;
    const std::string error = ready.take_bodies(given.bodies, VertexOrder::given, [](const Polyhedron& body) {
        return Result<Polyhedron>::success(body);
    });
    if (!error.empty()) throw std::runtime_error(error);
    ready.take_queries(given);
    given.queries = ready.workload().queries;
    given.bodies = ready.bodies();
    return given;
}

/// Calls use(set, scene, shape, workload) for each; rows of answers begin with `set`.
template <class Use>
void for_all_workloads(const Use& use) {
    for (const scene::SceneInfo& scene : scene::list_scenes()) {
        // The questions of tumble, to more tables and closer by; those of cold, at other gaps.
        if (scene.name == "pressure" || scene.name == "proximity" || scene.name == "gap" ||
            scene.name == "resting")
            continue;
        if (scene.name == scene::recorded_kind) continue;  // made from a file
        for (const char* shape : shapes) {
            auto body = scene::make_shape(shape);
            if (!body) throw std::runtime_error(body.error);
            const sweep::SharedQueries queries(golden_plan(), {scene.name, {}},
                                               {shape, "built-in", std::move(*body), ""});
            use("", scene.name, shape, queries.workload());
        }
    }
    for (const scene::Case& given : corpus()) {
        scene::Workload pair;
        for (const scene::CaseBody* body : {&given.a, &given.b})
            pair.bodies.push_back(scene::body_from_case(*body).or_throw());
        pair.queries = {{0, 1, 0, given.pose_a, given.pose_b}};
        pair.pair_count = 1;
        use("corpus ", "corpus", given.id, prepared(pair));
    }
    for (const scene::Workload& pairs : random_workloads(200)) use("pairs ", "pairs", "", prepared(pairs));
}

Prints all_prints(bool details) {
    Prints prints;
    for_all_workloads([&](const std::string& set, const std::string& scene, const std::string& shape,
                          const scene::Workload& workload) {
        const std::string detail = details ? fmt::format(" {} {}", scene, shape) : "";
        add(prints["queries " + scene + (details ? fmt::format(" {}", shape) : "")], workload);
        add_answers(prints, set, workload, detail);
    });
    add_traces(prints);
    return prints;
}

/// Writes whole numbers, one a line; doubles as their bits.
class NumberFile {
  public:
    explicit NumberFile(const std::string& file) : file_(file) {}

    void write(std::uint64_t number) { file_ << number << '\n'; }
    void write(double number) { write(std::bit_cast<std::uint64_t>(number)); }
    void write(const Vec3d& v) {
        for (int i = 0; i < 3; ++i) write(v[i]);
    }
    template <class Number>
    void write(const std::vector<Number>& numbers) {
        write(std::uint64_t{numbers.size()});
        for (const Number& number : numbers) write(number);
    }
    void write(Index number) { write(std::uint64_t{number}); }
    void write(const PolyhedronEdge& edge) {
        for (const Index end : {edge.tail, edge.head, edge.left, edge.right}) write(end);
    }
    void write(const Plane<double>& plane) {
        write(plane.normal);
        write(plane.offset);
    }
    void write(const Polyhedron& body) {
        write(body.vertices);
        write(body.edges);
        write(body.face_planes);
        for (const auto* list :
             {&body.input_index, &body.face_offset, &body.face_ring, &body.vertex_offset, &body.vertex_ring})
            write(*list);
    }
    void write(const Pose& pose) {
        for (int row = 0; row < 3; ++row) write(Vec3d(pose.rotation.row(row)));
        write(pose.translation);
    }
    void write(const scene::Query& query) {
        for (const std::uint32_t number : {query.body_a, query.body_b, query.pair}) write(number);
        write(query.pose_a);
        write(query.pose_b);
    }
    /// The bodies are written as the runner stores them.
    void write(const std::string& set, const scene::Workload& workload, const bench::Runner& runner) {
        file_ << std::quoted(set) << '\n';
        write(std::uint64_t{workload.warm});
        write(std::uint64_t{workload.pair_count});
        const auto bodies = runner.stored_bodies();
        write(std::vector<Polyhedron>(bodies.begin(), bodies.end()));
        write(workload.queries);
    }

  private:
    std::ofstream file_;
};

void write_questions(const std::string& to, const std::string& type) {
    NumberFile file(to);
    const bench::TableType& asked = bench::table_type_called(type);
    for_all_workloads([&](const auto& set, const auto&, const auto&, const auto& workload) {
        const auto runner = asked.make_runner("gjk");
        if (runner->load(workload).empty()) file.write(set, workload, *runner);
    });
}

golden::Rows rows_of(const Prints& prints) {
    golden::Rows rows;
    for (const auto& [what, print] : prints) rows[what] = print.hex();
    return rows;
}

}  // namespace
}  // namespace edgewise

int main(int count, char** values) {
    using namespace edgewise;
    std::vector<std::string> arguments(values + 1, values + count);
    const bool answers = std::erase(arguments, "--answers") > 0;
    const golden::Program program{"golden_answers",
                                  "[--some] [--answers] FILE | --update FILE | --details | "
                                  "--questions FILE TYPE",
                                  "hashes differ",
                                  1,
                                  [] { return rows_of(all_prints(false)); },
                                  0,
                                  answers ? "trace " : ""};
    return golden::run_or_say_why(program, [&] {
        if (arguments.size() == 3 && arguments[0] == "--questions") {
            write_questions(arguments[1], arguments[2]);
            return 0;
        }
        if (arguments != std::vector<std::string>{"--details"}) return golden::run(program, arguments);
        golden::write_rows(stdout, rows_of(all_prints(true)));
        return 0;
    });
}
