// SPDX-License-Identifier: MIT
//
// The name of every figure that a store can hold. A literal is looked up when the program is compiled: probes
// make figures and reports look them up by the same names, and one that is renamed does not compile. The rows
// of the vocabulary are those of the table in docs/figures.md (cmake/tool.cmake); `edgewise list figures`
// prints them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/cache/by_start.hpp"
#include "edgewise/measure/expected.hpp"

namespace edgewise::store {

/// The queries that a figure counts. A query starts cold if it is its pair's first, or if the scene keeps no
/// answers; it starts warm from its pair's kept answer.
enum class Population {
    none,
    all,
    cold,
    warm,
    named,   ///< cold or warm, as the figure's name ends
    steady,  ///< warm where pairs are followed; else all, which are cold
    checked
};

[[nodiscard]] constexpr std::string_view to_string(Population population) {
    constexpr std::string_view names[] = {"none", "all", "cold", "warm", "named", "steady", "checked"};
    return names[static_cast<int>(population)];
}

enum class Repeats {
    exactly,  ///< the same bits in every run on every machine
    timed     ///< measured: another run gives another number
};

struct FigureInfo {
    std::string_view key;  ///< probe, a dot and the name: "time.all_ns", "heap.{structure}.slack_bytes"
    std::string_view unit;
    Population population;
    Repeats repeats;
    std::string_view meaning;

    [[nodiscard]] constexpr std::string_view probe() const { return key.substr(0, key.find('.')); }
    [[nodiscard]] constexpr std::string_view name() const { return key.substr(key.find('.') + 1); }
};

inline constexpr FigureInfo vocabulary[] = {
#include "edgewise/store/figure_rows.inc"
};

/// A figure of the vocabulary, with texts that fill the braces of its name. These texts must outlive it.
class FigureName {
  public:
    /// The key of a figure, as in the vocabulary.
    consteval FigureName(const char* key) : info_(find(key)) {}

    /// The name with these values for its braces, in order.
    template <class... Texts>
    [[nodiscard]] constexpr FigureName of(const Texts&... texts) const {
        static_assert(sizeof...(texts) <= 4);
        FigureName filled = *this;
        filled.values_ = {std::string_view(texts)...};
        return filled;
    }

    /// The name with a value for the first braces that have none yet.
    [[nodiscard]] constexpr FigureName and_of(std::string_view text) const {
        FigureName filled = *this;
        for (std::string_view& value : filled.values_) {
            if (!value.empty()) continue;
            value = text;
            break;
        }
        return filled;
    }

    [[nodiscard]] const FigureInfo& info() const { return *info_; }
    [[nodiscard]] std::string probe() const { return std::string(info_->probe()); }
    /// The name as a store has it; braces without a value stay.
    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::string unit() const { return std::string(info_->unit); }
    /// The text that a stored figure has instead of the only braces without a value; null for a figure of
    /// another family, and for one of the same family with a name that says how its queries start.
    [[nodiscard]] std::optional<std::string> value_in(std::string_view probe, std::string_view name) const;

  private:
    static consteval const FigureInfo* find(std::string_view key) {
        for (const FigureInfo& info : vocabulary)
            if (info.key == key) return &info;
        throw "no figure of this name is in the vocabulary";
    }

    const FigureInfo* info_;
    std::array<std::string_view, 4> values_ = {};
};

/// A measured figure; without a value it has the reason and the remedy.
[[nodiscard]] measure::Figure figure(const FigureName& name, std::optional<double> value,
                                     std::string reason = {}, std::string remedy = {});
[[nodiscard]] inline measure::Figure no_figure(const FigureName& name, std::string reason,
                                               std::string remedy) {
    return figure(name, std::nullopt, std::move(reason), std::move(remedy));
}

/// A mean: the sum divided by the count, which is at least 1.
[[nodiscard]] inline measure::Figure mean_figure(const FigureName& name, std::uint64_t sum,
                                                 std::uint64_t count) {
    return figure(name, static_cast<double>(sum) / static_cast<double>(count));
}

/// Names of a figure of all queries, and of the queries that start cold or warm, which the last braces say.
struct StartNames {
    FigureName all, apart;

    template <class... Texts>
    [[nodiscard]] constexpr StartNames of(const Texts&... texts) const {
        return {all.of(texts...), apart.of(texts...)};
    }
    [[nodiscard]] constexpr FigureName cold() const { return apart.and_of(cold_start); }
    [[nodiscard]] constexpr FigureName warm() const { return apart.and_of(warm_start); }

    static constexpr std::string_view cold_start = "cold", warm_start = "warm";
};

/// Adds the means per query; null, with the reason, for a start that no query has.
void add_means(const StartNames& names, const measure::ByStart<std::uint64_t>& sums,
               const measure::ByStart<std::uint64_t>& queries, std::vector<measure::Figure>& to);
/// Adds the values; null, with the reason, for a start that no query has.
void add_values(const StartNames& names, const measure::ByStart<std::optional<double>>& values,
                std::vector<measure::Figure>& to);

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

/// Figures of all pairs, by how their queries start.
inline constexpr StartNames query_time = {"time.query_ns", "time.query_ns.{start}"},
                            mean_steps = {"error.mean_steps", "error.mean_steps.{start}"},
                            lines_read = {"lines.lines_per_query", "lines.lines_per_query.{start}"};

/// Figures of modelled caches, by how queries start.
inline constexpr StartNames level_misses = {"caches.{machine}.{level}.misses_per_query",
                                            "caches.{machine}.{level}.misses_per_query.{start}"},
                            memory_time = {"caches.{machine}.modelled_memory_ns",
                                           "caches.{machine}.modelled_memory_ns.{start}"};

/// Reuse distances of lines and of pages.
struct ReuseNames {
    const char* units;
    StartNames per_query, knee, misses;
    FigureName of_scene, of_body, of_frame;
};
inline constexpr ReuseNames reuse_names[] = {
    {"lines",
     {"reuse.lines_per_query", "reuse.lines_per_query.{start}"},
     {"reuse.line_knee_bytes", "reuse.line_knee_bytes.{start}"},
     {"reuse.line_misses_at_2^{power}", "reuse.line_misses_at_2^{power}.{start}"},
     "reuse.lines_of_scene",
     "reuse.lines_of_body",
     "reuse.lines_of_frame"},
    {"pages",
     {"reuse.pages_per_query", "reuse.pages_per_query.{start}"},
     {"reuse.page_knee_bytes", "reuse.page_knee_bytes.{start}"},
     {"reuse.page_misses_at_2^{power}", "reuse.page_misses_at_2^{power}.{start}"},
     "reuse.pages_of_scene",
     "reuse.pages_of_body",
     "reuse.pages_of_frame"}};
inline constexpr const StartNames &line_knee = reuse_names[0].knee, &page_knee = reuse_names[1].knee;

/// The entry of the vocabulary that a stored figure belongs to; null when the vocabulary has none.
[[nodiscard]] const FigureInfo* find_figure(std::string_view probe, std::string_view name);

}  // namespace edgewise::store
