// SPDX-License-Identifier: MIT
#include "program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "cli_paths.hpp"

namespace edgewise::cli_test {

namespace {

void redirect(int stream, const std::filesystem::path& to, int flags) {
    const int file = open(to.c_str(), flags | O_CLOEXEC, 0600);
    if (file < 0 || dup2(file, stream) < 0) _exit(126);
}

}  // namespace

Folder::Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "edgewise_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
    path_ = name;
}

Folder::~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string Folder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return name;
}

Arguments words_of(const std::string& line) {
    Arguments words;
    std::istringstream text(line);
    for (std::string word; text >> word;) words.push_back(word);
    return words;
}

Arguments with(Arguments words, const Arguments& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

Process::Process(const std::string& program, const Arguments& arguments, const Folder& folder)
    : out_(folder / "standard_output"), err_(folder / "standard_error") {
    Arguments words = with({program}, arguments);
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    id_ = fork();
    if (id_ < 0) throw std::runtime_error("cannot fork");
    if (id_ > 0) return;
    if (chdir(folder.path().c_str()) != 0) _exit(126);
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, out_, O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDERR_FILENO, err_, O_WRONLY | O_CREAT | O_TRUNC);
    execv(pointers[0], pointers.data());
    _exit(127);
}

Process::~Process() {
    if (has_ended()) return;
    kill(id_, SIGKILL);
    waitpid(id_, &state_, 0);
}

void Process::send(int signal) const { kill(id_, signal); }

bool Process::has_ended() {
    waited_for_ = waited_for_ || waitpid(id_, &state_, WNOHANG) == id_;
    return waited_for_;
}

Outcome Process::wait() {
    while (!waited_for_) {
        if (waitpid(id_, &state_, 0) == id_) {
            waited_for_ = true;
        } else if (errno != EINTR) {
            throw std::runtime_error("the process was lost");
        }
    }
    Outcome outcome;
    if (WIFEXITED(state_)) outcome.exit_code = WEXITSTATUS(state_);
    if (WIFSIGNALED(state_)) outcome.signal = WTERMSIG(state_);
    outcome.out = text_of(out_);
    outcome.err = text_of(err_);
    // How quiet the machine is differs from run to run: no message about what the program was asked.
    static const std::regex quietness("machine: others take [^\\n]*\\n");
    outcome.err = std::regex_replace(outcome.err, quietness, "");
    return outcome;
}

Outcome run(const Arguments& arguments, const Folder& folder) {
    return Process(program_path, arguments, folder).wait();
}

Outcome run_in_shell(const std::string& script, const Arguments& arguments, const Folder& folder) {
    return Process("/bin/sh", with({"-c", script, program_path}, arguments), folder).wait();
}

namespace {

/// Adds the commands that the --help of this one lists: each is at the start of a line, after two blanks.
void add_listed(const std::string& command, const Folder& folder, std::vector<std::string>& to) {
    const std::string help = run(called(command, {"--help"}), folder).out;
    if (!command.empty() && help.find("] SUBCOMMAND") == help.npos) to.push_back(command);
    bool below = false;
    for (const std::string& line : lines_of(help)) {
        if (line.empty()) below = false;
        if (below && line.starts_with("  ") && line.size() > 2 && line[2] != ' ')
            add_listed(command + (command.empty() ? "" : " ") + line.substr(2, line.find(' ', 2) - 2), folder,
                       to);
        below = below || line.starts_with("Subcommands");
    }
}

}  // namespace

std::vector<std::string> listed_commands(const Folder& folder) {
    std::vector<std::string> commands;
    add_listed("", folder, commands);
    return commands;
}

Arguments called(const std::string& command, const Arguments& more) { return with(words_of(command), more); }

std::vector<ListedOption> listed_options(const std::string& command, const Folder& folder) {
    std::vector<ListedOption> options;
    for (const std::string& line : lines_of(run(called(command, {"--help"}), folder).out)) {
        if (!line.starts_with("  -")) continue;
        std::istringstream words(line);
        ListedOption option;
        words >> option.name >> option.type;
        option.name = option.name.substr(option.name.find("--"));
        option.name = option.name.substr(0, option.name.find(','));
        if (!option.type.ends_with("=NUMBER"))  // what else follows is the value that is taken
            option.type = option.type.substr(0, option.type.find('='));
        options.push_back(option);
    }
    return options;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

}  // namespace edgewise::cli_test
