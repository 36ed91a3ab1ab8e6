// SPDX-License-Identifier: MIT
//
// golden_work [--some] FILE | --update FILE
//
// Cost per query of each table type x algorithm on fixed workloads, in numbers that do not depend on the
// clock: steps (states or iterations), reads, and cache lines of 64 bytes read. Compares them with those in
// the file, with a slack of 2 %: more is a loss, and less is a gain that the file should hold. If a change is
// meant, --update and commit the file with it. --some: this program has only some layouts.
#include <fmt/core.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/sweep/prepared_cell.hpp"
#include "golden_main.hpp"

namespace edgewise {
namespace {

constexpr double slack = 0.02;
constexpr std::size_t queries = 500;

/// Reads of tables, and the lines that each query reads.
class WorkCount final : public measure::TraceListener {
  public:
    void on_access(const measure::TracedAccess& access) override {
        if (access.side == measure::TraceSide::scene) return;
        ++reads_;
        const std::uint64_t last = (access.address + access.bytes - 1) / 64;
        for (std::uint64_t line = access.address / 64; line <= last; ++line) query_lines_.insert(line);
    }
    void on_query_end(bool /*counts*/) override {
        lines_ += query_lines_.size();
        query_lines_.clear();
    }

    [[nodiscard]] std::string per_query(const std::vector<Distance>& answers) const {
        double steps = 0;
        for (const Distance& answer : answers) steps += answer.steps;
        const auto count = static_cast<double>(answers.size());
        return fmt::format("{:.3f} steps {:.2f} reads {:.2f} lines", steps / count,
                           static_cast<double>(reads_) / count, static_cast<double>(lines_) / count);
    }

  private:
    std::size_t reads_ = 0, lines_ = 0;
    std::unordered_set<std::uint64_t> query_lines_;
};

void add_rows(golden::Rows& rows, const sweep::SceneChoice& scene, const std::string& scene_name,
              const std::string& shape) {
    sweep::Plan plan;
    plan.seed = 20010168;
    plan.queries = queries;
    const sweep::SharedQueries asked(plan, scene,
                                     {shape, "built-in", scene::make_shape(shape).or_throw(), ""});
    for (const bench::TableType& type : bench::table_types()) {
        for (const std::string& algorithm : type.algorithms) {
            if (!type.stored_body(asked.workload().bodies[0])) continue;  // too large for the layout
            const auto runner = type.make_runner(algorithm);
            const std::string error = runner->load(asked.workload());
            if (!error.empty()) throw std::runtime_error(type.name + ": " + error);
            WorkCount count;
            std::vector<Distance> answers(asked.workload().queries.size());
            static_cast<void>(runner->trace(answers.size(), count, answers.data()));
            rows[fmt::format("{} {} {} {}", type.name, algorithm, scene_name, shape)] =
                count.per_query(answers);
        }
    }
}

golden::Rows all_rows() {
    golden::Rows rows;
    for (const char* shape : {"cube8", "sphere386"}) {
        add_rows(rows, {"cold", {}}, "cold", shape);
        add_rows(rows, {"tumble", {{"rotation_step", 0.01}}}, "tumble_0.01", shape);
        add_rows(rows, {"tumble", {{"random_orientation", 1}}}, "tumble_random", shape);
    }
    return rows;
}

}  // namespace
}  // namespace edgewise

int main(int count, char** values) {
    using namespace edgewise;
    const golden::Program program{"golden_work",
                                  "[--some] FILE | --update FILE",
                                  fmt::format("rows differ by more than {:.0f} %", 100 * slack),
                                  6,
                                  all_rows,
                                  slack};
    return golden::run_or_say_why(program, [&] {
        return golden::run(program, {values + 1, values + count});
    });
}
