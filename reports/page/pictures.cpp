// SPDX-License-Identifier: MIT
//
// See pictures.hpp. Node is spawned with an argument list, never through a shell, so a path is only ever a
// path.
#include "edgewise/reports/page/pictures.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "edgewise/reports/page/bundles.hpp"
#include "edgewise/reports/page/files.hpp"

extern char** environ;

namespace edgewise::reports {

namespace {

/// Runs a program with its output thrown away; empty when it ended with 0, else why not.
std::string run_silently(std::vector<std::string> arguments) {
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
    pid_t child = 0;
    const int failed = posix_spawnp(&child, pointers[0], &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed == ENOENT) return fmt::format("{} is not installed", arguments[0]);
    if (failed) return fmt::format("{} cannot be started: {}", arguments[0], std::strerror(failed));
    int state = 0;
    while (waitpid(child, &state, 0) < 0)
        if (errno != EINTR) return fmt::format("{} was lost", arguments[0]);
    if (WIFEXITED(state) && WEXITSTATUS(state) == 0) return {};
    return fmt::format("{} ended with {}", arguments[0],
                       WIFEXITED(state) ? fmt::format("exit code {}", WEXITSTATUS(state)) : "a signal");
}

std::string render(const std::vector<std::string>& names, const std::filesystem::path& figures,
                   const std::filesystem::path& bundles) {
    const std::filesystem::path script = bundles / "render_svg.mjs";
    if (!std::filesystem::exists(script) || !have_bundles(bundles)) return "the chart bundles are not there";
    std::vector<std::string> arguments{"node", std::filesystem::absolute(script).string(),
                                       std::filesystem::absolute(bundles).string(),
                                       std::filesystem::absolute(figures).string()};
    arguments.insert(arguments.end(), names.begin(), names.end());
    return run_silently(std::move(arguments));
}

}  // namespace

StaticPictures write_pictures(const std::vector<Chart>& charts, const std::filesystem::path& out,
                              const std::filesystem::path& bundles) {
    const std::filesystem::path figures = out / "figures";
    std::error_code ignored;
    std::filesystem::create_directories(figures, ignored);
    std::vector<std::string> names;
    for (const Chart& chart : charts) {
        std::filesystem::remove(figures / (chart.name + ".svg"), ignored);
        std::filesystem::remove(figures / (chart.name + ".vl.json"), ignored);
        if (chart.spec.is_null()) continue;
        write_file(figures / (chart.name + ".vl.json"),
                   chart.spec.dump(-1, ' ', false, ChartJson::error_handler_t::replace) + "\n");
        names.push_back(chart.name);
    }
    StaticPictures result;
    if (names.empty()) return result;
    result.note = render(names, figures, bundles);
    if (!result.note.empty())
        result.note = "No static pictures of the charts: " + result.note +
                      " (install nodejs 18 or newer and the chart bundles, then write the report again).";
    for (const std::string& name : names)
        if (auto svg = read_file(figures / (name + ".svg"))) result.svg[name] = std::move(*svg);
    return result;
}

}  // namespace edgewise::reports
