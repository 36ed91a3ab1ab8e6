// SPDX-License-Identifier: MIT
//
// golden_work [--some] FILE | --update FILE
//
// What each table type x algorithm costs per query on fixed workloads, in numbers that do not depend on the
// clock: steps (states or iterations), reads, and cache lines of 64 bytes read. Beside those in the file,
// with a slack of 2 %: more is a loss, and less a gain that the file should hold. If it was meant to,
// --update and commit the file with it. --some: this program has only some layouts.
#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/sweep/shared_queries.hpp"

namespace edgewise {
namespace {

constexpr double slack = 0.02;
constexpr std::size_t queries = 500;

struct Work {
    double steps = 0, reads = 0, lines = 0;  ///< per query
};
using Works = std::map<std::string, Work>;  // table type, algorithm, scene, shape

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

    [[nodiscard]] Work per_query(const std::vector<Distance>& answers) const {
        double steps = 0;
        for (const Distance& answer : answers) steps += answer.steps;
        const auto count = static_cast<double>(answers.size());
        return {steps / count, static_cast<double>(reads_) / count, static_cast<double>(lines_) / count};
    }

  private:
    std::size_t reads_ = 0, lines_ = 0;
    std::unordered_set<std::uint64_t> query_lines_;
};

void add_works(Works& works, const sweep::SceneChoice& scene, const std::string& scene_name,
               const std::string& shape) {
    sweep::Plan plan;
    plan.seed = 20010168;
    plan.queries = queries;
    const sweep::SharedQueries asked(plan, scene,
                                     {shape, "built-in", scene::make_shape(shape).or_throw(), ""});
    for (const bench::TableType& type : bench::table_types()) {
        for (const std::string& algorithm : type.algorithms) {
            const auto runner = type.make_runner(algorithm);
            const std::string error = runner->load(asked.workload());
            if (!error.empty()) throw std::runtime_error(type.name + ": " + error);
            WorkCount count;
            std::vector<Distance> answers(asked.workload().queries.size());
            static_cast<void>(runner->trace(answers.size(), count, answers.data()));
            works[fmt::format("{} {} {} {}", type.name, algorithm, scene_name, shape)] =
                count.per_query(answers);
        }
    }
}

Works all_works() {
    Works works;
    for (const char* shape : {"cube8", "sphere386"}) {
        add_works(works, {"cold", {}}, "cold", shape);
        add_works(works, {"tumble", {{"rotation_step", 0.01}}}, "tumble_0.01", shape);
        add_works(works, {"tumble", {{"random_orientation", 1}}}, "tumble_random", shape);
    }
    return works;
}

std::string text_of(const Work& work) {
    return fmt::format("{:.3f} steps {:.2f} reads {:.2f} lines", work.steps, work.reads, work.lines);
}

Works read_works(const std::string& file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error(file + ": cannot be read");
    Works works;
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words(line);
        std::string type, algorithm, scene, shape, unit;
        Work work;
        words >> type >> algorithm >> scene >> shape >> work.steps >> unit >> work.reads >> unit >>
            work.lines >> unit;
        if (!words) throw std::runtime_error(file + ": not a line of work: " + line);
        works[fmt::format("{} {} {} {}", type, algorithm, scene, shape)] = work;
    }
    return works;
}

bool alike(double found, double expected) { return std::abs(found - expected) <= slack * expected; }

/// How many rows differ by more than the slack, are missing or are too many; each is named.
int differences(const Works& found, const Works& expected, bool some) {
    int count = 0;
    for (const auto& [what, work] : found) {
        const auto place = expected.find(what);
        if (place != expected.end() && alike(work.steps, place->second.steps) &&
            alike(work.reads, place->second.reads) && alike(work.lines, place->second.lines))
            continue;
        ++count;
        fmt::print(stderr, "{}: {} here, {} in the file\n", what, text_of(work),
                   place == expected.end() ? "missing" : text_of(place->second));
    }
    for (const auto& [what, work] : expected) {
        if (some || found.count(what)) continue;
        ++count;
        fmt::print(stderr, "{}: in the file, but not in this program\n", what);
    }
    return count;
}

int update(const std::string& file, const Works& works) {
    std::FILE* const stream = std::fopen(file.c_str(), "w");
    if (!stream) throw std::runtime_error(file + ": cannot be written");
    for (const auto& [what, work] : works) fmt::print(stream, "{} {}\n", what, text_of(work));
    return std::fclose(stream);
}

int run(std::vector<std::string> arguments) {
    const bool some = std::erase(arguments, "--some") > 0;
    const bool updates = std::erase(arguments, "--update") > 0;
    if (arguments.size() != 1 || (some && updates)) {
        fmt::print(stderr, "usage: golden_work [--some] FILE | --update FILE\n");
        return 2;
    }
    const Works found = all_works();
    if (updates) return update(arguments[0], found);
    const int count = differences(found, read_works(arguments[0]), some);
    fmt::print("{} of {} rows differ by more than {:.0f} %\n", count, found.size(), 100 * slack);
    if (count > 0) fmt::print(stderr, "if this was meant: golden_work --update {}\n", arguments[0]);
    return count > 0 ? 1 : 0;
}

}  // namespace
}  // namespace edgewise

int main(int count, char** values) {
    try {
        return edgewise::run({values + 1, values + count});
    } catch (const std::exception& problem) {
        fmt::print(stderr, "golden_work: {}\n", problem.what());
        return 2;
    }
}
