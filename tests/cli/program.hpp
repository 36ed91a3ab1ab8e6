// SPDX-License-Identifier: MIT
//
// Runs the program as a shell would: arguments, a working folder of its own, both outputs caught, signals on
// demand.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace edgewise::cli_test {

/// Removed with all it holds at the end of its scope.
class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Returns the file's name.
    std::string write(const std::string& name, const std::string& text) const;

  private:
    std::filesystem::path path_;
};

using Arguments = std::vector<std::string>;

/// The words between the blanks of a line.
[[nodiscard]] Arguments words_of(const std::string& line);

/// The words and then more.
[[nodiscard]] Arguments with(Arguments words, const Arguments& more);

struct Outcome {
    int exit_code = -1;  ///< -1 when a signal ended it
    int signal = 0;
    std::string out, err;  ///< err: without the line on how quiet the machine is
};

class Process {
  public:
    /// `program` is started in `folder`, its standard input empty.
    Process(const std::string& program, const Arguments& arguments, const Folder& folder);
    /// Kills the process if no caller waited for it.
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    [[nodiscard]] pid_t id() const { return id_; }
    void send(int signal) const;
    [[nodiscard]] bool has_ended();
    [[nodiscard]] Outcome wait();

  private:
    pid_t id_ = 0;
    bool waited_for_ = false;
    int state_ = 0;
    std::filesystem::path out_, err_;
};

/// The program under test, to its end.
[[nodiscard]] Outcome run(const Arguments& arguments, const Folder& folder);

/// Runs the program by a shell: the script calls it as "$0" "$@".
[[nodiscard]] Outcome run_in_shell(const std::string& script, const Arguments& arguments,
                                   const Folder& folder);

/// Commands that --help lists, also those nested in others, by the words that call them: "advise budget". A
/// command that only groups others is left out.
[[nodiscard]] std::vector<std::string> listed_commands(const Folder& folder);
/// The command line that calls such a command with further words.
[[nodiscard]] Arguments called(const std::string& command, const Arguments& more);

/// An option of a command as its --help shows it, such as "--margin" and "NUMBER".
struct ListedOption {
    std::string name, type;
};
[[nodiscard]] std::vector<ListedOption> listed_options(const std::string& command, const Folder& folder);

[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);
[[nodiscard]] std::string text_of(const std::filesystem::path& file);

}  // namespace edgewise::cli_test
