// SPDX-License-Identifier: MIT
#include "edgewise/store/merge.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "edgewise/input/count.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/store/sqlite.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::store {

namespace {

namespace fs = std::filesystem;

constexpr const char* merged_key = "merged";

/// Part `index` of `count` of a campaign.
struct PartOf {
    std::size_t index, count;
};

/// From "3/8"; nothing for other texts.
std::optional<PartOf> part_of(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) return std::nullopt;
    const auto index = input::parse_count(std::string_view(text).substr(0, slash), {}),
               count = input::parse_count(std::string_view(text).substr(slash + 1), {});
    if (!index || !count || *index >= *count) return std::nullopt;
    return PartOf{*index, *count};
}

/// The file that the merged store is written to: next to `out`, removed unless it took that name.
class FileBeside {
  public:
    explicit FileBeside(const std::string& out) : out_(out) {
        std::array<char, 256> host{};
        gethostname(host.data(), host.size() - 1);
        const std::string start = fmt::format("{}.merging-{}-", out, host.data());
        path_ = fmt::format("{}{}", start, getpid());
        remove(path_);
        remove_orphans(start);
    }
    ~FileBeside() { remove(path_); }
    FileBeside(const FileBeside&) = delete;
    FileBeside& operator=(const FileBeside&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }

    /// The contents are on the disk before the file takes the name, and the name is before this returns.
    void take_place() const {
        const auto folder = fs::path(out_).parent_path();
        sync(path_, O_RDONLY);
        std::error_code ignored;  // files of a store that was killed would be laid over this one
        for (const char* const end : {"-wal", "-shm", "-journal"}) fs::remove(out_ + end, ignored);
        fs::rename(path_, out_);
        sync(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);
    }

  private:
    static void sync(const std::string& path, int flags) {
        const int file = open(path.c_str(), flags | O_CLOEXEC);
        const bool synced = file >= 0 && fsync(file) == 0;
        if (file >= 0) close(file);
        if (!synced) throw std::runtime_error(fmt::format("store {}: cannot be brought to the disk", path));
    }
    static void remove(const std::string& path) {
        std::error_code ignored;
        for (const char* const end : {"", "-wal", "-shm", "-journal"}) fs::remove(path + end, ignored);
    }
    /// Removes what merges on this host left that were killed.
    static void remove_orphans(const std::string& start) {
        const auto folder = fs::path(start).parent_path();
        std::vector<std::string> left;
        std::error_code error;
        for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end;
             at.increment(error)) {
            const std::string path = folder.empty() ? at->path().filename().string() : at->path().string();
            if (path.starts_with(start)) left.push_back(path);
        }
        for (const std::string& path : left) {
            const int process = std::atoi(path.c_str() + start.size());
            if (process > 0 && kill(process, 0) != 0 && errno == ESRCH)
                remove(start + std::to_string(process));
        }
    }

    std::string out_, path_;
};

/// How many rounds there are may differ.
std::vector<FigureRow> exact_figures_of(const sqlite::Database& of, const std::string& build,
                                        const std::string& hash) {
    std::vector<FigureRow> figures = figures_of(of, build, hash);
    std::erase_if(figures, [](const FigureRow& figure) {
        const FigureInfo* const info = find_figure(figure.probe, figure.name);
        return figure.probe == "time" || !info || info->repeats != Repeats::exactly;
    });
    return figures;
}

/// Copies stores into one, row by row and unchanged: rows were checked when they were written.
class Merge {
  public:
    explicit Merge(const std::string& path) : to_(path) {}

    void add(const std::string& path) {
        const auto from = sqlite::Database::for_reading(path);
        from.execute("begin");
        check_schema(from);
        sqlite::Transaction transaction(to_);
        sqlite::Statement builds(from, fmt::format("select {} from build", build_columns));
        sqlite::Statement to(to_, insertion("or ignore", "build", build_columns));
        while (builds.step()) to.bind_row(builds).run();
        sqlite::Statement cells(from, "select build, hash from cell order by build, hash");
        while (cells.step()) add_cell(from, path, cells.text(0), cells.text(1));
        transaction.commit();
    }

    void put_meta(const std::string& key, const std::string& value, const char* or_what) const {
        sqlite::Statement(to_, fmt::format("insert or {} into meta values(?,?)", or_what))
            .bind(key, value)
            .run();
    }

    [[nodiscard]] std::vector<MergedBuild> builds() const {
        std::vector<MergedBuild> builds;
        sqlite::Statement select(
            to_,
            "select id, git_revision, count(*) as cells from build join cell on cell.build = "
            "build.id group by id order by cells desc, id");
        while (select.step())
            builds.push_back({select.text(0), select.text(1), static_cast<std::size_t>(select.integer(2))});
        return builds;
    }
    [[nodiscard]] std::size_t twice() const { return twice_; }

