// SPDX-License-Identifier: MIT
#include "edgewise/input/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace edgewise::input {

namespace fs = std::filesystem;

namespace {

constexpr std::array ending_signals = {SIGHUP, SIGINT, SIGTERM};

/// The name of the temporary file that is being written.
std::atomic<const char*> unfinished{nullptr};
static_assert(std::atomic<const char*>::is_always_lock_free, "read in a signal handler");

void remove_unfinished(int signal) {
    if (const char* const name = unfinished.exchange(nullptr)) unlink(name);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// Removes the file if a signal ends the program. Signals that have a handler keep it.
void guard(const char* name) {
    const char* none = nullptr;
    if (!unfinished.compare_exchange_strong(none, name)) return;
    for (const int signal : ending_signals) {
        struct sigaction known {};
        if (sigaction(signal, nullptr, &known) == 0 && known.sa_handler == SIG_DFL)
            std::signal(signal, remove_unfinished);
    }
}

void stop_guarding(const char* name) {
    if (!unfinished.compare_exchange_strong(name, nullptr)) return;
    for (const int signal : ending_signals) {
        struct sigaction known {};
        if (sigaction(signal, nullptr, &known) == 0 && known.sa_handler == remove_unfinished)
            std::signal(signal, SIG_DFL);
    }
}

[[noreturn]] void refuse(const std::string& path, std::string_view what) {
    throw std::runtime_error(fmt::format("{}: {}", path, what));
}

bool is_of_proc(const fs::path& path) { return path.string().starts_with("/proc/"); }

/// The file at the end of a chain of links; it need not exist. Links of /proc are not followed: they are open
/// files and not names.
fs::path target_of(const fs::path& path) {
    constexpr int most_links = 40;  // as Linux
    fs::path at = path;
    std::error_code error;
    for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(at, error)); ++i) {
        if (is_of_proc(at)) return at;
        const fs::path to = fs::read_symlink(at, error);
        if (error) refuse(path.string(), error.message());
        at = to.is_absolute() ? to : at.parent_path() / to;
    }
    return at;
}

/// Makes a new, empty file next to `file`, with its permissions. `name`: of the new file, guarded before that
/// is there; empty, with errno set, if it cannot be made.
void make_beside(const std::string& file, std::string& name) {
    int made = -1;
    for (int i = 0; made < 0; ++i) {
        name = fmt::format("{}.{}-{}.tmp", file, getpid(), i);
        guard(name.c_str());
        made = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (made < 0) stop_guarding(name.c_str());
        if (made < 0 && errno != EEXIST) return name.clear();
    }
    struct stat before {};
    if (stat(file.c_str(), &before) == 0) static_cast<void>(fchmod(made, before.st_mode & 07777));
    close(made);
}

}  // namespace

OutputPlace output_place(const std::string& path) {
    if (path.empty() || path.ends_with('/')) refuse(path.empty() ? "''" : path, "names no file");
    const fs::path file = target_of(path);
    std::error_code error;
    switch (fs::status(file, error).type()) {
        case fs::file_type::regular:
            if (access(file.c_str(), W_OK) != 0) refuse(path, "is write-protected: name another file");
            return {file, !is_of_proc(file)};
        case fs::file_type::not_found:
            return {file, true};
        case fs::file_type::character:
        case fs::file_type::block:
        case fs::file_type::fifo:
            return {file, false};
        case fs::file_type::directory:
            refuse(path, "is a folder: name a file");
        case fs::file_type::socket:
            refuse(path, "is a socket: name a file");
        default:
            refuse(path, error ? error.message() : "is of a kind that cannot be written: name a file");
    }
}

OutputFile::OutputFile(const std::string& path) : path_(path), place_(output_place(path)) {
    if (place_.is_replaced) make_beside(place_.file, temporary_);
    const int error = errno;
    // A file in a folder that takes no new one, or a file that is mounted: it can still be written in place.
    place_.is_replaced = !temporary_.empty();
    if (!place_.is_replaced && !fs::exists(place_.file)) fail(error);
    stream_.open(place_.is_replaced ? temporary_ : place_.file, std::ios::binary);
    if (stream_) return;
    const int refused = errno;
    remove_temporary();
    fail(refused);
}

OutputFile::~OutputFile() { remove_temporary(); }

void OutputFile::remove_temporary() {
    if (temporary_.empty()) return;
    stop_guarding(temporary_.c_str());
    unlink(temporary_.c_str());
    temporary_.clear();
}

void OutputFile::fail(int error) const {
    refuse(path_, fmt::format("cannot be written: {}", std::strerror(error)));
}

void OutputFile::finish() {
    if (stream_) errno = 0;  // else it still says why the first write failed
    stream_.close();
    if (!stream_) fail(errno != 0 ? errno : EIO);
    if (!place_.is_replaced) return;
    if (std::rename(temporary_.c_str(), place_.file.c_str()) != 0) fail(errno);
    stop_guarding(temporary_.c_str());
    temporary_.clear();
}

void write_output(const std::string& path, std::string_view text) {
    OutputFile file(path);
    file.stream().write(text.data(), static_cast<std::streamsize>(text.size()));
    file.finish();
}

}  // namespace edgewise::input
