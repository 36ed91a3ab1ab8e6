// SPDX-License-Identifier: MIT
//
// Which bytes of a stretch of memory were ever touched: a bit per byte.
#pragma once

#include <cstdint>
#include <vector>

namespace edgewise::measure {

class TouchedBytes {
  public:
    void touch(std::uint64_t from, std::uint64_t bytes);

    /// Of the bytes from .. from + bytes - 1, how many were touched.
    [[nodiscard]] std::uint64_t count(std::uint64_t from, std::uint64_t bytes) const;
    [[nodiscard]] std::uint64_t count() const { return count(0, 64 * words_.size()); }

  private:
    std::vector<std::uint64_t> words_;
};

}  // namespace edgewise::measure
