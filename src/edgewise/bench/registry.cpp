// SPDX-License-Identifier: MIT
#include "edgewise/bench/registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace edgewise::bench {

namespace {

/// Every item a name stands for, in registry order; throws when some name stands for none.
template <class Item, class Matches, class NameOf>
std::vector<const Item*> select(std::span<const Item> items, std::span<const std::string> names,
                                std::string_view what, Matches matches, NameOf name_of) {
    for (const std::string& name : names) {
        const auto stands_for = [&](const Item& item) { return matches(item, name); };
        if (name == "all" || std::any_of(items.begin(), items.end(), stands_for)) continue;
        std::vector<std::string> known;
        for (const Item& item : items) {
            if (known.empty() || known.back() != name_of(item)) known.push_back(name_of(item));
        }
        throw std::invalid_argument(
            fmt::format("unknown {} '{}'; known: all, {}", what, name, fmt::join(known, ", ")));
    }
    std::vector<const Item*> selected;
    for (const Item& item : items) {
        const auto asked = [&](const std::string& name) { return name == "all" || matches(item, name); };
        if (std::any_of(names.begin(), names.end(), asked)) selected.push_back(&item);
    }
    return selected;
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
    for (const AlgorithmInfo& info : algorithms()) {
        if (info.name == name) return info;
    }
    throw std::invalid_argument(fmt::format("there is no algorithm '{}'", name));
}

std::vector<const TableType*> select_table_types(std::span<const std::string> names) {
    return select<TableType>(
        table_types(), names, "layout (or table type, as in aos_f64)",
        [](const TableType& type, const std::string& name) {
            return type.name == name || type.layout == name;
        },
        [](const TableType& type) { return type.layout; });
}

std::vector<std::string> select_algorithms(std::span<const std::string> names) {
    std::vector<std::string> result;
    for (const AlgorithmInfo* algorithm : select<AlgorithmInfo>(
             algorithms(), names, "algorithm",
             [](const AlgorithmInfo&info, const std::string&name) { return info.name == name; },
             [](const AlgorithmInfo&info) { return info.name; })) {
        result.push_back(algorithm->name);
    }
    return result;
}

}  // namespace edgewise::bench
