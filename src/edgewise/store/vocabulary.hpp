// SPDX-License-Identifier: MIT
//
// The name of every figure that a store can hold. A literal is looked up when the program is compiled: probes
// make figures and reports look them up by the same names, and one that is renamed does not compile. Users
// read it as `edgewise list figures` and docs/figures.md.
#pragma once

#include <array>
#include <cassert>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "edgewise/measure/figure.hpp"
#include "edgewise/store/vocabulary/answers.hpp"
#include "edgewise/store/vocabulary/effort.hpp"
#include "edgewise/store/vocabulary/memory.hpp"
#include "edgewise/store/vocabulary/time.hpp"

namespace edgewise::store {

inline constexpr std::span<const FigureInfo> vocabulary_parts[] = {vocabulary::memory, vocabulary::time,
                                                                   vocabulary::answers, vocabulary::effort};

/// A figure, or a family of figures with what stands between braces filled in. The texts that fill it must
/// outlive it.
class FigureName {
  public:
    /// The key of a figure, as in the vocabulary.
    consteval FigureName(const char* key) : info_(find(key)) {}

    /// The values for its braces, in order.
    template <class... Texts>
    [[nodiscard]] constexpr FigureName of(const Texts&... texts) const {
        static_assert(sizeof...(texts) <= 3);
        FigureName filled = *this;
        filled.values_ = {std::string_view(texts)...};
        return filled;
    }

    [[nodiscard]] const FigureInfo& info() const { return *info_; }
    [[nodiscard]] std::string probe() const { return std::string(info_->probe()); }
    /// As a store has it; braces without a value stay.
    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::string unit() const { return std::string(info_->unit); }
    /// What a stored figure has in place of the one pair of braces that has no value; null for others.
    [[nodiscard]] std::optional<std::string> value_in(std::string_view probe, std::string_view name) const;

  private:
    static consteval const FigureInfo* find(std::string_view key) {
        for (const auto part : vocabulary_parts)
            for (const FigureInfo& info : part)
                if (info.key == key) return &info;
        throw "no figure of this name is in the vocabulary";
    }

    const FigureInfo* info_;
    std::array<std::string_view, 3> values_ = {};
};

/// A measured figure; null where there is no such number, with the reason then.
[[nodiscard]] measure::Figure figure(const FigureName& name, std::optional<double> value,
                                     std::string reason = {}, std::string remedy = {});
[[nodiscard]] inline measure::Figure no_figure(const FigureName& name, std::string reason,
                                               std::string remedy) {
    return figure(name, std::nullopt, std::move(reason), std::move(remedy));
}

/// A mean: a sum divided by how many there were, of which there is one at least.
[[nodiscard]] inline measure::Figure mean_figure(const FigureName& name, std::uint64_t sum,
                                                 std::uint64_t count) {
    return figure(name, static_cast<double>(sum) / static_cast<double>(count));
}

/// The time of queries of one kind.
struct QueryTime {
    FigureName ns, low, high, ratio;
};
inline constexpr QueryTime separated_time = {"time.separated_ns", "time.separated_ns_low",
                                             "time.separated_ns_high", "time.separated_ratio"};
inline constexpr QueryTime overlapping_time = {"time.overlapping_ns", "time.overlapping_ns_low",
                                               "time.overlapping_ns_high", "time.overlapping_ratio"};
inline constexpr QueryTime all_time = {"time.all_ns", "time.all_ns_low", "time.all_ns_high",
                                       "time.all_ratio"};

/// Of modelled caches.
inline constexpr FigureName level_misses("caches.{machine}.{level}.misses_per_query"),
    memory_time("caches.{machine}.modelled_memory_ns");

/// Reuse distances of lines and of pages.
struct ReuseNames {
    const char* units;
    FigureName per_query, of_scene, of_body, of_frame, knee, misses;
};
inline constexpr ReuseNames reuse_names[] = {
    {"lines", "reuse.lines_per_query", "reuse.lines_of_scene", "reuse.lines_of_body", "reuse.lines_of_frame",
     "reuse.line_knee_bytes", "reuse.line_misses_at_2^{power}"},
    {"pages", "reuse.pages_per_query", "reuse.pages_of_scene", "reuse.pages_of_body", "reuse.pages_of_frame",
     "reuse.page_knee_bytes", "reuse.page_misses_at_2^{power}"}};

}  // namespace edgewise::store
