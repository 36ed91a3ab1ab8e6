// SPDX-License-Identifier: MIT
#include "edgewise/measure/process/child_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

extern "C" char** environ;

namespace edgewise::measure {

namespace {

/// A file without a name to write to, and to be read from then.
class Capture {
  public:
    Capture() : file_(std::tmpfile(), &std::fclose) {}

    [[nodiscard]] int descriptor() const { return file_ ? fileno(file_.get()) : -1; }
    [[nodiscard]] std::string text() const {
        std::string text;
        char buffer[4096];
        std::rewind(file_.get());
        for (std::size_t count = 0; (count = std::fread(buffer, 1, sizeof buffer, file_.get())) > 0;)
            text.append(buffer, count);
        return text;
    }

  private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace

Expected<ProcessOutcome> run_program(const std::vector<std::string>& command) {
    const Capture out, err;
    if (out.descriptor() < 0 || err.descriptor() < 0) return Refusal{"no temporary file can be made"};
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err.descriptor(), STDERR_FILENO);
    pid_t process = 0;
    const int error = posix_spawnp(&process, words[0], &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) return Refusal{command.front() + ": " + std::strerror(error)};
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {ProcessOutcome{code, out.text(), err.text()}};
}

}  // namespace edgewise::measure
