// SPDX-License-Identifier: MIT
#include "edgewise/bench/peers/peer_modules.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "edgewise/bench/peers/peer_runner.hpp"
#include "edgewise/geometry/hull.hpp"

namespace edgewise::bench {

namespace {

constexpr std::string_view module_ending = ".so";

/// For good: what it says of itself lies in it. Its symbols, and those of its library, stay its own.
const peers::PeerInfo* open_module(const std::filesystem::path& file) {
    void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* symbol = module ? dlsym(module, peers::peer_symbol) : nullptr;
    if (!symbol) throw std::runtime_error(fmt::format("peer {}: {}", file.string(), dlerror()));
    return reinterpret_cast<peers::PeerFunction>(symbol)();
}

std::vector<const peers::PeerInfo*> open_all(const std::filesystem::path& folder) {
    std::vector<const peers::PeerInfo*> found;
    if (!std::filesystem::is_directory(folder)) return found;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == module_ending) found.push_back(open_module(entry.path()));
    }
    const auto key = [](const peers::PeerInfo* info) {
        return std::pair<std::string_view, std::string_view>(info->name, info->precision);
    };
    std::sort(found.begin(), found.end(), [&](auto* a, auto* b) { return key(a) < key(b); });
    return found;
}

TableType type_of(const peers::PeerInfo& info) {
    TableType type;
    type.is_peer = true;
    type.verdict_only = info.verdict_only;
    type.layout = info.name;
    type.precision = info.precision;
    type.name = type.layout + "_" + type.precision;
    type.stores = std::string(info.library) + ": " + info.summary;
    type.derives = fmt::format("a pair keeps {}; adapter compiled with {}", info.cache, info.flags);
    type.algorithms = {info.name};
    type.single_storage = type.precision != "f64";
    type.storage = type.single_storage ? "single" : "double";
    type.eps = type.precision == "f32" ? Tolerance<float>::eps : Tolerance<double>::eps;
    type.stored_body = [single = type.single_storage](const Polyhedron& body) {
        return single ? round_to_single(body) : Result<Polyhedron>::success(body);
    };
    type.make_runner = [&info](std::string_view) { return std::make_unique<PeerRunner>(info); };
    return type;
}

}  // namespace

std::filesystem::path peers_folder() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path() / peers_folder_name();
}

std::span<const peers::PeerInfo* const> peers_found() {
    static const std::vector<const peers::PeerInfo*> found = open_all(peers_folder());
    return found;
}

std::span<const TableType> peer_types() {
    static const std::vector<TableType> types = [] {
        std::vector<TableType> result;
        for (const peers::PeerInfo* info : peers_found()) result.push_back(type_of(*info));
        return result;
    }();
    return types;
}

std::span<const AlgorithmInfo> peer_algorithms() {
    static const std::vector<AlgorithmInfo> algorithms = [] {
        std::vector<AlgorithmInfo> result;
        for (const peers::PeerInfo* info : peers_found()) {
            if (result.empty() || result.back().name != info->name)
                result.push_back(
                    {info->name, std::string(info->library) + ": " + info->summary, Parts::support});
        }
        return result;
    }();
    return algorithms;
}

std::vector<const TableType*> select_peer_types(std::span<const std::string> names) {
    if (names.empty()) return {};
    if (peer_types().empty()) {
        throw std::invalid_argument(fmt::format(
            "no peers are built: {} has no module; run layouts/sweep --peers", peers_folder().string()));
    }
    return select_types(peer_types(), names, "peer");
}

}  // namespace edgewise::bench
