// SPDX-License-Identifier: MIT
//
// The fuzz target of users' input. The program's name selects the reader: fuzz_scene, fuzz_plan and so on,
// see `readers` below. A reader may refuse input with one line, by value or by std::exception. A crash, a
// hang, unlimited memory, or a line break in the message is a failure.
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>

#include "edgewise/input/count.hpp"
#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/record/record.hpp"
#include "edgewise/measure/traces/trace_file.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/scene/case_file.hpp"
#include "edgewise/scene/dumps/dump.hpp"
#include "edgewise/scene/mesh/mesh_parts.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/sweep/axes.hpp"
#include "edgewise/sweep/plan.hpp"
#include "edgewise/sweep/shard.hpp"

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace edgewise {
namespace {

void check_line(const std::string& line) {
    if (line.find('\n') == std::string::npos && line.size() < 20'000) return;
    std::fprintf(stderr, "no single line: %s\n", line.c_str());
    std::abort();
}

template <class Read>
void refused_in_one_line(const Read& read) {
    try {
        read();
    } catch (const std::exception& refusal) {
        check_line(refusal.what());
    }
}

void read_scene(const std::string& text) { check_line(scene::parse_scene_file("mine", text).error); }
void read_plan(const std::string& text) { static_cast<void>(sweep::parse_plan("mine.json", text)); }
void read_machine(const std::string& text) { static_cast<void>(measure::parse_cache_machine(text, "mine")); }
void read_record(const std::string& text) { static_cast<void>(measure::parse_record(text, "mine")); }

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

void read_dump(const std::string& text) { check_line(scene::read_pasted(text, "pasted").error); }

void read_trace(const std::string& text) {
    std::istringstream first(text);
    const measure::TraceForm form = measure::form_of(first, "mine");
    std::istringstream stream(text);
    std::uint64_t bytes = 0;
    static_cast<void>(measure::read_trace(stream, "mine", {form, true},
                                          [&](const measure::FileAccess& access) { bytes += access.bytes; }));
}

/// Gives one short line, as a shell would, to each parser of an option's text.
void read_option(const std::string& text) {
    if (text.size() > 200 || text.find('\n') != std::string::npos) return;
    check_line(input::parse_count(text, input::queries_range).error);
    check_line(input::parse_number(text).error);
    check_line(sweep::parse_shard(text, [&](const char*) { return text.c_str(); }).error);
    refused_in_one_line([&] { static_cast<void>(sweep::parse_axes(text)); });
    refused_in_one_line([&] { static_cast<void>(measure::machine_of_sizes(text)); });
}

/// A drawing that is shown may only have these tags, without attributes that run or load anything.
void read_svg(const std::string& text) {
    const auto shown = reports::safe_svg(text);
    if (!shown) return;
    static const std::regex plain(
        R"re(</?(svg|g|rect|text|title|desc|line|circle|tspan)(\s*[a-zA-Z][a-zA-Z0-9-]*="[^"<>&\\]*")*\s*/?>)re"),
        active(R"re(\son\w+=|\shref=|url|script)re", std::regex::icase);
    for (std::size_t at = shown->find('<'); at != std::string::npos; at = shown->find('<', at + 1)) {
        const std::string tag = shown->substr(at, shown->find('>', at) - at + 1);
        if (std::regex_match(tag, plain) && !std::regex_search(tag, active)) continue;
        std::fprintf(stderr, "not plain: %s\n", tag.c_str());
        std::abort();
    }
    static_cast<void>(reports::slim_svg(*shown, text));
}

/// Our own readers, and our checks before Assimp; Assimp itself is not fuzzed.
void read_mesh(const std::string& text) {
    check_line(scene::obj_parts(text).error);
    check_line(scene::stl_parts(text).error);
    for (const char* ending : {".ply", ".off"}) {
        const std::string wrong = scene::mesh_header_error(ending, text, text.size());
        check_line(wrong);
        if (wrong.empty())
            check_line(std::string_view(ending) == ".ply" ? scene::ply_rows_error(text)
                                                          : scene::off_rows_error(text));
    }
}

/// Bytes of a store with some cells, written to this path.
std::string whole_store(const std::string& path) {
    {
        store::Store store(path);
        store.put_build({"build", "abc", "g++", "-O3", "Release", "{}"});
        for (int i = 0; i < 40; ++i) {
            store::CellRow cell;
            cell.hash = "cell-" + std::to_string(i);
            cell.status = store::CellStatus::verified;
            const store::FigureRow figures[] = {{{"total_bytes_per_edge", 168.0, "B/edge"}, "bytes"}};
            store.put_cell("build", cell, figures);
        }
    }
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// A store in memory, removed at the end of the process.
class StoreFile {
  public:
    ~StoreFile() {
        for (const char* ending : {"", "-wal", "-shm"}) std::filesystem::remove(path + ending);
    }
    const std::string path = "/dev/shm/edgewise_fuzz_store_" + std::to_string(getpid()) + ".db";
    const std::string whole = whole_store(path);
};

/// Reads a store with some bytes changed: four bytes of the input are the place, the fifth is the new value.
void read_store(const std::string& text) {
    static const StoreFile file;
    std::string damaged = file.whole;
    for (std::size_t i = 0; i + 5 <= text.size(); i += 5) {
        std::uint32_t at = 0;
        std::memcpy(&at, text.data() + i, sizeof at);
        damaged[at % damaged.size()] = text[i + 4];
    }
    std::ofstream(file.path, std::ios::binary) << damaged;
    static_cast<void>(store::read_build(file.path));
}

using Reader = void (*)(const std::string& text);
Reader reader = nullptr;

}  // namespace
}  // namespace edgewise

int LLVMFuzzerInitialize(int* /*count*/, char*** arguments) {
    using namespace edgewise;
    static const std::map<std::string, Reader> readers = {
        {"scene", read_scene},   {"plan", read_plan}, {"machine", read_machine}, {"cases", read_cases},
        {"record", read_record}, {"mesh", read_mesh}, {"store", read_store},     {"dump", read_dump},
        {"trace", read_trace},   {"svg", read_svg},   {"option", read_option}};
    const std::string name = (*arguments)[0];
    const auto found = readers.find(name.substr(name.rfind('_') + 1));
    if (found == readers.end()) std::abort();
    reader = found->second;
    return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    edgewise::refused_in_one_line(
        [&] { edgewise::reader(std::string(reinterpret_cast<const char*>(data), size)); });
    return 0;
}
