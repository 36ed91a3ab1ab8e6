// SPDX-License-Identifier: MIT
#include "pair_bytes.hpp"

#include <cmath>
#include <cstring>

#include "edgewise/scene/quaternion.hpp"

namespace edgewise {

namespace {

constexpr std::size_t most_vertices = 24;
/// Largest deviation from an orthogonal matrix that counts as a rotation; no unit.
constexpr double most_ortho_error = 1e-6;

/// Coordinates between 2^-40 and 2^40 stay unchanged. Otherwise flipped exponent bits would put a few points
/// of most pairs 10^200 times as far out as the others; such sizes have their own tests.
constexpr int most_places = 40;

/// Smaller numbers become zero, which gives flat, coincident and aligned points; larger ones get a smaller
/// exponent.
double tame(double x) {
    if (!std::isfinite(x) || x == 0) return x;
    const int exponent = std::ilogb(x);
    if (exponent < -most_places) return 0;
    return exponent <= most_places ? x : std::ldexp(x, exponent % most_places - exponent);
}

enum Form : std::uint8_t { matrices, quaternions, forms };

class Reader {
  public:
    explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    /// Next byte; zero after the end.
    [[nodiscard]] std::uint8_t byte() {
        if (bytes_.empty()) return 0;
        const std::uint8_t first = bytes_[0];
        bytes_ = bytes_.subspan(1);
        return first;
    }
    [[nodiscard]] double number() {
        std::uint8_t raw[sizeof(double)];
        for (std::uint8_t& b : raw) b = byte();
        double value;
        std::memcpy(&value, raw, sizeof value);
        return value;
    }
    [[nodiscard]] Vec3d point() {
        Vec3d p;
        for (int i = 0; i < 3; ++i) p[i] = tame(number());
        return p;
    }

  private:
    std::span<const std::uint8_t> bytes_;
};

Mat3d rotation(Reader& reader, Form form) {
    Mat3d result;
    if (form == quaternions) {
        const auto whole = [&] { return static_cast<double>(static_cast<std::int8_t>(reader.byte())); };
        const scene::Quaternion q{whole(), whole(), whole(), whole()};
        return squared_norm(q) > 0 ? scene::rotation_matrix(normalised(q)) : Mat3d(Mat3d::Identity());
    }
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) result(row, column) = reader.number();
    }
    return result;
}

scene::CaseBody body(Reader& reader, std::size_t count, const char* where) {
    scene::CaseBody result;
    result.where = where;
    for (std::size_t i = 0; i < count; ++i) result.vertices.push_back(reader.point());
    return result;
}

bool is_sound(const scene::CaseBody& body, const Pose& pose) {
    for (const Vec3d& v : body.vertices) {
        if (!v.allFinite()) return false;
    }
    return pose.translation.allFinite() && pose.rotation.allFinite() &&
           ortho_error(pose.rotation) < most_ortho_error;
}

void append(std::vector<std::uint8_t>& bytes, double value) {
    std::uint8_t raw[sizeof(double)];
    std::memcpy(raw, &value, sizeof value);
    bytes.insert(bytes.end(), raw, raw + sizeof value);
}

void append(std::vector<std::uint8_t>& bytes, const Vec3d& point) {
    for (int i = 0; i < 3; ++i) append(bytes, point[i]);
}

void append(std::vector<std::uint8_t>& bytes, const Pose& pose) {
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) append(bytes, pose.rotation(row, column));
    }
    append(bytes, pose.translation);
}

}  // namespace

std::optional<scene::Case> pair_from_bytes(std::span<const std::uint8_t> bytes) {
    Reader reader(bytes);
    const std::size_t count_a = 1 + reader.byte() % most_vertices;
    const std::size_t count_b = 1 + reader.byte() % most_vertices;
    const Form form = static_cast<Form>(reader.byte() % forms);
    scene::Case result;
    result.id = "fuzz";
    for (Pose* pose : {&result.pose_a, &result.pose_b}) {
        pose->rotation = rotation(reader, form);
        pose->translation = reader.point();
    }
    result.a = body(reader, count_a, "a");
    result.b = body(reader, count_b, "b");
    if (!is_sound(result.a, result.pose_a) || !is_sound(result.b, result.pose_b)) return std::nullopt;
    return result;
}

std::optional<std::vector<std::uint8_t>> bytes_from_pair(const scene::Case& given) {
    if (given.a.vertices.size() > most_vertices || given.b.vertices.size() > most_vertices)
        return std::nullopt;
    std::vector<std::uint8_t> bytes = {static_cast<std::uint8_t>(given.a.vertices.size() - 1),
                                       static_cast<std::uint8_t>(given.b.vertices.size() - 1), matrices};
    append(bytes, given.pose_a);
    append(bytes, given.pose_b);
    for (const Vec3d& v : given.a.vertices) append(bytes, v);
    for (const Vec3d& v : given.b.vertices) append(bytes, v);
    return bytes;
}

}  // namespace edgewise
