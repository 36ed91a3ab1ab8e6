// SPDX-License-Identifier: MIT
//
// One function per sentence; then the tables: what layouts and sharing do to the thrash, at every number of
// vertices and angle per step, and the paging run, one row per limit.
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"

#include <fmt/core.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

std::string bytes_text(double bytes) {
    return bytes < mebibyte ? number_text(bytes / kibibyte) + " KiB" : number_text(bytes / mebibyte) + " MiB";
}

std::string missing_text(const std::string& why) { return "missing (" + why + ")"; }

std::string bytes_text(const measure::Expected<double>& bytes) {
    return bytes.value ? bytes_text(*bytes.value) : missing_text(bytes.reason);
}

std::string count_text(const measure::Expected<double>& bodies) {
    if (!bodies.value) return missing_text(bodies.reason);
    return std::isfinite(*bodies.value) ? fmt::format("{:.0f}", std::ceil(*bodies.value)) : "no number";
}

std::string answer(const ReportData& data) {
    const auto cache = cache_is_a_cause(data), paging = paging_is_a_cause(data);
    std::string out;
    if (cache && paging) {
        if (*cache && *paging)
            return "Both: at 386 vertices V-Clip thrashes the caches of 2001 and pages its memory.";
        if (*cache) return "It is the cache, not paging, that makes figure 8.";
        if (*paging) return "It is paging, not the cache, that makes figure 8.";
        return "Neither the caches nor the memories of 2001 make figure 8 with these tables.";
    }
    if (!cache)
        out = "Whether the cache makes figure 8 is not known: " +
              memory_factor(data, old_machines[0], false).reason + ". ";
    else
        out = *cache ? "The cache makes figure 8. " : "The cache does not make figure 8. ";
    if (!paging)
        return out + "Whether paging makes it is not known: " +
               bodies_to_fill(data, 386, store::page_knee.warm(), least_old_memory).reason + ".";
    return out + (*paging ? "Paging makes it." : "Paging does not make it.");
}

std::string factor_at(const ReportData& data, const char* machine, bool fastest) {
    const measure::Expected<double> factor = memory_factor(data, machine, fastest),
                                    step = thrash_number(data, 386, fastest, "rotation_step"),
                                    time = thrash_figure(data, 386, fastest,
                                                         store::memory_time.of(machine).warm());
    const std::string speed =
        step.value ? number_text(*step.value) + " rad per step" : (fastest ? "the fastest" : "the slowest");
    if (!factor.value) return fmt::format("at {} {}", speed, missing_text(factor.reason));
    const std::string times =
        std::isfinite(*factor.value) ? "by a factor of " + number_text(*factor.value) : "from none";
    const auto misses = store::level_misses.of(machine, "L2").warm();
    const auto count = [&](int vertices) {
        const measure::Expected<double> found = thrash_figure(data, vertices, fastest, misses);
        return found.value ? number_text(*found.value) : missing_text(found.reason);
    };
    return fmt::format("at {} {} to {} us (misses of the second level: {} to {})", speed, times,
                       number_text(*time.value / 1000), count(38), count(386));
}

/// Memory time against the paper's factor, and against the time it means.
std::string cache_sentence(const ReportData& data) {
    std::vector<std::string> machines;
    for (const char* machine : old_machines)
        machines.push_back(fmt::format("{} {} and {}", machine, factor_at(data, machine, false),
                                       factor_at(data, machine, true)));
    return prose("thrash_cache.md", fmt::arg("machines", fmt::join(machines, "; ")),
                 fmt::arg("factor", papers_factor), fmt::arg("us", number_text(papers_growth_ns / 1000)));
}

