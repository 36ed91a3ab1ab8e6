// SPDX-License-Identifier: MIT
//
// A pipe between this process and one it forks; whole values go through it, bit by bit.
#pragma once

#include <unistd.h>

#include <cerrno>
#include <optional>
#include <stdexcept>
#include <type_traits>

namespace edgewise::bench {

class Pipe {
  public:
    Pipe() {
        if (pipe(ends_) != 0) throw std::runtime_error("no pipe: too many files are open");
    }
    ~Pipe() {
        close(ends_[0]);
        close_writing();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    /// Closes the writing end: readers see the end of the pipe once no other writer is left.
    void close_writing() const {
        if (ends_[1] >= 0) close(ends_[1]);
        ends_[1] = -1;
    }

    template <class Value>
    void send(const Value& value) const {
        static_assert(std::is_trivially_copyable_v<Value>);
        while (write(ends_[1], &value, sizeof value) < 0 && errno == EINTR) continue;
    }

    /// Receives a value; nothing when the other side ended without sending one.
    template <class Value>
    [[nodiscard]] std::optional<Value> receive() const {
        static_assert(std::is_trivially_copyable_v<Value>);
        Value value{};
        ssize_t count = -1;
        while ((count = read(ends_[0], &value, sizeof value)) < 0 && errno == EINTR) continue;
        if (count != static_cast<ssize_t>(sizeof value)) return std::nullopt;
        return value;
    }

  private:
    mutable int ends_[2] = {-1, -1};
};

}  // namespace edgewise::bench
