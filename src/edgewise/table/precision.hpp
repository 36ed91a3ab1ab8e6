// SPDX-License-Identifier: MIT
//
// A precision is a pair of scalars: one stores, one computes. The layout passes it to the algorithms as a
// template parameter, so that one program measures every precision.
#pragma once

#include <concepts>
#include <string_view>

namespace edgewise {

struct f64 {
    using Stored = double;
    using Compute = double;
    static constexpr std::string_view name = "f64";
};

struct f32 {
    using Stored = float;
    using Compute = float;
    static constexpr std::string_view name = "f32";
};

struct mixed {
    using Stored = float;
    using Compute = double;
    static constexpr std::string_view name = "mixed";
};

template <class P>
concept Precision = requires {
    typename P::Stored;
    typename P::Compute;
    { P::name } -> std::convertible_to<std::string_view>;
};

}  // namespace edgewise
