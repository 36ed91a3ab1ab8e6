// SPDX-License-Identifier: MIT
//
// Writes a recording that `edgewise sweep --scenes FILE` replays: the convex shapes and bodies of an engine's
// scene, then a line for each step with poses and the pairs that the engine asked, in the format
// convex-motion (docs/your_engine.md). It needs the standard library of C++20 alone.
//
// Use Recorder<float> in an engine of single precision, else Recorder<double>. Add all shapes and bodies,
// then call step() after every step. A bad call throws std::invalid_argument and writes nothing.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace edgewise {

/// Source of the pairs of a step; none: the engine gives no pairs, and the reader finds those of near bodies.
enum class RecordedPairs : std::uint8_t { none, broad_phase, contacts };

template <class Scalar>
class Recorder {
  public:
    using Vector = std::array<Scalar, 3>;
    using Pose = std::array<Scalar, 7>;  ///< position x y z, unit quaternion w x y z: world = R x + position
    using Pair = std::array<std::size_t, 2>;  ///< two bodies, by number

    /// A collision geometry: a shape on a link (a rigid body of the engine).
    struct Body {
        std::size_t shape = 0, link = 0;
        Pose pose = {0, 0, 0, 1, 0, 0, 0};  ///< in the link
        Vector scale = {1, 1, 1};
        std::ptrdiff_t parent = -1;           ///< link that this link hangs on, which it is never asked with
        std::uint32_t group = 1, mask = ~0U;  ///< asked if a's group is in b's mask, or b's in a's
        bool fixed = false;                   ///< never moves
    };

    struct Contact {
        std::size_t a = 0, b = 0;  ///< bodies
        Scalar distance = 0;       ///< below 0 in penetration
    };

    struct Step {
        double time = 0;                   ///< s
        std::span<const Pose> poses;       ///< one for each link
        std::span<const Pair> pairs = {};  ///< as the narrow phase took them
        std::span<const Contact> contacts = {};
        std::span<const std::size_t> asleep = {};  ///< links
        bool jump = false;  ///< poses do not follow from the last step: reset, teleport
    };

