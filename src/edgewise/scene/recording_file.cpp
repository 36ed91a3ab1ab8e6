// SPDX-License-Identifier: MIT
//
// Reads recordings line by line. Unknown members are ignored, as the format says; everything else that is not
// understood is refused.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <span>
#include <tuple>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/input/json_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/scene/case_file.hpp"
#include "edgewise/scene/gzip_lines.hpp"
#include "edgewise/scene/json_fields.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"
#include "edgewise/scene/quaternion.hpp"
#include "edgewise/scene/recording.hpp"

namespace edgewise::scene {
namespace {

constexpr int known_version = 0;
constexpr std::size_t most_poses = 10'000'000;  ///< in memory: 96 bytes each
constexpr double sloppiest_length = 1e-3;       ///< of a unit quaternion, from 1

/// A shape of the header; nothing instead of a core: it is left out.
struct Shape {
    std::string type;
    std::optional<CaseBody> core;
    double radius = 0;
};

/// A text member; the standard if it is left out.
std::string text_at(const Json& object, const char* key, const std::string& standard) {
    const Json& value = member(object, key);
    if (value.is_null()) return standard;
    if (!value.is_string()) throw JsonFault{fmt::format("{} is not a text", key)};
    return value.get<std::string>();
}

bool flag_at(const Json& object, const char* key, const std::string& field) {
    const Json& value = member(object, key);
    if (!value.is_null() && !value.is_boolean()) throw JsonFault{field + " is neither true nor false"};
    return value.is_boolean() && value.get<bool>();
}

/// One of the names; the first if it is left out.
std::size_t choice_at(const Json& header, const char* key, const std::vector<std::string>& names) {
    const std::string name = text_at(header, key, names.front());
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) throw JsonFault{unknown_name(key, name, names)};
    return static_cast<std::size_t>(found - names.begin());
}

class RecordingReader {
  public:
    RecordingReader(const std::string& path, bool as_stored)
        : folder_(std::filesystem::path(path).parent_path()), as_stored_(as_stored) {}

    void read_header(const Json& header) {
        if (text_at(header, "format", "") != "convex-motion")
            throw JsonFault{R"(is no recording: the first line must have "format": "convex-motion")"};
        if (member(header, "version") != known_version)
            throw JsonFault{fmt::format("version {} is not known: this program reads version {}",
                                        member(header, "version").dump(), known_version)};
        single_ = choice_at(header, "precision", {"double", "single"}) == 1;
        recording_.has_pairs = choice_at(header, "pairs", {"none", "broad_phase", "contacts"}) > 0;
        for (const Json& object : array_at(header, "shapes", "shapes"))
            shapes_.push_back(shape(object, fmt::format("shapes[{}]", shapes_.size())));
        for (const Json& object : array_at(header, "bodies", "bodies"))
            add_body(object, fmt::format("bodies[{}]", kept_.size()));
        if (recording_.bodies.empty())
            throw JsonFault{"bodies: none has a shape with a polytope as its core"};
        for (const RecordedBody& body : recording_.bodies)
            if (body.parent.value_or(0) >= links_)
                throw JsonFault{fmt::format("parent {} is none of the {} links", *body.parent, links_)};
        const Json& excluded = list_at(header, "excluded");
        for (std::size_t i = 0; i < excluded.size(); ++i) {
            const std::string field = fmt::format("excluded[{}]", i);
            if (!excluded[i].is_array() || excluded[i].size() != 2)
                throw JsonFault{field + " is not a pair of links"};
            const auto a = link(excluded[i][0], field), b = link(excluded[i][1], field);
            recording_.excluded.push_back(
                {static_cast<std::uint32_t>(std::min(a, b)), static_cast<std::uint32_t>(std::max(a, b))});
        }
        std::ranges::sort(recording_.excluded);
    }

    void read_step(const Json& line) {
        RecordedStep step;
        const Json& time = required(line, "t", "t");
        if (!time.is_number()) throw JsonFault{"t is not a finite number"};
        step.time = time.get<double>();
        step.jump = flag_at(line, "jump", "jump");
        if (!recording_.steps.empty() && step.time < recording_.steps.back().time && !step.jump)
            throw JsonFault{
                fmt::format(R"(t = {} is before the step before: a reset needs "jump": true)", step.time)};
        move_links(line);
        step.links = now_;
        const Json& asleep = list_at(line, "asleep");
        if (!asleep.empty()) step.asleep.resize(links_);
        for (std::size_t i = 0; i < asleep.size(); ++i)
            step.asleep[link(asleep[i], fmt::format("asleep[{}]", i))] = true;
        step.pairs = pairs(line, "pairs", 2);
        if (!recording_.has_pairs && !step.pairs.empty())
            throw JsonFault{R"(pairs: the header says "none": write "pairs": "broad_phase" there)"};
        static_cast<void>(pairs(line, "contacts", 3));  // a check for people
        recording_.steps.push_back(std::move(step));
        if (recording_.steps.size() * links_ > most_poses)
            throw JsonFault{
                fmt::format("more than {} poses: record fewer steps, or at a lower rate", most_poses)};
    }

