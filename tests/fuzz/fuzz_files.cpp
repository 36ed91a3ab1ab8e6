// SPDX-License-Identifier: MIT
//
// The fuzz target of what users write and hand over: which reader it feeds is the program's name, fuzz_scene,
// fuzz_plan, fuzz_machine, fuzz_cases, fuzz_lock, fuzz_mesh or fuzz_store. A reader may refuse with one line,
// by value or by std::exception; anything else is a find: a crash, a hang, memory without end, a line break.
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "edgewise/input/count.hpp"
#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/lock/layout_lock.hpp"
#include "edgewise/scene/case_file.hpp"
#include "edgewise/scene/mesh/mesh_header.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "edgewise/store/reader.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/sweep/plan.hpp"

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace edgewise {
namespace {

void check_line(const std::string& line) {
    if (line.find('\n') == std::string::npos && line.size() < 20'000) return;
    std::fprintf(stderr, "no single line: %s\n", line.c_str());
    std::abort();
}

void read_scene(const std::string& text) { check_line(scene::parse_scene_file("mine", text).error); }
void read_plan(const std::string& text) { static_cast<void>(sweep::parse_plan("mine.json", text)); }
void read_machine(const std::string& text) { static_cast<void>(measure::parse_cache_machine(text, "mine")); }
void read_lock(const std::string& text) { static_cast<void>(measure::parse_lock(text, "mine")); }

void read_cases(const std::string& text) {
    std::istringstream stream(text);
    scene::CaseReader reader(stream, "cases");
    while (const auto line = reader.next()) {
        check_line(line->error);
        if (!*line) continue;
        check_line(scene::body_from_case((**line).a).error);
        check_line(scene::body_from_case((**line).b).error);
    }
}

/// The header's check alone: no parser of others.
void read_mesh(const std::string& text) {
    for (const char* ending : {".ply", ".off", ".obj"})
        check_line(scene::mesh_header_error(ending, text, text.size()));
}

/// A store of some cells, as bytes; the file is used again.
std::string whole_store(const std::string& path) {
    {
        store::Store store(path);
        store.put_build({"build", "abc", "g++", "-O3", "Release", "{}"});
        for (int i = 0; i < 40; ++i) {
            store::CellRow cell;
            cell.hash = "cell-" + std::to_string(i);
            cell.status = "verified";
            const store::FigureRow figures[] = {{{"total_bytes_per_edge", 168.0, "B/edge"}, "bytes"}};
            store.put_cell("build", cell, figures);
        }
    }
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// A store with some bytes changed: four of the input say where, a fifth to what.
void read_store(const std::string& text) {
    static const std::string path = "/dev/shm/edgewise_fuzz_store_" + std::to_string(getpid()) + ".db";
    static const std::string whole = whole_store(path);
    std::string damaged = whole;
    for (std::size_t i = 0; i + 5 <= text.size(); i += 5) {
        std::uint32_t at = 0;
        std::memcpy(&at, text.data() + i, sizeof at);
        damaged[at % damaged.size()] = text[i + 4];
    }
    std::ofstream(path, std::ios::binary) << damaged;
    static_cast<void>(store::read_build(path));
}

using Reader = void (*)(const std::string& text);
Reader reader = nullptr;

}  // namespace
}  // namespace edgewise

int LLVMFuzzerInitialize(int* /*count*/, char*** arguments) {
    using namespace edgewise;
    static const std::map<std::string, Reader> readers = {
        {"scene", read_scene}, {"plan", read_plan}, {"machine", read_machine}, {"cases", read_cases},
        {"lock", read_lock},   {"mesh", read_mesh}, {"store", read_store}};
    const std::string name = (*arguments)[0];
    const auto found = readers.find(name.substr(name.rfind('_') + 1));
    if (found == readers.end()) std::abort();
    reader = found->second;
    return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        edgewise::reader(std::string(reinterpret_cast<const char*>(data), size));
    } catch (const std::exception& refusal) {
        edgewise::check_line(refusal.what());
    }
    return 0;
}
