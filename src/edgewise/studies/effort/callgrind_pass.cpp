// SPDX-License-Identifier: MIT
#include "edgewise/studies/effort/callgrind_pass.hpp"

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

/// Returns a file name for this pass; no other pass of this process has the same.
fs::path output_file() {
    static std::atomic<int> number = 0;
    return fs::temp_directory_path() / fmt::format("edgewise-callgrind-{}-{}", getpid(), number++);
}

/// Runs the command, which writes to a file of ours, and returns what `parse` makes of that file. The file
/// is removed afterwards.
template <class MakeCommand, class Parse>
auto read_output(const MakeCommand& command, const Parse& parse) {
    const fs::path file = output_file();
    const auto outcome = measure::run_program(command(file));
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
    const auto parse = [](std::istream& output) {
        std::ostringstream text;
        text << output.rdbuf();
        return measure::parse_callgrind(text.str());
    };
    const auto command = [&](const fs::path& output) {
        return measure::callgrind_command(geometry, output, pass_command(choice, program, passes));
    };
    return read_output(command, parse);
}

measure::Expected<measure::CallgrindLines> callgrind_lines(const CellChoice& choice,
                                                           const measure::CacheGeometry& geometry,
                                                           const std::string& program, int passes) {
    const auto command = [&](const fs::path& output) {
        auto words = measure::callgrind_command(geometry, output, pass_command(choice, program, passes));
        words.insert(words.begin() + 2, "--dump-instr=yes");  // after the tool's name
        return words;
    };
    return read_output(command, measure::parse_callgrind_lines);
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
