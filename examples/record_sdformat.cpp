// SPDX-License-Identifier: MIT
//
// Records robots and worlds in SDF, as libsdformat reads them: joints move at a constant speed between random
// places within their limits, without dynamics; what hangs on no joint stays. Links that are welded together
// (fixed joints) become one. Pairs are those of SDF: bits of collide_bitmask in common, no links of one model
// unless it has self_collide, no two links with a joint between them. A model alone in its file is asked with
// itself in any case. A cylinder becomes a prism around it; a mesh is named by its path.
//
// record_sdformat MODEL [SECONDS [RATE [JOINTS]]]: `edgewise record` calls it. At rate 0 there are 1000 steps
// per second. JOINTS: their speed in rad/s, or in lengths per second; 0: all stay.
#include <compare>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <edgewise/record.hpp>
#include <filesystem>
#include <ignition/math/Pose3.hh>
#include <iostream>
#include <map>
#include <random>
#include <regex>
#include <sdf/sdf.hh>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "robot_parts.hpp"

namespace {

using SdfRecorder = edgewise::Recorder<double>;
using Pose = ignition::math::Pose3d;

/// The first error, and where it is.
void refuse_if_any(const sdf::Errors& errors) {
    if (errors.empty()) return;
    const sdf::Error& first = errors.front();
    const std::string line = first.LineNumber() ? "line " + std::to_string(*first.LineNumber()) + ": " : "";
    throw std::invalid_argument("libsdformat: " + line + first.Message());
}

/// Loads the file. libsdformat writes some of what is wrong to std::cerr alone, in colours.
void load(sdf::Root& root, const std::string& file) {
    std::ostringstream said;
    std::streambuf* const screen = std::cerr.rdbuf(said.rdbuf());
    sdf::ParserConfig config = sdf::ParserConfig::GlobalConfig();
    config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::WARN);
    const sdf::Errors errors = root.Load(file, config);
    std::cerr.rdbuf(screen);
    const std::string text = std::regex_replace(said.str(), std::regex("\x1b\\[[0-9;]*m"), "");
    try {
        refuse_if_any(errors);
    } catch (const std::invalid_argument& problem) {
        throw std::invalid_argument(problem.what() + (" (" + text + ")"));
    }
    if (!text.empty()) std::cerr << "libsdformat: " << text << '\n';  // of elements that it does not know
}

template <class Element>
Pose pose_of(const Element& element) {
    Pose pose;
    refuse_if_any(element.SemanticPose().Resolve(pose));
    return pose;
}

SdfRecorder::Pose recorded(const Pose& pose) {
    const auto& p = pose.Pos();
    const auto& q = pose.Rot();
    return {p.X(), p.Y(), p.Z(), q.W(), q.X(), q.Y(), q.Z()};
}

/// A link of any model, with poses in the world where all joints are at 0.
struct Link {
    const sdf::Link* given;
    Pose start, now;
    std::size_t model;  ///< on top
    bool fixed, self_collide;
    int joint = -1;         ///< on which it hangs
    int number = -1;        ///< in the recording; that of the link to which it is welded
    bool is_solid = false;  ///< it has geometry, or what is welded to it
};

/// A joint between links; the parent is -1 for the world.
struct Joint {
    const sdf::Joint* given;
    int parent, child;
    Pose start;
    double place = 0, goal = 0;

    [[nodiscard]] bool turns() const {
        return given->Type() == sdf::JointType::REVOLUTE || given->Type() == sdf::JointType::CONTINUOUS;
    }
    [[nodiscard]] bool moves() const { return turns() || given->Type() == sdf::JointType::PRISMATIC; }
    [[nodiscard]] JointRange range() const {
        const JointRange free = turns() ? free_turn : free_slide;
        constexpr double no_limit = 1e15;  // libsdformat's is 1e16
        const double low = given->Axis(0)->Lower(), high = given->Axis(0)->Upper();
        return {low < -no_limit ? free.low : low, high > no_limit ? free.high : high};
    }
    [[nodiscard]] Pose motion() const {
        if (!moves()) return Pose::Zero;
        ignition::math::Vector3d axis;
        refuse_if_any(given->Axis(0)->ResolveXyz(axis));
        if (turns()) return Pose({0, 0, 0}, ignition::math::Quaterniond(axis, place));
        return Pose(place * axis, ignition::math::Quaterniond::Identity);
    }
};

