// SPDX-License-Identifier: MIT
#include "edgewise/bench/trace/feature_heat.hpp"

#include <algorithm>
#include <map>

#include "edgewise/bench/trace/touched_tables.hpp"

namespace edgewise::bench {

namespace {

constexpr FeatureKind all_kinds[] = {FeatureKind::vertex, FeatureKind::edge, FeatureKind::face};

/// Purpose of the byte at this place of an element.
Component component_at(const MappedPiece& piece, std::size_t place) {
    for (const Share& share : piece.shares) {
        if (place < share.bytes) return share.component;
        place -= share.bytes;
    }
    return Component::padding;
}

}  // namespace

FeatureHeat::FeatureHeat(std::span<const TableMap> maps) : maps_(maps.begin(), maps.end()) {
    std::map<std::uint64_t, Stretch> by_address;
    for (const TableMap& map : maps_) {
        for (const FeatureKind kind : all_kinds) {
            const auto place = static_cast<std::size_t>(kind);
            for (const MappedPiece* piece : feature_pieces(map, kind)) {
                Stretch& stretch = by_address[piece->offset];
                stretch.from = piece->offset, stretch.piece = piece, stretch.tells[place] = true;
                if (!reads_[place]) reads_[place].emplace(features_of(map, kind), 0);
            }
        }
    }
    for (const auto& [from, stretch] : by_address) stretches_.push_back(stretch);
}

void FeatureHeat::on_access(const measure::TracedAccess& access) {
    if (access.side == measure::TraceSide::scene) return;
    const auto after = std::ranges::upper_bound(stretches_, access.address, {}, &Stretch::from);
    if (after == stretches_.begin()) return;
    const Stretch& stretch = *(after - 1);
    const std::uint64_t within = access.address - stretch.from;
    const std::uint64_t element = within / stretch.piece->stride;
    if (element >= stretch.piece->count) return;
    const auto kind = kind_of(component_at(*stretch.piece, within % stretch.piece->stride));
    if (!kind || !stretch.tells[static_cast<std::size_t>(*kind)]) return;
    std::vector<std::uint32_t>& counts = *reads_[static_cast<std::size_t>(*kind)];
    ++counts[element % counts.size()];
}

}  // namespace edgewise::bench
