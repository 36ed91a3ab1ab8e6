// SPDX-License-Identifier: MIT
//
// fork(2), setrlimit(2) on the address space, a pipe for the answer. The limit is added to what is mapped
// already, which is terabytes under a sanitizer.
#include "edgewise/input/guarded.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>

namespace edgewise::input {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int exit_done = 0, exit_memory = 3, exit_pipe = 4;

std::uint64_t mapped_bytes() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

bool write_all(int to, const std::string& bytes) {
    for (std::size_t sent = 0; sent < bytes.size();) {
        const ssize_t count = write(to, bytes.data() + sent, bytes.size() - sent);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        sent += static_cast<std::size_t>(count);
    }
    return true;
}

/// Runs the work in the child, with default signal handlers. The child ends with its parent.
[[noreturn]] void run_child(const std::function<std::string()>& work, const GuardLimits& limits, int to,
                            pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(exit_pipe);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
    const rlimit memory{mapped_bytes() + limits.memory_bytes, mapped_bytes() + limits.memory_bytes};
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_AS, &memory);
    setrlimit(RLIMIT_CORE, &no_core);
    try {
        _exit(write_all(to, work()) ? exit_done : exit_pipe);
    } catch (const std::bad_alloc&) {
        _exit(exit_memory);
    }
}

/// Reads to the end; false if the time is up before.
bool read_all(int from, Clock::time_point end, std::string& to) {
    char buffer[65536];
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        pollfd waiting{from, POLLIN, 0};
        const int ready = poll(&waiting, 1, static_cast<int>(std::max<long long>(left, 0)));
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) return false;
        const ssize_t count = read(from, buffer, sizeof buffer);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return count == 0;
        to.append(buffer, static_cast<std::size_t>(count));
    }
}

}  // namespace

Result<std::string> run_guarded(const std::function<std::string()>& work, const GuardLimits& limits) {
    using Answer = Result<std::string>;
    int ends[2];
    if (pipe(ends) != 0) return Answer::failure(fmt::format("no pipe can be made: {}", std::strerror(errno)));
    const pid_t parent = getpid(), child = fork();
    if (child == 0) {
        close(ends[0]);
        run_child(work, limits, ends[1], parent);
    }
    close(ends[1]);
    std::string answer;
    const bool in_time = child > 0 && read_all(ends[0], Clock::now() + limits.time, answer);
    close(ends[0]);
    if (child < 0) return Answer::failure("no process can be made: out of memory or of processes");
    if (!in_time) kill(child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!in_time)
        return Answer::failure(fmt::format("took longer than the {:.3g} s it was given",
                                           std::chrono::duration<double>(limits.time).count()));
    if (WIFEXITED(status) && WEXITSTATUS(status) == exit_done) return Answer::success(std::move(answer));
    if (WIFEXITED(status) && WEXITSTATUS(status) == exit_memory)
        return Answer::failure(
            fmt::format("took more than the {} MiB of memory it was given", limits.memory_bytes >> 20));
    return Answer::failure(WIFSIGNALED(status) ? fmt::format("crashed (signal {})", WTERMSIG(status))
                                               : fmt::format("ended with code {}", WEXITSTATUS(status)));
}

}  // namespace edgewise::input