    /// Leaves one file, without a log next to it.
    void finish() const { to_.execute("pragma journal_mode = delete"); }

  private:
    void copy_of_cell(const sqlite::Database& from, const char* table, const char* columns,
                      const std::string& build, const std::string& hash) const {
        sqlite::Statement rows(from,
                               fmt::format("select {} from {} where build = ? and hash = ?", columns, table));
        sqlite::Statement to(to_, insertion("or replace", table, columns));
        rows.bind(build, hash);
        while (rows.step()) to.bind_row(rows).run();
    }

    void add_cell(const sqlite::Database& from, const std::string& path, const std::string& build,
                  const std::string& hash) {
        const auto [first, is_new] = paths_.try_emplace({build, hash}, path);
        if (!is_new) {
            ++twice_;
            check_same(from, path, first->second, build, hash);
            if (rounds_of(from, build, hash).size() <= rounds_of(to_, build, hash).size()) return;
            for (const char* const table : {"figure", "round"})
                sqlite::Statement(to_, fmt::format("delete from {} where build = ? and hash = ?", table))
                    .bind(build, hash)
                    .run();
        }
        copy_of_cell(from, "cell", cell_columns, build, hash);
        copy_of_cell(from, "figure", figure_columns, build, hash);
        copy_of_cell(from, "round", round_columns, build, hash);
    }

    /// Throws where two stores have different figures of one cell of one build, so of one program on one
    /// machine.
    void check_same(const sqlite::Database& from, const std::string& path, const std::string& other_path,
                    const std::string& build, const std::string& hash) const {
        const auto here = find_cell(from, build, hash), there = find_cell(to_, build, hash);
        const auto figures = exact_figures_of(from, build, hash), others = exact_figures_of(to_, build, hash);
        std::string what;
        if (here->status != there->status)
            what = fmt::format("status '{}' and '{}'", to_string(there->status), to_string(here->status));
        for (const FigureRow& figure : figures) {
            const auto same = std::ranges::find_if(others, [&](const FigureRow& other) {
                return other.probe == figure.probe && other.name == figure.name;
            });
            if (same != others.end() && same->value != figure.value)
                what = fmt::format("figure {}.{}", figure.probe, figure.name);
        }
        if (!what.empty())
            throw std::runtime_error(fmt::format(
                "{} and {} disagree on {} {} {} {}: {}; they were swept with other options, or one is "
                "damaged",
                other_path, path, here->scene, here->shape, here->algorithm, here->table, what));
    }

    sqlite::Database to_;
    std::map<std::pair<std::string, std::string>, std::string>
        paths_;  ///< of the store a cell came from first
    std::size_t twice_ = 0;
};

/// Each file once, parts by number, then by path: the order does not depend on how the files were named.
std::vector<MergeSource> sources_of(const std::vector<std::string>& stores) {
    std::vector<MergeSource> sources;
    for (const std::string& path : stores) {
        const bool again = std::ranges::any_of(sources, [&](const MergeSource& source) {
            std::error_code ignored;
            return fs::equivalent(source.path, path, ignored);
        });
        if (!again) sources.emplace_back(path);
    }
    std::ranges::sort(sources, {}, [](const MergeSource& source) {
        const auto part = part_of(source.value(shard_key));
        return std::pair(part ? part->index : 0, source.path);
    });
    return sources;
}

/// Throws if `out` exists and is not a merged store: it is not overwritten.
void check_out(const std::string& out) {
    std::error_code ignored;
    if (!fs::exists(out, ignored)) return;
    if (!fs::is_regular_file(out, ignored) || !MergeSource(out).meta.contains(merged_key))
        throw std::runtime_error(fmt::format("{} is there and is no merged store: name another --out", out));
}

/// The store's own part if it is complete, and those of which it was merged.
std::set<std::string> complete_parts(const MergeSource& source) {
    std::istringstream words(source.value(merged_key));
    std::set<std::string> parts{std::istream_iterator<std::string>(words), {}};
    if (source.value(complete_key) == source.value(shard_key)) parts.insert(source.value(shard_key));
    std::erase_if(parts, [](const std::string& text) { return !part_of(text); });
    return parts;
}

void merge_meta(const std::vector<MergeSource>& sources, const Merge& merge) {
    for (const MergeSource& source : sources) {
        for (const auto& [key, value] : source.meta) {
            if (key != shard_key && key != complete_key && key != merged_key)
                merge.put_meta(key, value, "ignore");
        }
    }
    const std::vector<MergedBuild> builds = merge.builds();
    if (!builds.empty()) merge.put_meta("build", builds.front().id, "replace");
    std::set<std::string> complete;
    for (const MergeSource& source : sources) complete.merge(complete_parts(source));
    merge.put_meta(merged_key, fmt::format("of {}", fmt::join(complete, " ")), "replace");
}

