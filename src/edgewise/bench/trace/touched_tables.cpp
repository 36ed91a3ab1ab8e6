// SPDX-License-Identifier: MIT
#include "edgewise/bench/trace/touched_tables.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace edgewise::bench {

namespace {

struct Part {
    std::uint64_t touched = 0, all = 0;

    void operator+=(const Part& other) {
        touched += other.touched;
        all += other.all;
    }
    [[nodiscard]] double fraction() const { return static_cast<double>(touched) / static_cast<double>(all); }
};

using Components = std::array<Part, component_names.size()>;

/// Books the bytes of a piece's shares; what is left of an element is padding.
void add_shares(const MappedPiece& piece, const measure::TouchedBytes& touched, Components& components) {
    for (std::size_t i = 0; i < piece.count; ++i) {
        std::size_t at = piece.offset + i * piece.stride;
        const std::size_t end = at + piece.stride;
        const auto book = [&](Component component, std::size_t bytes) {
            components[static_cast<std::size_t>(component)] += {touched.count(at, bytes), bytes};
            at += bytes;
        };
        for (const Share& share : piece.shares) book(share.component, share.bytes);
        if (at < end) book(Component::padding, end - at);
    }
}

/// Returns the kind of feature that the elements of this component belong to; nothing if it is not one kind.
std::optional<FeatureKind> kind_of(Component component) {
    if (component == Component::vertex_coordinates) return FeatureKind::vertex;
    if (component == Component::face_planes) return FeatureKind::face;
    if (component == Component::voronoi_planes || component == Component::edge_geometry)
        return FeatureKind::edge;
    return std::nullopt;
}

std::size_t features_of(const TableMap& map, FeatureKind kind) {
    return kind == FeatureKind::vertex ? map.vertices : kind == FeatureKind::edge ? map.edges : map.faces;
}

bool serves(const MappedPiece& piece, FeatureKind kind) {
    return piece.count > 0 && std::any_of(piece.shares.begin(), piece.shares.end(), [&](const Share& share) {
               return share.bytes > 0 && kind_of(share.component) == kind;
           });
}

/// Returns the pieces that identify a table's features of a kind: element i of a piece belongs to feature
/// i mod n. Empty if the table has no such piece. Pieces of exactly one element a feature are believed first:
/// others may be lists of something else (the planes of `linked`).
std::vector<const MappedPiece*> feature_pieces(const TableMap& map, FeatureKind kind) {
    const std::size_t count = features_of(map, kind);
    std::vector<const MappedPiece*> single, several;
    for (const MappedPiece& piece : map.pieces) {
        if (!serves(piece, kind)) continue;
        if (count == 0 || piece.count % count != 0) return {};
        (piece.count == count ? single : several).push_back(&piece);
    }
    return single.empty() ? several : single;
}

/// Marks the features with touched elements in the piece: element i belongs to feature i mod n.
void mark(const MappedPiece& piece, const measure::TouchedBytes& touched, std::vector<bool>& features) {
    for (std::size_t i = 0; i < piece.count; ++i) {
        if (touched.count(piece.offset + i * piece.stride, piece.stride) > 0)
            features[i % features.size()] = true;
    }
}

std::optional<double> fraction_of(std::span<const TableMap> maps, const measure::TouchedBytes& touched,
                                  FeatureKind kind) {
    Part sum;
    for (const TableMap& map : maps) {
        const auto features = touched_features(map, touched, kind);
        if (!features) return std::nullopt;
        sum += {features->size(), features_of(map, kind)};
    }
    if (sum.all == 0) return std::nullopt;
    return sum.fraction();
}

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

std::optional<std::vector<std::uint32_t>> touched_features(const TableMap& map,
                                                           const measure::TouchedBytes& touched,
                                                           FeatureKind kind) {
    const std::vector<const MappedPiece*> pieces = feature_pieces(map, kind);
    if (pieces.empty()) return std::nullopt;
    std::vector<bool> is_touched(features_of(map, kind), false);
    for (const MappedPiece* piece : pieces) mark(*piece, touched, is_touched);
    std::vector<std::uint32_t> features;
    for (std::uint32_t i = 0; i < is_touched.size(); ++i)
        if (is_touched[i]) features.push_back(i);
    return features;
}

measure::TouchedTables touched_tables(std::span<const TableMap> maps, const measure::TouchedBytes& touched) {
    Components components;
    for (const TableMap& map : maps) {
        for (const MappedPiece& piece : map.pieces) add_shares(piece, touched, components);
    }
    measure::TouchedTables result;
    for (std::size_t i = 0; i < components.size(); ++i) {
        result.bytes += components[i].touched;
        result.of_bytes += components[i].all;
        if (components[i].all > 0)
            result.by_component[std::string(component_names[i])] = components[i].fraction();
    }
    result.vertices = fraction_of(maps, touched, FeatureKind::vertex);
    result.edges = fraction_of(maps, touched, FeatureKind::edge);
    result.faces = fraction_of(maps, touched, FeatureKind::face);
    return result;
}

ComponentPlaces::ComponentPlaces(std::span<const TableMap> maps) {
    for (const TableMap& map : maps) pieces_.insert(pieces_.end(), map.pieces.begin(), map.pieces.end());
    std::ranges::sort(pieces_, {}, &MappedPiece::offset);
}

std::optional<std::string_view> ComponentPlaces::at(std::uint64_t address) const {
    const auto after = std::ranges::upper_bound(pieces_, address, {}, &MappedPiece::offset);
    if (after == pieces_.begin()) return std::nullopt;
    const MappedPiece& piece = *(after - 1);
    const std::uint64_t within = address - piece.offset;
    if (within >= piece.stride * piece.count) return std::nullopt;
    return component_names[static_cast<std::size_t>(component_at(piece, within % piece.stride))];
}

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
