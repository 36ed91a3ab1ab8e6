// SPDX-License-Identifier: MIT
#include "edgewise/bench/registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/peers/peer_modules.hpp"
#include "edgewise/input/known_names.hpp"

namespace edgewise::bench {

namespace {

/// Selects every item that a name matches, in registry order; throws when a name matches none. The first of
/// an item's names is the one that is listed.
template <class Item, class NamesOf>
std::vector<const Item*> select(std::span<const Item> items, std::span<const std::string> names,
                                std::string_view what, NamesOf names_of) {
    const auto stands_for = [&](const std::string& name, const Item& item) {
        const std::vector<std::string> own = names_of(item);
        return name == "all" || std::find(own.begin(), own.end(), name) != own.end();
    };
    std::vector<const Item*> selected;
    std::vector<std::string> known, unknown(names.begin(), names.end());
    std::erase(unknown, "all");
    for (const Item& item : items) {
        if (known.empty() || known.back() != names_of(item).front()) known.push_back(names_of(item).front());
        const auto asked = [&](const std::string& name) { return stands_for(name, item); };
        if (std::any_of(names.begin(), names.end(), asked)) selected.push_back(&item);
        std::erase_if(unknown, asked);
    }
    if (unknown.empty()) return selected;
    known.insert(known.begin(), "all");
    throw std::invalid_argument(unknown_name(what, unknown.front(), known));
}

}  // namespace

std::span<const AlgorithmInfo> algorithms() {
    static const std::vector<AlgorithmInfo> known = {
        {"vclip", "V-Clip (Mirtich 1997): walks between neighbouring features", Parts::features},
        {"gjk", "Enhanced GJK (Gilbert, Johnson, Keerthi 1988; Cameron 1997): simplices of support points",
         Parts::support},
    };
    return known;
}

const AlgorithmInfo& algorithm_called(std::string_view name) {
    // Peers are looked for, and their modules opened, only for a name that is none of ours.
    for (const auto known : {algorithms, peer_algorithms}) {
        for (const AlgorithmInfo& info : known()) {
            if (info.name == name) return info;
        }
    }
    throw std::invalid_argument(fmt::format("there is no algorithm '{}'", name));
}

std::vector<const TableType*> select_types(std::span<const TableType> from,
                                           std::span<const std::string> names, std::string_view what) {
    return select<TableType>(from, names, what, [](const TableType& type) {
        return std::vector{type.layout, type.name};
    });
}

std::vector<const TableType*> select_table_types(std::span<const std::string> names) {
    for (const std::string& name : names) {
        if (std::ranges::count(manifest_layouts(), name) > 0 && !is_built(name))
            throw std::invalid_argument(
                fmt::format("'{}' is not in this program: EDGEWISE_LAYOUTS= EDGEWISE_EVERY_LAYOUT=ON sh "
                            "cmake/build_preset.sh release edgewise_program compiles all layouts",
                            name));
    }
    return select_types(table_types(), names, "layout (or table type, as in aos_f64)");
}

const TableType* find_table_type(std::string_view name) {
    const auto found = std::ranges::find(table_types(), name, &TableType::name);
    return found != table_types().end() ? &*found : nullptr;
}

bool is_built(std::string_view name) {
    return std::ranges::any_of(
        table_types(), [&](const TableType& type) { return type.layout == name || type.name == name; });
}

const TableType& table_type_called(const std::string& name) {
    const TableType* found = find_table_type(name);
    return found ? *found : *select_table_types(std::span(&name, 1)).front();
}

std::vector<std::string> select_algorithms(std::span<const std::string> names) {
    std::vector<std::string> result;
    const auto name_of = [](const AlgorithmInfo& info) { return std::vector{info.name}; };
    for (const AlgorithmInfo* algorithm : select<AlgorithmInfo>(algorithms(), names, "algorithm", name_of))
        result.push_back(algorithm->name);
    return result;
}

}  // namespace edgewise::bench