/// A geometry: half extents; or a radius, and half a length; or a mesh file.
struct Shape {
    sdf::GeometryType type;
    SdfRecorder::Vector sizes{};
    std::string file{};

    [[nodiscard]] auto operator<=>(const Shape&) const = default;
};

class SdfModel {
  public:
    explicit SdfModel(const std::string& file) : folder_(std::filesystem::absolute(file).parent_path()) {
        for (const auto& folder : {folder_, folder_.parent_path()}) {
            sdf::addURIPath("model://", folder.string());
            sdf::addURIPath("package://", folder.string());
        }
        load(root_, file);
        if (root_.Model()) add_model(*root_.Model(), Pose::Zero, "", 0, root_.Model()->Static(), true);
        std::size_t model = 0;
        for (std::uint64_t w = 0; w < root_.WorldCount(); ++w) {
            const sdf::World& world = *root_.WorldByIndex(w);
            for (std::uint64_t i = 0; i < world.ModelCount(); ++i) {
                const sdf::Model& one = *world.ModelByIndex(i);
                const bool is_alone = world.ModelCount() == 1;
                add_model(one, Pose::Zero, "", model++, one.Static(), is_alone || one.SelfCollide());
            }
        }
    }

    void record(double seconds, double rate, double joint_speed) {
        refuse_loops();
        const double step = rate > 0 ? 1 / rate : 0.001;
        SdfRecorder recorder(std::cout, "libsdformat " SDF_VERSION_FULL, step);
        add_bodies(recorder);
        say_that_cylinders_are_prisms(cylinders_);
        if (bodies_ == 0) throw std::invalid_argument("no geometry of the model takes part in collisions");
        std::minstd_rand random;
        for (double time = 0; time < seconds - 1e-9; time += step) {
            place_links();
            std::vector<SdfRecorder::Pose> poses;
            for (const int link : numbered_) poses.push_back(recorded(at(link).now));
            recorder.step({.time = time, .poses = poses});
            for (Joint& joint : joints_)
                if (joint.moves() && joint_speed > 0)
                    move_joint(joint_speed * step, joint.range(), random, joint.place, joint.goal);
        }
    }

  private:
    [[nodiscard]] Link& at(int link) { return links_[static_cast<std::size_t>(link)]; }
    /// The joint that it hangs on, or none.
    [[nodiscard]] const Joint* joint_of(int link) {
        return at(link).joint < 0 ? nullptr : &joints_[static_cast<std::size_t>(at(link).joint)];
    }

