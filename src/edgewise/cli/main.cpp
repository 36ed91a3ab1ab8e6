// SPDX-License-Identifier: MIT
//
// The command line: one file per command. Whatever a command throws ends as one line on stderr and exit
// code 2. So does output that did not arrive: stdout is flushed and tested once, here. A reader that closes
// the pipe ("edgewise list layouts | head -1") ends the program by SIGPIPE, as it ends other programs.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/cli/usage/usage.hpp"

namespace {

using namespace edgewise::cli;

/// In the order of the help text.
constexpr void (*commands[])(CLI::App&, Context&) = {
    add_sweep,   add_advise, add_stability, add_merge, add_campaign, add_report,  add_export,
    add_compare, add_bytes,  add_draw,      add_query, add_judge,    add_machine, add_caches,
    add_lock,    add_paging, add_fields,    add_bench, add_pass,     add_record,  add_list};

/// Fills the places of standard streams that the caller closed. The next file that is opened would take such
/// a place, and printed text would be written into it.
void fill_closed_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) >= 0) continue;
        static_cast<void>(open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY));
    }
}

/// Flushes stdout. The line to end with if printed text did not arrive; empty if all of it did. `known`: the
/// reason, where the text that failed was not the last.
std::string lost_output(const std::string& known) {
    const int failed = std::fflush(stdout) == 0 ? 0 : errno;
    if (failed == 0 && std::ferror(stdout) == 0) return {};
    return fmt::format("stdout: {}: what was printed is incomplete",
                       failed != 0 ? std::strerror(failed) : known);
}

std::string memory_text() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    const std::string limited = limit.rlim_cur == RLIM_INFINITY
                                    ? ""
                                    : fmt::format(", or raise ulimit -v ({} MiB)", limit.rlim_cur >> 20);
    return fmt::format(
        "out of memory: ask for fewer queries or smaller bodies{}; what is stored stays ({} MiB were in use; if "
        "little was asked for, this is a defect to report)",
        limited, use.ru_maxrss >> 10);
}

std::string version_text() {
    const edgewise::store::BuildRow build = edgewise::bench::this_build();
    return fmt::format("edgewise {}, revision {}, {}", edgewise::bench::project_version(), build.git_revision,
                       build.compiler);
}

/// Options of tests and of the installation, which --help does not show.
void add_hidden_options(CLI::App& app, bool& parse_only) {
    app.add_flag("--parse-only", parse_only, "reads the command line and does nothing")->group("");
    app.add_option_function<std::string>(
           "--print",
           [&app](const std::string& name) {
               fmt::print("{}", manual_text(app, name));
               throw CLI::Success();
           },
           "prints a text on all commands: options, man, bash, zsh or fish")
        ->group("");
}

/// The exit code; `problem` is what to say on stderr, if there is something.
int run(int argc, char** argv, std::string& problem) {
    CLI::App app{"Edgewise: memory- and cache-focused profiling of convex collision detection"};
    app.require_subcommand(1);
    app.set_help_all_flag("--help-all", "Help of all commands");
    app.set_version_flag("--version", version_text, "Version, revision and compiler");
    app.failure_message(one_line);
    bool parse_only = false;
    add_hidden_options(app, parse_only);
    Context context;
    for (const auto add : commands) add(app, context);
    try {
        app.parse(argc, argv);
        return parse_only ? exit_done : context.action();
    } catch (const CLI::ParseError& slip) {
        std::ostringstream help;
        const int code = app.exit(slip, help, std::cerr) == 0 ? exit_done : exit_bad_input;
        if (std::fputs(help.str().c_str(), stdout) == EOF) problem = std::strerror(errno);
        return code;
    } catch (const std::bad_array_new_length& impossible) {
        problem = fmt::format("an impossible count ({}): this is a defect to report", impossible.what());
    } catch (const std::bad_alloc&) {
        problem = memory_text();
    } catch (const std::length_error& impossible) {
        problem = fmt::format("an impossible count ({}): this is a defect to report", impossible.what());
    } catch (const std::system_error& failed) {
        problem = std::ferror(stdout) != 0 ? failed.code().message() : failed.what();
        if (failed.code() == std::errc::resource_unavailable_try_again)
            problem =
                "no thread can be started: raise the limit on address space (ulimit -v) or processes (-u)";
    } catch (const std::exception& any) {
        problem = any.what();
    }
    return exit_bad_input;
}

}  // namespace

int main(int argc, char** argv) {
    fill_closed_streams();
    std::string problem;
    int code = run(argc, argv, problem);
    if (const std::string lost = lost_output(problem); !lost.empty()) {
        problem = lost;
        code = exit_bad_input;
    }
    if (!problem.empty()) warn(problem);
    return code;
}
