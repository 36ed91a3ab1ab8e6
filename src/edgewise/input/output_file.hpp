// SPDX-License-Identifier: MIT
//
// A file that a user names to be written. What is found there decides how:
//   nothing, a regular file   written to a temporary file next to it, which takes its name at the end: a
//   reader
//                             never sees half a file, and a full disk leaves the old one
//   a link                    followed: the file that it leads to is replaced, the link stays
//   a device, a pipe          written through, as is an open file of a process (/dev/stdout, /dev/fd/3)
//   a folder, a socket        refused, and a file that is write-protected
#pragma once

#include <fstream>
#include <string>
#include <string_view>

namespace edgewise::input {

struct OutputPlace {
    std::string file;          ///< at the end of all links
    bool is_replaced = false;  ///< by a new file; else it is written through
};

/// Throws std::runtime_error with one line that names the path.
[[nodiscard]] OutputPlace output_place(const std::string& path);

class OutputFile {
  public:
    /// Throws std::runtime_error with one line that names the path.
    explicit OutputFile(const std::string& path);
    /// Removes the temporary file unless `finish` gave it its name. A signal that ends the program does so
    /// too.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    [[nodiscard]] std::ostream& stream() { return stream_; }
    /// To be called once, at the end. Throws std::runtime_error if anything was not written.
    void finish();

  private:
    [[noreturn]] void fail(int error) const;
    void remove_temporary();

    std::string path_;  ///< as it was named
    OutputPlace place_;
    std::string temporary_;  ///< empty where the place is written through
    std::ofstream stream_;
};

/// The whole file. Throws std::runtime_error as OutputFile does.
void write_output(const std::string& path, std::string_view text);

}  // namespace edgewise::input
