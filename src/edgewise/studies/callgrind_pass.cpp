// SPDX-License-Identifier: MIT
#include "edgewise/studies/callgrind_pass.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/measure/process/child_process.hpp"

namespace edgewise::studies {

namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& file) {
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Of this process, and of no other pass of it.
fs::path output_file() {
    static std::atomic<int> number = 0;
    return fs::temp_directory_path() / fmt::format("edgewise-callgrind-{}-{}", getpid(), number++);
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
    using Answer = measure::Expected<measure::CallgrindCounts>;
    const fs::path output = output_file();
    const auto outcome = measure::run_program(
        measure::callgrind_command(geometry, output, pass_command(choice, program, passes)));
    const std::string text = read_file(output);
    std::error_code ignored;
    fs::remove(output, ignored);
    if (!outcome.value) return Answer::none(outcome.reason, "install valgrind");
    if (outcome.value->exit_code != 0) {
        const std::string& err = outcome.value->err;
        return Answer::none(fmt::format("valgrind ended with {}: {}", outcome.value->exit_code,
                                        err.substr(err.size() > 300 ? err.size() - 300 : 0)));
    }
    return measure::parse_callgrind(text);
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

}  // namespace edgewise::studies