/// Says from which size, and at 386 vertices from which speed, a knee exceeds `bytes`, the size in 2001.
std::string where_it_passes(const ReportData& data, const store::FigureName& knee, double bytes) {
    std::optional<int> size;
    std::optional<double> speed;
    bool any = false;
    for (const int vertices : thrash_vertices) {
        const measure::Expected<double> worst = worst_figure(data, vertices, knee);
        any = any || worst.value;
        if (!size && worst.value && *worst.value > bytes) size = vertices;
    }
    for (const auto& [step, cell] : thrash_cells(data, 386, "vclip", "aos_f64")) {
        const measure::Figure figure = cell->figure(knee);
        if (!speed && figure.value && *figure.value > bytes) speed = step;
    }
    if (!any) return "nowhere that is known";
    if (!size) return "at no measured size or speed";
    return fmt::format("from {} vertices on, with 386 {}", *size,
                       speed ? fmt::format("from {} rad per step on", number_text(*speed)) : "at no speed");
}

std::string knees_text(const ReportData& data, const store::FigureName& knee) {
    std::vector<std::string> texts;
    for (const int vertices : thrash_vertices)
        texts.push_back(
            fmt::format("{} with {} vertices", bytes_text(worst_figure(data, vertices, knee)), vertices));
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string line_sentence(const ReportData& data) {
    constexpr store::FigureName knee = store::line_knee.warm();
    return prose("thrash_lines.md", fmt::arg("bodies", count_text(thrash_number(data, 386, false, "bodies"))),
                 fmt::arg("knees", knees_text(data, knee)), fmt::arg("cache", bytes_text(old_cache)),
                 fmt::arg("where", where_it_passes(data, knee, old_cache)),
                 fmt::arg("large", count_text(bodies_to_fill(data, 386, knee, old_cache))),
                 fmt::arg("small", count_text(bodies_to_fill(data, 38, knee, old_cache))));
}

/// Says how much memory all bodies' tables take, used or not.
std::string tables_text(const ReportData& data) {
    const measure::Expected<double> table = thrash_figure(data, 386, false, "bytes.table_bytes"),
                                    bodies = thrash_number(data, 386, false, "bodies");
    if (!table.value || !bodies.value)
        return "What their tables take is " + missing_text(table.value ? bodies.reason : table.reason);
    return fmt::format("The tables of {} bodies of 386 vertices take {}", count_text(bodies),
                       bytes_text(*table.value * *bodies.value));
}

std::string page_sentence(const ReportData& data) {
    constexpr store::FigureName knee = store::page_knee.warm();
    return prose("thrash_pages.md", fmt::arg("tables", tables_text(data)),
                 fmt::arg("knees", knees_text(data, knee)), fmt::arg("least", bytes_text(least_old_memory)),
                 fmt::arg("where", where_it_passes(data, knee, least_old_memory)),
                 fmt::arg("large", count_text(bodies_to_fill(data, 386, knee, least_old_memory))),
                 fmt::arg("small", count_text(bodies_to_fill(data, 38, knee, least_old_memory))),
                 fmt::arg("most", bytes_text(most_old_memory)),
                 fmt::arg("most_large", count_text(bodies_to_fill(data, 386, knee, most_old_memory))));
}

/// Says the result of one row of the paging run at the largest memory that faulted.
std::string measured_text(const ReportCell& row) {
    std::optional<double> memory, faults;
    std::string why = row.verified() ? "no limit was measured" : row.reason;
    bool any = false;
    for (const PagingLimit& limit : paging_limits(row)) {
        if (!limit.faults.value || !limit.held.value) {
            why = limit.faults.value ? limit.held.reason : limit.faults.reason;
            continue;
        }
        any = true;
        if (*limit.faults.value > 0 && *limit.held.value > memory.value_or(0))
            memory = limit.held.value, faults = limit.faults.value;
    }
    const auto bodies = parameter_of(row, "bodies");
    const std::string who = fmt::format("{} {} on {}{}", row.shape, row.algorithm, row.table,
                                        bodies ? fmt::format(", {:.0f} bodies", *bodies) : "");
    if (!any) return fmt::format("{}: {}", who, missing_text(why));
    if (!memory) return fmt::format("{}: no faults under any limit", who);
    return fmt::format("{}: {} faults per query with {} for its tables", who, number_text(*faults),
                       bytes_text(*memory));
}

std::string measured_sentence(const ReportData& data) {
    std::vector<std::string> rows;
    for (const ReportCell& row : data.paging) rows.push_back(measured_text(row));
    if (rows.empty()) return "Measured page faults are missing: the store holds no paging run.";
    return fmt::format("Measured under memory limits, the largest that faulted: {}.", fmt::join(rows, "; "));
}

std::string layout_text(const ReportCell& cell, const ReportCell& base) {
    const auto time = store::memory_time.of(old_machines[0]).warm();
    const auto share = [&](const store::FigureName& name) {
        const measure::Figure figure = cell.figure(name), of_base = base.figure(name);
        if (!figure.value) return missing_text(figure.reason);
        return !of_base.value || *of_base.value <= 0 ? "no ratio"
                                                     : number_text(*figure.value / *of_base.value);
    };
    return fmt::format("{}{} {}, {}, {}", cell.algorithm == "vclip" ? "" : cell.algorithm + " ", cell.table,
                       share(store::line_knee.warm()), share(store::page_knee.warm()), share(time));
}

/// Every other table type of V-Clip, and GJK on the same tables.
std::string other_layouts_sentence(const ReportData& data) {
    const auto base = thrash_cells(data, 386, "vclip", "aos_f64");
    if (base.empty()) return "The effect of layouts is missing: no verified cell of V-Clip on aos_f64.";
    std::vector<std::string> texts;
    for (const ReportCell* cell : thrash_scene(data, 386).cells) {
        const auto step = parameter_of(*cell, "rotation_step");
        const bool told = cell->algorithm == "vclip" || cell->table == "aos_f64";
        if (!cell->verified() || !told || cell == base.front().second) continue;
        if (step && *step == base.front().first) texts.push_back(layout_text(*cell, *base.front().second));
    }
    if (texts.empty())
        return "The effect of other layouts is missing: the store has no other table type there.";
    return fmt::format(
        "Relative to V-Clip on aos_f64, at the slowest rotation, in cache, in memory and in memory time on a {}: "
        "{}.",
        old_machines[0], fmt::join(texts, "; "));
}

std::string papers_sentence(const ReportData& data) {
    const auto cache = cache_is_a_cause(data), paging = paging_is_a_cause(data);
    const auto holds = [](const std::optional<bool>& cause) {
        return !cause ? "cannot be judged from this store" : *cause ? "holds" : "does not account for it";
    };
    const measure::Expected<double> knee = worst_figure(data, 386, store::line_knee.warm());
    std::string out = fmt::format(
        "Of the paper's two sentences, \"consuming all available memory ... thrashing\" (section 4, "
        "swapping) "
        "{}, and \"constantly trashing the fast access on-board cache\" (section 5) {}",
        holds(paging), holds(cache));
    if (cache && !*cache && knee.value && *knee.value > old_cache)
        out += ", though it is true that the tables do not fit the cache";
    return out + ".";
}

constexpr double thrash_here_half_turn = 3.1415927;  ///< rad per step: no turn is less coherent

/// ns per query at half a turn per step; the table type with its axes.
std::optional<double> time_of(const ReportData& data, int vertices, const std::string& algorithm,
                              const std::string& table) {
    const StoredScene scene = scene_file(data, "paper_angular_" + std::to_string(vertices));
    const ReportCell* cell = nearest_cell(scene, algorithm, table, thrash_here_half_turn);
    return cell ? cell->figure("time.all_ns").value : std::nullopt;
}

/// "from 1.06 to 16.4 us, a factor of 15.5"; empty where a time is missing.
std::string thrash_here_growth(const ReportData& data, const std::string& algorithm,
                               const std::string& table) {
    const auto small = time_of(data, 38, algorithm, table), large = time_of(data, 386, algorithm, table);
    if (!small || !large) return {};
    return fmt::format("from {} to {} us, by a factor of {}", number_text(*small / 1000),
                       number_text(*large / 1000), number_text(*large / *small));
}

/// The ratio of V-Clip's times at 386 and 38 vertices on the measuring machine, with a table for every body
/// and with one for all, and the same ratio for GJK.
std::string thrash_here(const ReportData& data) {
    const std::string own = thrash_here_growth(data, "vclip", "aos_f64");
    if (own.empty()) return "On this machine it was not timed: paper_angular_38 and _386 are not stored.";
    std::string out = fmt::format(
        "On this machine, where all tables fit in memory and only its caches can thrash, V-Clip on aos_f64 "
        "rises {} at half a turn per step when every body has a table of its own",
        own);
    const std::string shared = thrash_here_growth(data, "vclip", "aos_f64 sharing=shared"),
                      gjk = thrash_here_growth(data, "gjk", "aos_f64");
    if (!shared.empty()) out += fmt::format("; {} when all share one", shared);
    if (!gjk.empty()) out += fmt::format("; GJK, with tables of their own, {}", gjk);
    return out + ".";
}

}  // namespace