    Recording finish(const GzipLines& lines) {
        if (recording_.steps.empty()) throw JsonFault{"there is no step after the header"};
        sort_cores();
        recording_.note = note();
        recording_.checksum = lines.checksum();
        for (const Polyhedron& core : recording_.cores)  // mesh files are part of the motion, too
            recording_.checksum = checksum_of(std::as_bytes(std::span(core.vertices)), recording_.checksum);
        return std::move(recording_);
    }

  private:
    template <std::size_t Count>
    [[nodiscard]] std::array<double, Count> stored(const Json& list, const std::string& field) const {
        auto values = numbers<Count>(list, field);
        for (double& value : values) value = as_recorded(value, field);
        return values;
    }
    /// Nine digits of a number in single precision name that number, not the double next to them.
    [[nodiscard]] double as_recorded(double value, const std::string& field) const {
        const double number = single_ ? to_single(value) : value;
        if (!std::isfinite(number)) throw JsonFault{field + " is not finite in single precision"};
        return number;
    }
    [[nodiscard]] Vec3d vector(const Json& list, const std::string& field) const {
        return Vec3d(stored<3>(list, field).data());
    }
    [[nodiscard]] std::size_t link(const Json& value, const std::string& field) const {
        return index_of(value, links_, "link", "links", field);
    }

    double length(const Json& object, const char* key, const std::string& field, bool is_required) const {
        const Json& value = is_required ? required(object, key, field) : member(object, key);
        if (value.is_null()) return 0;
        if (!value.is_number() || !(value.get<double>() >= 0))
            throw JsonFault{
                fmt::format("{} = {} must be a number from 0 on", field, on_one_line(value.dump()))};
        return as_recorded(value.get<double>(), field);
    }

    Pose pose(const Json& list, const std::string& field) const {
        const auto p = stored<7>(list, field);
        const Quaternion q{p[3], p[4], p[5], p[6]};
        const double length = std::sqrt(squared_norm(q));
        if (!(std::abs(length - 1) <= sloppiest_length))
            throw JsonFault{
                fmt::format("{} has a quaternion of length {:.3g}: a pose is x, y, z, then the unit "
                            "quaternion w, x, y, z",
                            field, length)};
        return {rotation_matrix(normalised(q)), Vec3d(p.data())};
    }

