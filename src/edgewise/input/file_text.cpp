// SPDX-License-Identifier: MIT
#include "edgewise/input/file_text.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace edgewise::input {

namespace fs = std::filesystem;

std::string what_is_wrong_with(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) return "no such file";
    if (status.type() == fs::file_type::directory) return "is a directory, and a file is wanted";
    if (status.type() == fs::file_type::none) return "cannot be looked at: " + error.message();
    if (status.type() != fs::file_type::regular)
        return "is no regular file but a pipe, a device or the like: write it to a file first";
    if (access(path.c_str(), R_OK) != 0) return "cannot be opened for reading; check its permissions";
    return {};
}

Result<std::string> read_file_text(const std::string& path, std::uint64_t most_bytes) {
    using Text = Result<std::string>;
    if (const std::string wrong = what_is_wrong_with(path); !wrong.empty())
        return Text::failure(fmt::format("{}: {}", path, wrong));
    std::error_code error;
    const auto size = fs::file_size(path, error);
    if (!error && size > most_bytes)
        return Text::failure(fmt::format("{}: has {} bytes, more than the {} that are read of such a file",
                                         path, size, most_bytes));
    std::ifstream stream(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream.is_open() || stream.bad()) return Text::failure(path + ": cannot be read");
    return Text::success(std::move(text));
}

}  // namespace edgewise::input