std::string thrash_paragraph(const ReportData& data) {
    std::vector<std::string> sentences = {settled_paragraph(data)};
    if (sentences.front().empty()) sentences = {answer(data), papers_sentence(data)};
    for (const auto& sentence : {cache_sentence, line_sentence, page_sentence, measured_sentence, thrash_here,
                                 other_layouts_sentence})
        sentences.push_back(sentence(data));
    return fmt::format("{}", fmt::join(sentences, " "));
}

namespace {

std::vector<FigureColumn> thrash_columns() {
    std::vector<FigureColumn> columns = {{"line knee, KiB", store::line_knee.warm(), kibibyte},
                                         {"page knee, MiB", store::page_knee.warm(), mebibyte},
                                         {"lines per query", store::reuse_names[0].per_query.warm()},
                                         {"pages per query", store::reuse_names[1].per_query.warm()}};
    for (const OldLevel& level : old_levels)
        columns.push_back({std::string(level.label) + ": misses",
                           store::level_misses.of(level.machine, level.level).warm()});
    for (const char* machine : old_machines)
        columns.push_back(
            {std::string(machine) + " memory, us", store::memory_time.of(machine).warm(), 1000});
    return columns;
}

}  // namespace

TextGrid thrash_grid(const ReportData& data) {
    const std::vector<FigureColumn> columns = thrash_columns();
    TextGrid grid = figure_grid(
        "The thrash by table: knees, lines and pages per query touches, modelled misses and memory time",
        "#vertices|#rad per step|algorithm|table type", columns);
    for (const int vertices : thrash_vertices) {
        for (const ReportCell* cell : thrash_scene(data, vertices).cells) {
            const auto step = parameter_of(*cell, "rotation_step");
            if (cell->verified() && step)
                add_row(grid, grid_row(vertices, number_text(*step), cell->algorithm, cell->table), *cell,
                        columns);
        }
    }
    return grid;
}

TextGrid paging_grid(const ReportData& data) {
    TextGrid grid{"Page faults per query under memory limits",
                  columns_of("shape|algorithm|table type|#bodies|#tables, MiB|#touched, MiB|#limit, MiB|"
                             "#left to tables, MiB|#predicted|#measured|#us per query")};
    for (const ReportCell& row : data.paging) {
        const auto bodies = parameter_of(row, "bodies");
        for (const PagingLimit& limit : paging_limits(row))
            grid.add(row.shape, row.algorithm, row.table, bodies ? number_text(*bodies) : "–",
                     figure_cell(row.figure("paging.table_bytes"), mebibyte),
                     figure_cell(row.figure("paging.touched_bytes"), mebibyte),
                     figure_cell(limit.limit, mebibyte), figure_cell(limit.held, mebibyte),
                     limit.predicted_at_held, limit.faults, limit.us);
    }
    return grid;
}

}  // namespace edgewise::reports