    /// Nothing is written before the first step. `time_step`: of the physics, in s.
    Recorder(std::ostream& out, std::string_view engine, double time_step,
             RecordedPairs pairs = RecordedPairs::none)
        : out_(out), has_pairs_(pairs != RecordedPairs::none) {
        constexpr std::string_view names[] = {"none", "broad_phase", "contacts"};
        header_ = R"({"format":"convex-motion","version":0,"engine":)" + quoted(engine) + R"(,"time_step":)" +
                  number(time_step, "time_step") + R"(,"precision":")" +
                  (std::is_same_v<Scalar, float> ? "single" : "double") + R"(","pairs":")" +
                  std::string(names[static_cast<std::size_t>(pairs)]) + '"';
    }

    // Shapes are convex cores, rounded by a radius. Each call returns the shape's number.

    std::size_t add_hull(std::span<const Vector> vertices, Scalar radius = 0) {
        if (vertices.empty()) refuse("a hull has no vertices");
        return add_shape("hull", list("vertices", vertices, numbers<Vector>), radius);
    }
    std::size_t add_box(const Vector& half_extents, Scalar radius = 0) {
        for (const Scalar half : half_extents)
            if (!(half >= 0)) refuse("a half extent of a box is below 0");
        return add_shape("box", R"(,"half":)" + numbers(half_extents, "half_extents"), radius);
    }
    std::size_t add_sphere(Scalar radius) { return add_shape("sphere", "", radius); }
    /// Along the local z axis.
    std::size_t add_capsule(Scalar half_length, Scalar radius) {
        if (!(half_length >= 0)) refuse("a half length of a capsule is below 0");
        return add_shape("capsule", R"(,"half_length":)" + number(half_length, "half_length"), radius);
    }
    /// The hull of a mesh file that Edgewise reads; a relative path is relative to the recording.
    std::size_t add_mesh(std::string_view file) { return add_shape("mesh", R"(,"file":)" + quoted(file), 0); }
    /// A shape without a polytope as its core, such as a plane: the reader counts it and leaves it out.
    std::size_t add_other(std::string_view type) { return add_shape(type, "", 0); }

    /// Returns the body's number.
    std::size_t add_body(const Body& body) {
        if (begun_) refuse("a body is added after the first step");
        for (const Scalar scale : body.scale)
            if (!(scale > 0)) refuse("a scale of a body is not above 0: mirror its vertices instead");
        bodies_text_ += std::string(bodies_ == 0 ? "" : ",") + R"({"shape":)" +
                        index(body.shape, shapes_, "shape") + R"(,"link":)" + std::to_string(body.link) +
                        R"(,"pose":)" + pose_text(body.pose, "pose") + R"(,"scale":)" +
                        numbers(body.scale, "scale") +
                        (body.parent < 0 ? "" : R"(,"parent":)" + std::to_string(body.parent)) +
                        R"(,"group":)" + std::to_string(body.group) + R"(,"mask":)" +
                        std::to_string(body.mask) + (body.fixed ? R"(,"fixed":true})" : "}");
        if (body.link >= links_) links_ = body.link + 1;
        name_link(body.parent);
        return bodies_++;
    }

    /// Excludes all pairs of a body on `link_a` and a body on `link_b`.
    void exclude(std::size_t link_a, std::size_t link_b) {
        if (begun_) refuse("a pair is excluded after the first step");
        name_link(static_cast<std::ptrdiff_t>(link_a));
        name_link(static_cast<std::ptrdiff_t>(link_b));
        excluded_ +=
            (excluded_.empty() ? "[" : ",[") + std::to_string(link_a) + "," + std::to_string(link_b) + "]";
    }

    void step(const Step& step) {
        if (bodies_ == 0) refuse("there are no bodies");
        if (named_ >= static_cast<std::ptrdiff_t>(links_))
            refuse("link " + std::to_string(named_) + " is a parent or excluded, and no body is on it");
        if (step.poses.size() != links_)
            refuse(std::to_string(step.poses.size()) + " poses of " + std::to_string(links_) + " links");
        if (!step.pairs.empty() && !has_pairs_)
            refuse("a step has pairs, and the recorder was made for none");
        if (begun_ && step.time < last_time_ && !step.jump) refuse("time goes back without a jump");
        const auto pair_text = [this](const Pair& pair, const std::string& at) {
            if (pair[0] == pair[1]) refuse(at + " is a body with itself");
            std::string text = "[";
            return text.append(index(pair[0], bodies_, at) + "," + index(pair[1], bodies_, at));
        };
        const std::string line =
            R"({"t":)" + number(step.time, "time") + list("poses", step.poses, pose_text) +
            list("pairs", step.pairs,
                 [&](const Pair& pair, const std::string& at) { return pair_text(pair, at) + "]"; }) +
            list("contacts", step.contacts,
                 [&](const Contact& of, const std::string& at) {
                     return pair_text({of.a, of.b}, at) + "," + number(of.distance, at) + "]";
                 }) +
            list("asleep", step.asleep,
                 [this](std::size_t link, const std::string& at) { return index(link, links_, at); });
        if (!begun_)
            out_ << header_ << R"(,"shapes":[)" << shapes_text_ << R"(],"bodies":[)" << bodies_text_
                 << R"(],"excluded":[)" << excluded_ << "]}\n";
        out_ << line << (step.jump ? ",\"jump\":true}\n" : "}\n");
        begun_ = true;
        last_time_ = step.time;
    }

  private:
    [[noreturn]] static void refuse(const std::string& what) {
        throw std::invalid_argument("edgewise recorder: " + what);
    }

    /// The fewest digits that read back as the same number of its type: at most 9 of float, 17 of double.
    template <class Number>
    static std::string number(Number value, const std::string& what) {
        if (!std::isfinite(value)) refuse(what + " is not finite");
        std::array<char, 32> text{};
        return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
    }
    template <class Numbers>
    static std::string numbers(const Numbers& values, const std::string& what) {
        std::string text;
        for (const Scalar value : values) text.append(text.empty() ? "[" : ",").append(number(value, what));
        return text + "]";
    }
    static std::string pose_text(const Pose& pose, const std::string& what) {
        const double squared = double{pose[3]} * pose[3] + double{pose[4]} * pose[4] +
                               double{pose[5]} * pose[5] + double{pose[6]} * pose[6];
        const std::string text = numbers(pose, what);
        if (std::abs(squared - 1) > 2e-3)
            refuse(what + " has a quaternion (w x y z) that is no unit quaternion");
        return text;
    }
    /// A member with a list; nothing if there is none.
    template <class Items, class Text>
    static std::string list(const std::string& name, const Items& items, Text text_of) {
        std::string text;
        for (std::size_t i = 0; i < items.size(); ++i)
            text += (i == 0 ? ",\"" + name + "\":[" : ",") +
                    text_of(items[i], name + "[" + std::to_string(i) + "]");
        return items.empty() ? text : text + "]";
    }
    static std::string quoted(std::string_view text) {
        std::string result = "\"";
        for (const char c : text) {
            if (static_cast<unsigned char>(c) < ' ') refuse("a name has a control character");
            if (c == '"' || c == '\\') result += '\\';
            result += c;
        }
        return result + '"';
    }
    static std::string index(std::size_t number, std::size_t count, const std::string& at) {
        if (number >= count)
            refuse(at + " is number " + std::to_string(number) + " of " + std::to_string(count));
        return std::to_string(number);
    }

    /// The next step refuses a link that no body is on by then.
    void name_link(std::ptrdiff_t link) {
        if (link > named_) named_ = link;
    }

    std::size_t add_shape(std::string_view type, const std::string& members, Scalar radius) {
        if (begun_) refuse("a shape is added after the first step");
        if (!(radius >= 0)) refuse("a radius is below 0");
        shapes_text_ += std::string(shapes_ == 0 ? "" : ",") + R"({"type":)" + quoted(type) + members +
                        R"(,"radius":)" + number(radius, "radius") + "}";
        return shapes_++;
    }

    std::ostream& out_;
    bool has_pairs_, begun_ = false;
    std::string header_, shapes_text_, bodies_text_, excluded_;
    std::size_t shapes_ = 0, bodies_ = 0, links_ = 0;
    std::ptrdiff_t named_ = -1;  ///< the largest link that is a parent or excluded
    double last_time_ = 0;
};

}  // namespace edgewise