    Shape shape(const Json& object, const std::string& field) {
        if (!object.is_object()) throw JsonFault{field + " is not an object"};
        const std::string type = text_at(object, "type", "");
        Shape shape{type, CaseBody{field, {}, {}},
                    length(object, "radius", field + ".radius", type == "sphere")};
        std::vector<Vec3d>& vertices = shape.core->vertices;
        if (shape.type == "hull") {
            for (const Json& vertex : array_at(object, "vertices", field + ".vertices"))
                vertices.push_back(vector(vertex, fmt::format("{}.vertices[{}]", field, vertices.size())));
            if (const Json& faces = member(object, "faces"); !faces.is_null())
                shape.core->faces = faces_of(faces, vertices.size(), field + ".faces");
        } else if (shape.type == "mesh") {
            const auto file = folder_ / text_at(object, "file", "");
            auto mesh = read_mesh_file(file.string(), {.as_stored = as_stored_, .takes_flat = true});
            if (!mesh) throw JsonFault{fmt::format("{}: {}", field, mesh.error)};
            if (!mesh.warning.empty()) notes_.push_back(mesh.warning);
            vertices = mesh->front().body.vertices;
        } else if (shape.type == "box") {
            const Vec3d half = vector(required(object, "half", field + ".half"), field + ".half");
            if (!(half.minCoeff() >= 0)) throw JsonFault{field + ".half has a number below 0"};
            for (int corner = 0; corner < 8; ++corner)
                vertices.push_back(
                    half.cwiseProduct(Vec3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
        } else if (shape.type == "sphere") {
            vertices = {Vec3d::Zero()};
        } else if (shape.type == "capsule") {
            const double half = length(object, "half_length", field + ".half_length", true);
            vertices = {Vec3d(0, 0, -half), Vec3d(0, 0, half)};
        } else if (shape.type.empty()) {
            throw JsonFault{field + ".type is missing: hull, mesh, box, sphere or capsule"};
        } else {
            shape.core.reset();
        }
        return shape;
    }

    /// The body of a shape at a scale; equal shapes at equal scales share it.
    std::uint32_t core_of(std::size_t shape, const Vec3d& scale, const std::string& field) {
        const auto next = static_cast<std::uint32_t>(recording_.cores.size());
        const auto [known, is_new] = cores_.try_emplace({shape, scale.x(), scale.y(), scale.z()}, next);
        if (!is_new) return known->second;
        CaseBody core = *shapes_[shape].core;
        for (Vec3d& vertex : core.vertices) vertex = vertex.cwiseProduct(scale);
        auto body = body_from_case(core);
        if (!body) throw JsonFault{fmt::format("{}: {}", field, body.error)};
        recording_.cores.push_back(std::move(*body));
        return next;
    }

    void add_body(const Json& object, const std::string& field) {
        if (!object.is_object()) throw JsonFault{field + " is not an object"};
        const auto number = [&](const char* key, std::uint64_t standard) {
            const Json& value = member(object, key);
            if (value.is_null()) return standard;
            return std::uint64_t{
                index_of(value, UINT32_MAX + std::size_t{1}, key, "numbers", field + "." + key)};
        };
        static_cast<void>(required(object, "shape", field + ".shape"));
        const std::size_t shape =
            index_of(object["shape"], shapes_.size(), "shape", "shapes", field + ".shape");
        RecordedBody body;
        body.link = static_cast<std::uint32_t>(number("link", kept_.size()));
        links_ = std::max(links_, body.link + std::size_t{1});
        if (object.contains("pose")) body.in_link = pose(object["pose"], field + ".pose");
        if (object.contains("parent")) body.parent = static_cast<std::uint32_t>(number("parent", 0));
        body.group = static_cast<std::uint32_t>(number("group", body.group));
        body.mask = static_cast<std::uint32_t>(number("mask", body.mask));
        body.fixed = flag_at(object, "fixed", field + ".fixed");
        if (!shapes_[shape].core) {
            ++left_out_[shapes_[shape].type];
            kept_.emplace_back();
            return;
        }
        const Vec3d scale =
            object.contains("scale") ? vector(object["scale"], field + ".scale") : Vec3d(1, 1, 1);
        if (!(scale.minCoeff() > 0))
            throw JsonFault{field + ".scale must be above 0: mirror the vertices instead"};
        body.radius = shapes_[shape].radius * scale.x();
        if (body.radius > 0 && scale.minCoeff() != scale.maxCoeff())
            throw JsonFault{field +
                            ".scale stretches a rounded shape, which no radius describes: scale its core"};
        body.core = core_of(shape, scale, field);
        kept_.emplace_back(static_cast<std::uint32_t>(recording_.bodies.size()));
        recording_.bodies.push_back(std::move(body));
    }

    void move_links(const Json& line) {
        const Json &poses = array_at(line, "poses", "poses"), &moved = list_at(line, "moved");
        const std::size_t wanted = moved.is_null() ? links_ : moved.size();
        if (poses.size() != wanted)
            throw JsonFault{fmt::format("poses has {} poses and needs {}, one for each {}link", poses.size(),
                                        wanted, moved.is_null() ? "" : "moved ")};
        if (now_.empty() && !moved.is_null())
            throw JsonFault{"moved: the first step needs the poses of all links"};
        now_.resize(links_);
        std::vector<bool> given(links_);
        for (std::size_t i = 0; i < poses.size(); ++i) {
            const std::size_t at = moved.is_null() ? i : link(moved[i], fmt::format("moved[{}]", i));
            if (given[at]) throw JsonFault{fmt::format("moved names link {} twice", at)};
            given[at] = true;
            now_[at] = pose(poses[i], fmt::format("poses[{}]", i));
        }
    }

    /// The pairs of a line's list: each has two bodies first, and perhaps more.
    std::vector<BodyPair> pairs(const Json& line, const char* name, std::size_t members) {
        const Json& list = list_at(line, name);
        std::vector<BodyPair> pairs;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const std::string field = fmt::format("{}[{}]", name, i);
            if (!list[i].is_array() || list[i].size() != members)
                throw JsonFault{fmt::format("{} is not an array of {} numbers", field, members)};
            const Index a = index_of(list[i][0], kept_.size(), "body", "bodies", field),
                        b = index_of(list[i][1], kept_.size(), "body", "bodies", field);
            if (a == b) throw JsonFault{fmt::format("{} pairs body {} with itself", field, a)};
            if (kept_[a] && kept_[b])
                pairs.push_back({std::min(*kept_[a], *kept_[b]), std::max(*kept_[a], *kept_[b])});
            else
                pairs_left_out_ += members == 2;
        }
        std::ranges::sort(pairs);
        const auto repeated = std::ranges::unique(pairs);
        pairs.erase(repeated.begin(), repeated.end());
        return pairs;
    }

    /// Figures of a table are those of the first core: the one with most vertices.
    void sort_cores() {
        std::vector<std::uint32_t> order(recording_.cores.size()), place(order.size());
        std::iota(order.begin(), order.end(), 0U);
        std::ranges::stable_sort(order, std::ranges::greater{},
                                 [&](std::uint32_t core) { return recording_.cores[core].vertices.size(); });
        std::vector<Polyhedron> sorted;
        for (std::size_t i = 0; i < order.size(); ++i) {
            place[order[i]] = static_cast<std::uint32_t>(i);
            sorted.push_back(std::move(recording_.cores[order[i]]));
        }
        recording_.cores = std::move(sorted);
        for (RecordedBody& body : recording_.bodies) body.core = place[body.core];
    }

    [[nodiscard]] std::string note() const {
        std::vector<std::string> parts = notes_;
        double largest = 0;
        std::size_t rounded = 0;
        for (const RecordedBody& body : recording_.bodies) {
            largest = std::max(largest, body.radius);
            rounded += body.radius > 0;
        }
        if (rounded > 0)
            parts.push_back(
                fmt::format("the cores are asked, without the radii (to {:.3g}) of {} of {} bodies, except "
                            "with --axes radius=recorded",
                            largest, rounded, recording_.bodies.size()));
        std::vector<std::string> types;
        for (const auto& [type, count] : left_out_)
            types.push_back(fmt::format("{} {}", count, on_one_line(type)));
        if (!types.empty())
            parts.push_back(fmt::format(
                "bodies without a polytope as their core are left out ({}), with {} of the file's pairs",
                fmt::join(types, ", "), pairs_left_out_));
        return fmt::format("{}", fmt::join(parts, "; "));
    }

    std::filesystem::path folder_;
    bool as_stored_;
    Recording recording_;
    bool single_ = false;
    std::vector<std::string> notes_;  ///< on mesh files
    std::vector<Shape> shapes_;
    std::map<std::tuple<std::size_t, double, double, double>, std::uint32_t> cores_;
    std::vector<std::optional<std::uint32_t>> kept_;  ///< the file's bodies: number here, if not left out
    std::map<std::string, std::size_t> left_out_;     ///< bodies by the type of their shape
    std::size_t links_ = 0, pairs_left_out_ = 0;
    std::vector<Pose> now_;  ///< of all links
};

Json parsed_line(const std::string& line) {
    auto json = input::parse_json<Json>(line);
    if (!json && input::ends_inside(line))
        throw JsonFault{"the line is cut off: record again, or delete the line"};
    if (!json) throw JsonFault{json.error};
    if (!json->is_object()) throw JsonFault{"the line is not a JSON object"};
    return *std::move(json.value);
}

}  // namespace

bool names_recording(std::string_view path) {
    return path.ends_with(".jsonl") || path.ends_with(".jsonl.gz");
}

Result<Recording> read_recording(const std::string& path, bool as_stored) {
    using Failure = Result<Recording>;
    if (const std::string wrong = input::what_is_wrong_with(path); !wrong.empty())
        return Failure::failure(fmt::format("{}: {}", path, wrong));
    std::size_t number = 0;
    try {
        GzipLines lines(path);
        RecordingReader reader(path, as_stored);
        for (std::string line; ++number, lines.next(line);)
            number == 1 ? reader.read_header(parsed_line(line)) : reader.read_step(parsed_line(line));
        Recording recording = reader.finish(lines);
        const std::string file = std::filesystem::path(path).filename().string();
        recording.name = file.substr(0, file.find(".jsonl"));
        return Failure::success(std::move(recording));
    } catch (const JsonFault& fault) {
        return Failure::failure(fmt::format("{}:{}: {}", path, number, without_controls(fault.what)));
    }
}

}  // namespace edgewise::scene