/// Throws if there are several values; the line names the first two and a file of each.
void check_one(const std::map<std::string, std::string>& file_of_value, const char* what) {
    if (file_of_value.size() < 2) return;
    const auto first = file_of_value.begin(), second = std::next(first);
    throw std::runtime_error(fmt::format(
        "these stores are of several {}: '{}' in {}, '{}' in {}; merge those of one, or say --mixed", what,
        first->first, first->second, second->first, second->second));
}

/// Throws where the stores are of several plans, seeds or revisions.
void check_same_campaign(const std::vector<MergeSource>& sources) {
    std::map<std::string, std::string> plans, seeds, revisions;
    for (const MergeSource& source : sources) {
        if (source.meta.contains("plan")) plans.try_emplace(source.value("plan"), source.path);
        if (source.meta.contains("seed")) seeds.try_emplace(source.value("seed"), source.path);
        for (const std::string& revision : source.revisions) revisions.try_emplace(revision, source.path);
    }
    check_one(plans, "plans");
    check_one(seeds, "seeds");
    check_one(revisions, "revisions");
}

/// Throws where two stores have scene files of one name that differ; the line names both.
void check_scene_files(const std::vector<MergeSource>& sources) {
    std::map<std::string, const MergeSource*> first;  // by key
    for (const MergeSource& source : sources) {
        for (const auto& [key, text] : source.meta) {
            if (!key.starts_with(scene_file_key)) continue;
            const MergeSource& other = *first.try_emplace(key, &source).first->second;
            if (other.value(key) == text) continue;
            throw std::runtime_error(
                fmt::format("{} and {} hold different scene files of one name, '{}': rename one of the files "
                            "and sweep it again",
                            other.path, source.path, key.substr(std::string_view(scene_file_key).size())));
        }
    }
}

/// A line for each part of the campaign that no store holds or that was stopped before its end. Throws where
/// the stores are parts of differently many.
std::vector<std::string> missing_parts(const std::vector<MergeSource>& sources) {
    std::map<std::string, std::string> counts;
    std::map<std::size_t, bool> complete;  // by index
    std::vector<std::string> missing;
    std::size_t count = 0;
    for (const MergeSource& source : sources) {
        const auto take = [&](const std::string& text, bool is_complete) {
            const auto part = part_of(text);
            if (!part) return;
            count = part->count;
            counts.try_emplace(std::to_string(count), source.path);
            complete[part->index] |= is_complete;
        };
        take(source.value(shard_key), false);
        for (const std::string& part : complete_parts(source)) take(part, true);
    }
    check_one(counts, "numbers of shards");
    for (std::size_t index = 0; index < count; ++index) {
        const auto found = complete.find(index);
        if (found == complete.end())
            missing.push_back(fmt::format("shard {}/{} is missing: no store is of it", index, count));
        else if (!found->second)
            missing.push_back(fmt::format(
                "shard {}/{} was stopped before its end: run it again, it goes on there", index, count));
    }
    return missing;
}

}  // namespace

MergeSource::MergeSource(const std::string& file) : path(file) {
    const auto database = sqlite::Database::for_reading(file);
    database.execute("begin");
    check_schema(database);
    for (auto& [key, text] : meta_of(database)) meta[key] = text;
    sqlite::Statement select(
        database,
        "select distinct git_revision, compiler, flags, build_type from build where exists "
        "(select 1 from cell where cell.build = build.id)");
    while (select.step())
        revisions.insert(
            fmt::format("{} {} {} {}", select.text(0), select.text(3), select.text(1), select.text(2)));
}

std::string MergeSource::value(const std::string& key) const {
    const auto found = meta.find(key);
    return found == meta.end() ? "" : found->second;
}

MergeSummary merge_stores(const std::vector<std::string>& stores, const std::string& out, bool mixed) {
    check_out(out);
    const std::vector<MergeSource> sources = sources_of(stores);
    if (!mixed) check_same_campaign(sources);
    check_scene_files(sources);
    MergeSummary summary;
    summary.missing = missing_parts(sources);
    const FileBeside beside(input::output_place(out).file);
    { const Store created(beside.path()); }
    {
        Merge merge(beside.path());
        for (const MergeSource& source : sources) merge.add(source.path);
        merge_meta(sources, merge);
        merge.finish();
        summary.builds = merge.builds();
        summary.twice = merge.twice();
    }
    for (const MergedBuild& build : summary.builds) summary.cells += build.cells;
    summary.stores = sources.size();
    beside.take_place();
    return summary;
}

}  // namespace edgewise::store
