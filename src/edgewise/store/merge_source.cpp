// SPDX-License-Identifier: MIT
#include "edgewise/store/merge_source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <string_view>

#include "edgewise/input/count.hpp"
#include "edgewise/store/read_rows.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::store {

namespace {

/// Throws unless all have one value; the line names a file for each of the first two.
void check_one(const std::map<std::string, std::string>& file_of_value, const char* what) {
    if (file_of_value.size() < 2) return;
    const auto first = file_of_value.begin(), second = std::next(first);
    throw std::runtime_error(fmt::format(
        "these stores are of several {}: '{}' in {}, '{}' in {}; merge those of one, or say --mixed", what,
        first->first, first->second, second->first, second->second));
}

}  // namespace

std::optional<PartOf> part_from(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) return std::nullopt;
    const auto index = input::parse_count(std::string_view(text).substr(0, slash), {}),
               count = input::parse_count(std::string_view(text).substr(slash + 1), {});
    if (!index || !count || *index >= *count) return std::nullopt;
    return PartOf{*index, *count};
}

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

std::optional<PartOf> MergeSource::part() const { return part_from(value(shard_key)); }

bool MergeSource::is_complete() const { return !part() || value(complete_key) == value(shard_key); }

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

std::vector<std::string> missing_parts(const std::vector<MergeSource>& sources) {
    std::map<std::string, std::string> counts;
    std::map<std::size_t, bool> complete;  // by index
    std::vector<std::string> missing;
    std::size_t count = 0;
    for (const MergeSource& source : sources) {
        const auto part = source.part();
        if (!part) continue;
        count = part->count;
        counts.try_emplace(std::to_string(count), source.path);
        complete[part->index] = complete[part->index] || source.is_complete();
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

}  // namespace edgewise::store
