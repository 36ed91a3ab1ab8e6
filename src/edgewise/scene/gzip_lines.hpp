// SPDX-License-Identifier: MIT
//
// Text files, plain or gzip: zlib reads both.
#pragma once

#include <fmt/format.h>
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "edgewise/scene/case_file.hpp"
#include "edgewise/scene/json_fields.hpp"

namespace edgewise::scene {

/// CRC-32 of the bytes, after those with the checksum `before`.
[[nodiscard]] inline std::uint32_t checksum_of(std::span<const std::byte> bytes, std::uint32_t before = 0) {
    return static_cast<std::uint32_t>(
        crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// Throws JsonFault where the file cannot be read on.
class GzipLines {
  public:
    explicit GzipLines(const std::string& path) : file_(gzopen(path.c_str(), "rb")) {
        if (!file_) throw JsonFault{"cannot be opened for reading"};
    }

    /// False at the end.
    bool next(std::string& line) {
        line.clear();
        while (gzgets(file_.get(), buffer_.data(), static_cast<int>(buffer_.size()))) {
            line += buffer_.data();
            if (gztell(file_.get()) != static_cast<z_off_t>(bytes_before_ + line.size()))
                throw JsonFault{"a zero byte: the file was cut off or damaged here"};
            if (line.size() > most_line_bytes)
                throw JsonFault{fmt::format("longer than {} bytes: no recording", most_line_bytes)};
            if (line.ends_with('\n')) break;
        }
        int error = Z_OK;
        static_cast<void>(gzerror(file_.get(), &error));
        if (error != Z_OK)
            throw JsonFault{"the gzip data is cut off or damaged here: record again, or unpack what is left"};
        checksum_ = checksum_of(std::as_bytes(std::span(line)), checksum_);
        bytes_before_ += line.size();
        return !line.empty();
    }
    [[nodiscard]] std::uint32_t checksum() const { return checksum_; }

  private:
    struct Close {
        void operator()(gzFile_s* file) const { gzclose(file); }
    };
    std::unique_ptr<gzFile_s, Close> file_;
    std::vector<char> buffer_ = std::vector<char>(1 << 16);
    std::uint32_t checksum_ = 0;
    std::size_t bytes_before_ = 0;  ///< of the lines before
};

}  // namespace edgewise::scene
