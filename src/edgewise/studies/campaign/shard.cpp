// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/shard.hpp"

#include <fmt/format.h>

#include <charconv>

namespace edgewise::studies::campaign {

Result<Shard> Shard::parse(const std::string& text) {
    Shard shard;
    const char* const end = text.data() + text.size();
    const auto [slash, wrong_index] = std::from_chars(text.data(), end, shard.index);
    const bool has_slash = wrong_index == std::errc() && slash != end && *slash == '/';
    if (has_slash) {
        const auto [rest, wrong_count] = std::from_chars(slash + 1, end, shard.count);
        const bool whole = wrong_count == std::errc() && rest == end;
        if (whole && shard.index >= 1 && shard.index <= shard.count && shard.count <= 1'000'000)
            return Result<Shard>::success(shard);
    }
    return Result<Shard>::failure(
        fmt::format("--shard {}: no shard; give i/n with i from 1 to n, as in 3/8", text));
}

}  // namespace edgewise::studies::campaign
