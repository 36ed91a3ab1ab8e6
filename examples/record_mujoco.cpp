// SPDX-License-Identifier: MIT
//
// Records MuJoCo: an MJCF model with random controls, the actuators redrawn ten times a second; or a robot,
// MJCF or URDF, with joints that move at a constant speed between random places within their limits, without
// dynamics. Positions are those of the step that MuJoCo is about to take (after mj_step1), as are contacts.
// It does not expose the pairs of its broad phase, so the reader finds pairs by the model's own rules: bits,
// links, parents, excluded bodies. Vertices of a mesh lie in the frame that MuJoCo gave the mesh when it
// compiled the model; the geom's position is in that frame. A cylinder becomes a prism around it.
//
// record_mujoco MODEL [SECONDS [RATE [JOINTS]]]: `edgewise record` calls it. At rate 0 every step is
// recorded. JOINTS: their speed in rad/s, or in lengths per second; 0: dynamics.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <edgewise/record.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "robot_parts.hpp"

namespace {

using MujocoRecorder = edgewise::Recorder<double>;

constexpr const char* samples = "/usr/share/mujoco/model";  ///< of Debian's libmujoco-samples
constexpr double seconds_of_a_control = 0.1;

/// The file, or the sample of that name.
std::string file_of(const std::string& model) {
    std::error_code error;
    if (std::filesystem::exists(model, error)) return model;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(samples, error))
        if (entry.path().filename() == model) return entry.path().string();
    throw std::invalid_argument("no such file, nor a model of Debian's libmujoco-samples");
}

/// Position and quaternion; the quaternion is w x y z in MuJoCo too.
MujocoRecorder::Pose pose_of(const mjtNum* position, const mjtNum* quaternion) {
    MujocoRecorder::Pose pose{};
    std::copy_n(position, 3, pose.begin());
    std::copy_n(quaternion, 4, pose.begin() + 3);
    return pose;
}

