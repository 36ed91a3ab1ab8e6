// SPDX-License-Identifier: MIT
//
// A file that a user names to be written. It depends on what exists at that name:
//
// nothing or a regular file: the text is written to a temporary file next to it, which is renamed at the end.
// A reader never sees half a file, and a full disk leaves the old one.
//
// a link: the file that it leads to is replaced, the link stays.
//
// a device, a pipe, or an open file of a process (/dev/stdout, /dev/fd/3): written directly.
//
// a folder, a socket, or a file that is write-protected: refused.
#pragma once

#include <fstream>
#include <string>
#include <string_view>

namespace edgewise::input {

struct OutputPlace {
    std::string file;          ///< at the end of all links
    bool is_replaced = false;  ///< by a new file; else it is written directly
};

/// Throws std::runtime_error with one line that names the path.
[[nodiscard]] OutputPlace output_place(const std::string& path);

class OutputFile {
  public:
    /// Throws std::runtime_error with one line that names the path.
    explicit OutputFile(const std::string& path);
    /// Removes the temporary file unless `finish` renamed it. So does a signal that ends the program.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    [[nodiscard]] std::ostream& stream() { return stream_; }
    /// Call it once, at the end. Throws std::runtime_error if anything was not written.
    void finish();

  private:
    [[noreturn]] void fail(int error) const;
    void remove_temporary();

    std::string path_;  ///< as it was named
    OutputPlace place_;
    std::string temporary_;  ///< empty if the place is written directly
    std::ofstream stream_;
};

/// Writes the whole file. Throws std::runtime_error as OutputFile does.
void write_output(const std::string& path, std::string_view text);

}  // namespace edgewise::input