    /// `names`: what the names of its links begin with, in the model on top.
    void add_model(const sdf::Model& model, const Pose& parent, const std::string& names, std::size_t top,
                   bool fixed, bool self_collide) {
        const Pose pose = parent * pose_of(model);
        for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
            const sdf::Link& link = *model.LinkByIndex(i);
            const Pose start = pose * pose_of(link);
            numbers_[{top, names + link.Name()}] = static_cast<int>(links_.size());
            links_.push_back({&link, start, start, top, fixed, self_collide});
        }
        for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
            const sdf::Model& nested = *model.ModelByIndex(i);
            add_model(nested, pose, names + nested.Name() + "::", top, fixed, self_collide);
        }
        for (std::uint64_t i = 0; i < model.JointCount(); ++i) {
            const sdf::Joint& joint = *model.JointByIndex(i);
            std::string parent_name, child_name;
            refuse_if_any(joint.ResolveParentLink(parent_name));
            refuse_if_any(joint.ResolveChildLink(child_name));
            Pose in_model;
            refuse_if_any(joint.SemanticPose().Resolve(in_model, "__model__"));
            const int child = numbers_.at({top, names + child_name});
            const int on = parent_name == "world" ? -1 : numbers_.at({top, names + parent_name});
            if (at(child).joint >= 0)
                throw std::invalid_argument("joint '" + joint.Name() + "': link '" + child_name +
                                            "' hangs on two joints, and only trees of links are moved");
            at(child).joint = static_cast<int>(joints_.size());
            joints_.push_back({&joint, on, child, pose * in_model});
        }
    }

    /// The link that moves with this one and is not welded to another.
    [[nodiscard]] int welded_to(int link) {
        while (const Joint* joint = joint_of(link)) {
            if (joint->given->Type() != sdf::JointType::FIXED) break;
            at(link).fixed |= joint->parent < 0;
            if (joint->parent < 0) break;
            link = joint->parent;
        }
        return link;
    }

    void refuse_loops() {
        for (int link = 0; link < static_cast<int>(links_.size()); ++link) {
            std::size_t joints = 0;
            for (int at_link = link; at_link >= 0 && joint_of(at_link); ++joints) {
                if (joints == links_.size())
                    throw std::invalid_argument(
                        "link '" + at(link).given->Name() +
                        "' hangs on a loop of joints, and only trees of links are moved");
                at_link = joint_of(at_link)->parent;
            }
        }
    }

    void add_bodies(SdfRecorder& recorder) {
        for (int link = 0; link < static_cast<int>(links_.size()); ++link)
            at(welded_to(link)).is_solid |= at(link).given->CollisionCount() > 0;
        for (int link = 0; link < static_cast<int>(links_.size()); ++link) {
            const int root = welded_to(link);
            for (std::uint64_t i = 0; i < at(link).given->CollisionCount(); ++i)
                add_body(*at(link).given->CollisionByIndex(i), link, root, recorder);
        }
        for (std::size_t a = 0; a < numbered_.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                if (at(numbered_[a]).model == at(numbered_[b]).model && !at(numbered_[a]).self_collide)
                    recorder.exclude(a, b);
    }

    void add_body(const sdf::Collision& collision, int link, int root, SdfRecorder& recorder) {
        SdfRecorder::Body body;
        if (const sdf::Surface* surface = collision.Surface(); surface && surface->Contact())
            body.group = body.mask = surface->Contact()->CollideBitmask();
        else
            body.group = body.mask = 0xffff;
        body.shape = number_of(shape_in(collision), recorder);
        if (const sdf::Mesh* mesh = collision.Geom()->MeshShape())
            body.scale = {mesh->Scale().X(), mesh->Scale().Y(), mesh->Scale().Z()};
        body.link = static_cast<std::size_t>(number_of(root));
        body.pose = recorded(at(root).start.Inverse() * at(link).start * pose_of(collision));
        body.fixed = at(root).fixed;
        const Joint* const joint = joint_of(root);
        const int parent = joint && joint->parent >= 0 ? welded_to(joint->parent) : -1;
        if (parent >= 0 && at(parent).is_solid) body.parent = number_of(parent);
        recorder.add_body(body);
        ++bodies_;
    }

    int number_of(int link) {
        if (at(link).number < 0) {
            at(link).number = static_cast<int>(numbered_.size());
            numbered_.push_back(link);
        }
        return at(link).number;
    }

    [[nodiscard]] Shape shape_in(const sdf::Collision& collision) const {
        const sdf::Geometry& geometry = *collision.Geom();
        switch (geometry.Type()) {
            case sdf::GeometryType::BOX: {
                const auto half = geometry.BoxShape()->Size() / 2;
                return {geometry.Type(), {half.X(), half.Y(), half.Z()}};
            }
            case sdf::GeometryType::SPHERE:
                return {geometry.Type(), {geometry.SphereShape()->Radius()}};
            case sdf::GeometryType::CAPSULE:
                return {geometry.Type(),
                        {geometry.CapsuleShape()->Radius(), geometry.CapsuleShape()->Length() / 2}};
            case sdf::GeometryType::CYLINDER:
                return {geometry.Type(),
                        {geometry.CylinderShape()->Radius(), geometry.CylinderShape()->Length() / 2}};
            case sdf::GeometryType::MESH:
                return {geometry.Type(), {}, file_of(*geometry.MeshShape())};
            case sdf::GeometryType::EMPTY:
                throw std::invalid_argument("collision '" + collision.Name() + "': SDF has no such geometry");
            default:
                return {geometry.Type()};
        }
    }

    /// Equal geometries share a shape.
    std::size_t number_of(const Shape& shape, SdfRecorder& recorder) {
        const auto [known, is_new] = shapes_.try_emplace(shape, 0);
        return is_new ? known->second = add(shape, recorder) : known->second;
    }
    std::size_t add(const Shape& shape, SdfRecorder& recorder) {
        const double x = shape.sizes[0], y = shape.sizes[1];
        switch (shape.type) {
            case sdf::GeometryType::BOX:
                return recorder.add_box(shape.sizes);
            case sdf::GeometryType::SPHERE:
                return recorder.add_sphere(x);
            case sdf::GeometryType::CAPSULE:
                return recorder.add_capsule(y, x);
            case sdf::GeometryType::CYLINDER:
                ++cylinders_;
                return recorder.add_hull(prism_around(x, y));
            case sdf::GeometryType::MESH:
                return recorder.add_mesh(shape.file);
            case sdf::GeometryType::PLANE:
                return recorder.add_other("plane");
            case sdf::GeometryType::ELLIPSOID:
                return recorder.add_other("ellipsoid");
            default:
                return recorder.add_other("height field");
        }
    }

    [[nodiscard]] std::string file_of(const sdf::Mesh& mesh) const {
        if (!mesh.Submesh().empty())
            throw std::invalid_argument("mesh " + mesh.Uri() + ": submesh '" + mesh.Submesh() +
                                        "' is not read: write a file with it alone");
        const auto beside = folder_ / mesh.Uri();
        if (std::filesystem::exists(beside)) return beside.string();
        const std::string found = sdf::findFile(mesh.Uri(), true, false);
        if (found.empty()) throw std::invalid_argument("mesh " + mesh.Uri() + ": no such file");
        return std::filesystem::absolute(found).string();
    }

    /// Where all links are now, by their joints.
    void place_links() {
        std::vector<bool> placed(links_.size(), false);
        for (int link = 0; link < static_cast<int>(links_.size()); ++link) place(link, placed);
    }
    void place(int link, std::vector<bool>& placed) {
        if (placed[static_cast<std::size_t>(link)]) return;
        placed[static_cast<std::size_t>(link)] = true;
        const Joint* const joint = joint_of(link);
        if (!joint) return;
        Pose moved;  // of the parent, from its start
        if (joint->parent >= 0) {
            place(joint->parent, placed);
            moved = at(joint->parent).now * at(joint->parent).start.Inverse();
        }
        at(link).now = moved * joint->start * joint->motion() * joint->start.Inverse() * at(link).start;
    }

    std::filesystem::path folder_;
    sdf::Root root_;
    std::vector<Link> links_;
    std::vector<Joint> joints_;
    std::map<std::pair<std::size_t, std::string>, int> numbers_;  ///< of links, by model and name
    std::vector<int> numbered_;                                   ///< solid links, by their numbers
    std::map<Shape, std::size_t> shapes_;
    int bodies_ = 0, cylinders_ = 0;
};

}  // namespace

int main(int count, char** words) try {
    if (count < 2) return std::fprintf(stderr, "usage: record_sdformat MODEL [SECONDS [RATE [JOINTS]]]\n"), 2;
    SdfModel(words[1]).record(count > 2 ? std::atof(words[2]) : 5, count > 3 ? std::atof(words[3]) : 60,
                              count > 4 ? std::atof(words[4]) : 1);
    return std::cout.flush() ? 0 : 1;
} catch (const std::exception& problem) {
    std::fprintf(stderr, "%s: %s\n", words[1], problem.what());
    return 2;
}