class MujocoModel {
  public:
    explicit MujocoModel(const std::string& file) {
        // MuJoCo would end the program, or write a file of warnings into the working folder.
        mju_user_error = [](const char* text) { throw std::runtime_error(text); };
        mju_user_warning = [](const char*) {};
        std::array<char, 1000> error{};
        model_.reset(mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
        if (!model_) throw std::invalid_argument(std::string("MuJoCo: ") + error.data());
        std::ostringstream text;
        text << std::ifstream(file).rdbuf();
        has_mimics_ = text.str().find("<mimic") != std::string::npos;  // of URDF; MuJoCo ignores them
        data_.reset(mj_makeData(model_.get()));
        mj_forward(model_.get(), data_.get());
    }

    void record(double seconds, double rate, double joint_speed) {
        MujocoRecorder recorder(std::cout, std::string("MuJoCo ") + mj_versionString(), model_->opt.timestep);
        add_bodies(recorder);
        say_that_cylinders_are_prisms(cylinders_);
        say_what_is_not_followed(joint_speed > 0);
        if (bodies_.empty()) throw std::invalid_argument("no geometry of the model takes part in collisions");
        joint_speed > 0 ? record_joints(seconds, rate, joint_speed, recorder)
                        : record_dynamics(seconds, rate, recorder);
    }

  private:
    void record_dynamics(double seconds, double rate, MujocoRecorder& recorder) {
        double next_control = 0, next_step = 0;
        while (data_->time < seconds - 1e-9) {
            if (data_->time >= next_control) {
                draw_controls();
                next_control += seconds_of_a_control;
            }
            mj_step1(model_.get(), data_.get());
            refuse_if_unstable();
            if (data_->time >= next_step - 1e-9) {
                write_step(recorder);
                if (rate > 0) next_step += 1 / rate;
            }
            mj_step2(model_.get(), data_.get());
            refuse_if_unstable();
        }
    }

    /// MuJoCo sets an unstable simulation back to its start, and time with it.
    void refuse_if_unstable() const {
        for (const int warning : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
            if (data_->warning[warning].number > 0)
                throw std::runtime_error(
                    "the simulation became unstable: give the model a smaller timestep, or softer springs");
    }

    void record_joints(double seconds, double rate, double speed, MujocoRecorder& recorder) {
        const double step = rate > 0 ? 1 / rate : model_->opt.timestep;
        std::vector<double> goals(data_->qpos, data_->qpos + model_->nq);
        for (; data_->time < seconds - 1e-9; data_->time += step) {
            mj_forward(model_.get(), data_.get());
            write_step(recorder);
            for (int joint = 0; joint < model_->njnt; ++joint) move(joint, speed * step, goals);
        }
    }

    /// Moves a hinge or a slide; others stay.
    void move(int joint, double way, std::vector<double>& goals) {
        const int type = model_->jnt_type[joint], at = model_->jnt_qposadr[joint];
        if (type != mjJNT_HINGE && type != mjJNT_SLIDE) return;
        const mjtNum* const limits = model_->jnt_range + 2 * joint;
        const JointRange range = model_->jnt_limited[joint] != 0 ? JointRange{limits[0], limits[1]}
                                 : type == mjJNT_HINGE           ? free_turn
                                                                 : free_slide;
        move_joint(way, range, random_, data_->qpos[at], goals[static_cast<std::size_t>(at)]);
    }

    void add_bodies(MujocoRecorder& recorder) {
        const bool parents_collide = (model_->opt.disableflags & mjDSBL_FILTERPARENT) != 0;
        for (int geom = 0; geom < model_->ngeom; ++geom) {
            MujocoRecorder::Body body;
            body.group = static_cast<std::uint32_t>(model_->geom_contype[geom]);
            body.mask = static_cast<std::uint32_t>(model_->geom_conaffinity[geom]);
            if (body.group == 0 && body.mask == 0) continue;  // for the eye alone
            const int link = model_->body_weldid[model_->geom_bodyid[geom]];
            const int parent = model_->body_weldid[model_->body_parentid[link]];
            body.shape = shape_of(geom, recorder);
            body.link = static_cast<std::size_t>(link);
            body.pose = pose_in_link(geom, link);
            body.fixed = link == 0;
            if (link != 0 && parent != 0 && !parents_collide) body.parent = parent;  // the world is no parent
            bodies_[geom] = recorder.add_body(body);
            links_ = std::max(links_, link + 1);
        }
        constexpr int bits = 16;
        for (int i = 0; i < model_->nexclude; ++i) {
            const int a = model_->exclude_signature[i] >> bits, b = model_->exclude_signature[i] & 0xffff;
            const int link_a = model_->body_weldid[a - 1], link_b = model_->body_weldid[b - 1];
            if (link_a < links_ && link_b < links_)
                recorder.exclude(static_cast<std::size_t>(link_a), static_cast<std::size_t>(link_b));
        }
    }

    /// Says which rules of the model the recording does not follow.
    void say_what_is_not_followed(bool moves_joints) const {
        if (model_->npair > 0)
            std::cerr
                << "predefined pairs are left out: contype and conaffinity say which geometries are pairs\n";
        const auto led = std::count(model_->eq_type, model_->eq_type + model_->neq, mjEQ_JOINT);
        if (has_mimics_ || (moves_joints && led > 0))
            std::cerr << "joints that should follow others move by themselves\n";
    }

    /// Equal geoms share a shape.
    std::size_t shape_of(int geom, MujocoRecorder& recorder) {
        const mjtNum* size = model_->geom_size + 3 * geom;
        const int type = model_->geom_type[geom], mesh = model_->geom_dataid[geom];
        const auto [known, is_new] =
            shapes_.try_emplace({double(type), double(mesh), size[0], size[1], size[2]}, 0);
        if (!is_new) return known->second;
        std::size_t& shape = known->second;
        switch (type) {
            case mjGEOM_SPHERE:
                return shape = recorder.add_sphere(size[0]);
            case mjGEOM_CAPSULE:
                return shape = recorder.add_capsule(size[1], size[0]);
            case mjGEOM_BOX:
                return shape = recorder.add_box({size[0], size[1], size[2]});
            case mjGEOM_MESH:
                break;
            case mjGEOM_PLANE:
                return shape = recorder.add_other("plane");
            case mjGEOM_CYLINDER:
                ++cylinders_;
                return shape = recorder.add_hull(prism_around(size[0], size[1]));
            case mjGEOM_ELLIPSOID:
                return shape = recorder.add_other("ellipsoid");
            default:
                return shape = recorder.add_other("height field");
        }
        std::vector<MujocoRecorder::Vector> vertices;
        const float* v = model_->mesh_vert + 3 * model_->mesh_vertadr[mesh];
        for (int i = 0; i < model_->mesh_vertnum[mesh]; ++i, v += 3) vertices.push_back({v[0], v[1], v[2]});
        return shape = recorder.add_hull(vertices);
    }

    /// What is welded to a link never moves in it.
    [[nodiscard]] MujocoRecorder::Pose pose_in_link(int geom, int link) const {
        std::array<mjtNum, 4> of_geom{}, back{}, turn{};
        std::array<mjtNum, 3> offset{}, place{};
        mju_mat2Quat(of_geom.data(), data_->geom_xmat + 9 * geom);
        mju_negQuat(back.data(), data_->xquat + 4 * link);
        mju_mulQuat(turn.data(), back.data(), of_geom.data());
        mju_sub3(offset.data(), data_->geom_xpos + 3 * geom, data_->xpos + 3 * link);
        mju_rotVecQuat(place.data(), offset.data(), back.data());
        return pose_of(place.data(), turn.data());
    }

    void draw_controls() {
        for (int i = 0; i < model_->nu; ++i) {
            const mjtNum* range = model_->actuator_ctrlrange + 2 * i;
            const bool limited = model_->actuator_ctrllimited[i] != 0;
            const double low = limited ? range[0] : -1, high = limited ? range[1] : 1;
            data_->ctrl[i] = std::uniform_real_distribution<double>(low, high)(random_);
        }
    }

    void write_step(MujocoRecorder& recorder) const {
        std::vector<MujocoRecorder::Pose> poses;
        for (int link = 0; link < links_; ++link)
            poses.push_back(pose_of(data_->xpos + 3 * link, data_->xquat + 4 * link));
        std::vector<MujocoRecorder::Contact> contacts;
        for (int i = 0; i < data_->ncon; ++i) {
            const mjContact& contact = data_->contact[i];
            const auto a = bodies_.find(contact.geom1), b = bodies_.find(contact.geom2);
            if (a != bodies_.end() && b != bodies_.end())  // else of a predefined pair
                contacts.push_back({a->second, b->second, contact.dist});
        }
        recorder.step({.time = data_->time, .poses = poses, .contacts = contacts});
    }

    struct Delete {
        void operator()(mjModel* model) const { mj_deleteModel(model); }
        void operator()(mjData* data) const { mj_deleteData(data); }
    };
    std::unique_ptr<mjModel, Delete> model_;
    std::unique_ptr<mjData, Delete> data_;
    std::map<std::array<double, 5>, std::size_t> shapes_;
    std::map<int, std::size_t> bodies_;  ///< by geom
    int links_ = 0;                      ///< up to the last that has a geom
    int cylinders_ = 0;                  ///< different ones
    bool has_mimics_ = false;
    std::minstd_rand random_;
};

}  // namespace

int main(int count, char** words) try {
    if (count < 2) return std::fprintf(stderr, "usage: record_mujoco MODEL [SECONDS [RATE [JOINTS]]]\n"), 2;
    MujocoModel(file_of(words[1]))
        .record(count > 2 ? std::atof(words[2]) : 5, count > 3 ? std::atof(words[3]) : 60,
                count > 4 ? std::atof(words[4]) : 0);
    return std::cout.flush() ? 0 : 1;
} catch (const std::exception& problem) {
    std::fprintf(stderr, "%s: %s\n", words[1], problem.what());
    return 2;
}
