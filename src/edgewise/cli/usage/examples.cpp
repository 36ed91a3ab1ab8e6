// SPDX-License-Identifier: MIT
#include "edgewise/cli/usage/usage.hpp"

#include <fmt/format.h>

#include <map>
#include <string>

#include "edgewise/scene/case_text.hpp"

namespace edgewise::cli {

namespace {

struct Examples {
    const char *first, *second;
    const char* more = "";  ///< below them, as a case to paste
};

/// A case on one line, as `query` and `judge` read it.
const std::string example_case = fmt::format(
    "\nA case, one per line (faces, poses, R and t may be left out):\n  {}\n", scene::case_template);

const std::map<std::string, Examples> examples = {
    {"advise",
     {"advise --shape sphere386 --bodies 300 --own-tables --error 1e-6 --machines l2=256K",
      "advise --shape my_link.stl --bodies 50 --shared-tables"}},
    {"advise budget",
     {"advise budget --shape my_link.stl --tolerance 0.0001",
      "advise budget --shape sphere386 --vertices 64 --out small.obj"}},
    {"bench", {"bench model --queries 2000", "bench gate mine.json --write"}},
    {"bench calibrate", {"bench calibrate", "bench calibrate --json"}},
    {"bench crosscheck",
     {"bench crosscheck --table lean_f32", "bench crosscheck --table aos_f64 --machines l1=16K,l2=256K"}},
    {"bench effort",
     {"bench effort --layouts aos_f64,lean_f64", "bench effort --by-phase --scene cold --shape cube8"}},
    {"bench gate", {"bench gate mine.json --write", "bench gate mine.json"}},
    {"bench model", {"bench model --queries 2000", "bench model --scene cold --json"}},
    {"bench scaling",
     {"bench scaling --table lean_f64 --threads 2",
      "bench scaling --scene pressure --parameter bodies=2000"}},
    {"bytes", {"bytes --layouts aos_f64,lean_f64", "bytes --shape my_link.stl --layouts lean"}},
    {"caches",
     {"caches --table lean_f32 --scene pressure --queries 2000 --out lean.din",
      "caches --trace lean.din --machines zen5,l2=256K"}},
    {"campaign",
     {"campaign --pairs 1e7", "campaign --pairs 1e6 --families random --shape cube8 --layouts aos_f64"}},
    {"compare", {"compare old.db new.db --format markdown", "compare docs/records/zen3.json mine.json"}},
    {"draw", {"draw layout lean_f32 --svg lean.svg", "draw heat --table aos_f64 --queries 500"}},
    {"draw heat",
     {"draw heat --table aos_f64 --shape sphere386 --queries 500",
      "draw heat --table lean_f32 --svg lean_heat.svg"}},
    {"draw layout", {"draw layout lean_f32 > lean.svg", "draw layout aos_f64 --shape tetra4 --svg aos.svg"}},
    {"export",
     {"export --figures 'time.*' --out times.csv",
      "export mine.db --layouts lean_f32 --format callgrind --out lean.callgrind"}},
    {"fields", {"fields --table aos_f64 --scene tumble", "fields --table soa_f64 --algorithm gjk --json"}},
    {"judge",
     {"judge --template > pair.json", "judge --a link.obj --b cube8 --pose-b 0.5,0,0 --said fcl=0.02",
      example_case.c_str()}},
    {"list", {"list layouts", "list machines --json"}},
    {"lock", {"lock --table lean_f32 --queries 200 > lean.lock.json", "lock --check lean.lock.json"}},
    {"machine", {"machine", "machine --json"}},
    {"merge", {"merge 0.db 1.db 2.db --out all.db", "merge parts/0.db parts/1.db --out all.db --fom"}},
    {"paging", {"paging", "paging --bodies 200 --json"}},
    {"paging thrash", {"paging thrash", "paging thrash --json"}},
    {"query",
     {"query cases.jsonl --algorithm gjk --table aos_f64", "query - --needs certificate < cases.jsonl",
      example_case.c_str()}},
    {"record",
     {"record bullet-stack --out stack.jsonl.gz",
      "record 22_humanoids.xml --out humanoids.jsonl.gz --seconds 2"}},
    {"report", {"report", "report mine.db --out mine"}},
    {"report claims", {"report claims", "report claims mine.db --diff theirs.db"}},
    {"stability",
     {"stability --count 20 --layouts aos_f64", "stability --families slivers_and_needles --count 1000"}},
    {"sweep",
     {"sweep --shape my_link.stl --scenes tumble --layouts aos,lean",
      "sweep --scenes mine.json --caches all --machines l2=256K,l3=8M"}},
};

}  // namespace

std::string examples_of(const std::string& path) {
    const Examples& of = examples.at(path);
    return fmt::format("Examples:\n  edgewise {}\n  edgewise {}\n{}", of.first, of.second, of.more);
}

}  // namespace edgewise::cli
