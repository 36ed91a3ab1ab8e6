// SPDX-License-Identifier: MIT
#include "edgewise/scene/mesh/mesh_bytes.hpp"

#include <cstdint>
#include <cstring>

namespace edgewise::scene {
namespace {

using Parts = Result<std::vector<MeshPart>>;

void put(std::string& to, const void* data, std::size_t bytes) {
    if (bytes > 0) to.append(static_cast<const char*>(data), bytes);
}
void put(std::string& to, std::uint64_t number) { put(to, &number, sizeof number); }
void put(std::string& to, const std::string& text) {
    put(to, text.size());
    put(to, text.data(), text.size());
}

/// Takes values from the front; once one is missing, all are.
class Taker {
  public:
    explicit Taker(std::string_view bytes) : rest_(bytes) {}

    void take(void* to, std::size_t bytes) {
        whole_ = whole_ && bytes <= rest_.size();
        if (!whole_ || bytes == 0) return;
        std::memcpy(to, rest_.data(), bytes);
        rest_.remove_prefix(bytes);
    }
    std::uint64_t number() {
        std::uint64_t value = 0;
        take(&value, sizeof value);
        return whole_ ? value : 0;
    }
    /// Of as many items as are said to follow; none where they do not.
    template <class Items>
    Items items() {
        const std::uint64_t count = number();
        whole_ = whole_ && count <= rest_.size() / sizeof(typename Items::value_type);
        Items all(whole_ ? count : 0, typename Items::value_type{});
        take(all.data(), all.size() * sizeof(typename Items::value_type));
        return all;
    }
    [[nodiscard]] bool whole() const { return whole_; }

  private:
    std::string_view rest_;
    bool whole_ = true;
};

}  // namespace

std::string bytes_of(const Parts& parts) {
    std::string bytes;
    put(bytes, parts.error);
    put(bytes, parts.warning);
    put(bytes, parts ? parts->size() : 0);
    if (!parts) return bytes;
    for (const MeshPart& part : *parts) {
        put(bytes, part.name);
        put(bytes, 3 * part.points.size());
        for (const Vec3d& point : part.points) put(bytes, point.data(), 3 * sizeof(double));
        put(bytes, 3 * part.triangles.size());
        for (const auto& triangle : part.triangles) put(bytes, triangle.data(), 3 * sizeof(Index));
        put(bytes, std::uint64_t{part.in_single});
    }
    return bytes;
}

Parts parts_from(std::string_view bytes) {
    Taker taker(bytes);
    if (std::string error = taker.items<std::string>(); !error.empty()) return Parts::failure(error);
    std::string warning = taker.items<std::string>();
    std::vector<MeshPart> parts;
    for (std::uint64_t left = taker.number(); left > 0 && taker.whole(); --left) {
        MeshPart& part = parts.emplace_back();
        part.name = taker.items<std::string>();
        const auto coordinates = taker.items<std::vector<double>>();
        for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
            part.points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
        const auto corners = taker.items<std::vector<Index>>();
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
            part.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
        part.in_single = taker.number() != 0;
    }
    if (!taker.whole())
        return Parts::failure(": cannot be read as a mesh: the reader's answer was cut short");
    return Parts::success(std::move(parts), std::move(warning));
}

}  // namespace edgewise::scene
