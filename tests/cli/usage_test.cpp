// SPDX-License-Identifier: MIT
//
// Errors before any work begins: exit code 2, one line on stderr that says what, where and what to
// do, and nothing on stdout. An unknown name's line lists the known ones.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <sstream>

#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using testing::HasSubstr;

struct Slip {
    std::string name;  ///< in what is said of a failure
    Arguments arguments;
    std::vector<std::string> mentioned;  ///< in the one line
};

/// Each of them, in a folder of files that are none of what is asked for.
void expect_refusals(const std::vector<Slip>& slips) {
    const Folder folder;
    folder.write("empty.stl", "");
    folder.write("garbage.stl", std::string(3000, '\x81'));
    folder.write("text.obj", "once upon a time\n");
    folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("not_a_store.db", "something else\n");
    folder.write("deep.json", R"({"note": )" + std::string(100'000, '['));
    ASSERT_EQ(mkfifo((folder / "pipe.obj").c_str(), 0600), 0);
    folder.write("plan.json", R"({"rounds": "many"})");
    folder.write("misspelt.json", R"({"shaps": ["cube8"]})");
    folder.write("tumble.json", R"({"scene": "tumble", "shapes": ["cube8"]})");
    folder.write("mesh.json", R"({"meshes": ["missing.stl"]})");
    folder.write("object.json", "{}");
    folder.write("cut.json", R"({"edgewise_record": "speed",)");
    folder.write("bad.din", "r 10 8\nr 18\n");
    for (const Slip& slip : slips) {
        SCOPED_TRACE(slip.name);
        const Outcome outcome = run(slip.arguments, folder);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
        EXPECT_LT(outcome.err.size(), 600u) << outcome.err;
        for (const std::string& word : slip.mentioned) EXPECT_THAT(outcome.err, HasSubstr(word));
    }
    EXPECT_EQ(text_of(folder / "not_a_store.db"), "something else\n");
}

const std::vector<Slip> unknown_names = {
    {"command", {"nope"}, {"nope", "bytes", "list", "machine", "query", "report", "sweep"}},
    {"no_command", {}, {"bytes", "list", "machine", "query", "report", "sweep"}},
    {"option", {"bytes", "--nope"}, {"--nope"}},
    {"list", {"list", "nope"}, {"nope", "layouts", "probes", "algorithms", "scenes", "shapes", "plans"}},
    {"layout_of_bytes", {"bytes", "--layouts", "nope"}, {"nope", "aos_f64", "points_soa", "lean"}},
    {"table_of_query", {"query", "x", "--table", "nope"}, {"nope", "aos_f64"}},
    {"layout_of_thrash", {"paging", "thrash", "--layouts", "nope"}, {"nope", "aos_f64"}},
    {"layout_of_sweep", {"sweep", "--layouts", "aos,nope"}, {"nope", "aos_f64"}},
    {"algorithm_of_query", {"query", "x", "--algorithm", "nope"}, {"nope", "vclip", "gjk"}},
    {"algorithm_of_sweep", {"sweep", "--algorithms", "nope"}, {"nope", "vclip", "gjk"}},
    {"needs", {"query", "x", "--needs", "nope"}, {"nope", "verdict", "distance", "witnesses", "features"}},
    {"needs_of_cell", {"bench", "model", "--needs", "nope"}, {"nope", "nearer", "verdict", "certificate"}},
    {"shape", {"bytes", "--shape", "nope"}, {"nope", "tetra4", "cube8", "sphere386"}},
    {"shape_of_sweep", {"sweep", "--shapes", "nope"}, {"nope", "tetra4"}},
    {"shape_of_caches",
     {"sweep", "--scenes", "static", "--shape", "cube8", "--caches", "nope"},
     {"nope", "tetra4"}},
    {"sphere", {"bytes", "--shape", "sphere7"}, {"sphere7", "sphere6", "sphere8"}},
    {"scene", {"sweep", "--scenes", "nope"}, {"nope", "static", "cold", "tumble"}},
    {"plan", {"sweep", "--plan", "nope"}, {"nope", "quick", "paper", "full"}},
    {"machine_of_sweep", {"sweep", "--caches", "all", "--machines", "zen17"}, {"zen17", "known:", "zen5"}},
    {"text_to_print", {"--print", "html"}, {"html", "options, man, bash"}},
    {"layout_to_draw", {"draw", "layout", "nonesuch"}, {"nonesuch", "lean"}},
    {"family_of_campaign", {"campaign", "--families", "easy"}, {"unknown family 'easy'"}},
    {"sphere_of_campaign", {"campaign", "--shapes", "sphere39"}, {"sphere"}},
    {"solver",
     {"query", "x", "--sub-distance", "volumes"},
     {"--sub-distance: unknown solver 'volumes'; known: cofactors, johnson"}},
};

/// A slip's line names what was probably meant.
const std::vector<Slip> near_names = {
    {"sweeep", {"sweeep"}, {"did you mean 'sweep'?"}},
    {"no_command_so_short", {"no"}, {"unknown command 'no'; known: ", "sweep"}},
    {"command_that_is_gone", {"progress", "mine.db"}, {"progress: gone; a sweep says"}},
    {"budget", {"budget", "--shape", "cube8"}, {"budget is now 'edgewise advise budget'"}},
    {"thrash", {"thrash", "--json"}, {"thrash is now 'edgewise paging thrash'"}},
    {"claims", {"claims", "mine.db"}, {"claims is now 'edgewise report claims'"}},
    {"heat", {"heat"}, {"heat is now 'edgewise draw heat'"}},
    {"crosscheck", {"crosscheck"}, {"crosscheck is now 'edgewise bench crosscheck'"}},
    {"effort", {"effort", "--by-phase"}, {"effort is now 'edgewise bench effort'"}},
    {"scaling", {"scaling", "--threads", "2"}, {"scaling is now 'edgewise bench scaling'"}},
    {"calibrate", {"calibrate"}, {"calibrate is now 'edgewise bench calibrate'"}},
    {"bench_gate", {"bench", "--gate", "x.json", "--write"}, {"now 'edgewise bench gate FILE'"}},
    {"option_of_sweep",
     {"sweep", "--layout", "aos"},
     {"unknown option '--layout'", "did you mean '--layouts'?"}},
    {"option_elsewhere", {"report", "--axes", "order=bfs"}, {"unknown option '--axes'", "option of sweep"}},
    {"store_as_option", {"report", "--store", "missing.db"}, {"missing.db", "sweep"}},
    {"option_before_a_nested_command", {"report", "--out", "x", "claims"}, {"--out", "option of report"}},
    {"further_word", {"report", "a.db", "b.db"}, {"takes no further argument 'b.db'"}},
    {"layout_in_capitals", {"bytes", "--layouts", "AoS"}, {"did you mean 'aos'?"}},
    {"shape_slip", {"bytes", "--shape", "sphere385"}, {"sphere385", "sphere386"}},
    {"scene_slip", {"sweep", "--scenes", "tumbel"}, {"did you mean 'tumble'?"}},
    {"plan_slip", {"sweep", "--plan", "qiuck"}, {"did you mean 'quick'?"}},
    {"list_slip", {"list", "layout"}, {"did you mean 'layouts'?"}},
    {"list_of_nothing", {"list"}, {"known: algorithms", "layouts"}},
    {"machine_slip", {"caches", "--machines", "zen55"}, {"did you mean 'zen5'?", "l2=256K"}},
    {"needs_slip", {"query", "x", "--needs", "distence"}, {"did you mean 'distance'?"}},
    {"draw_of_nothing", {"draw", "lean_f32"}, {"known: heat, layout"}},
};

const std::vector<Slip> bad_values = {
    {"several_tables", {"query", "x", "--layout", "aos"}, {"aos_f64"}},
    {"margin_of_nothing", {"query", "x", "--margin", "1"}, {"--margin", "--needs nearer or within"}},
    {"margin_of_a_cell", {"bench", "model", "--margin", "1"}, {"margin", "needs nearer or within"}},
    {"threads_beyond_cores",
     {"bench", "scaling", "--threads", "1000000"},
     {"--threads 1000000", "cores", "ask for 1"}},
    {"no_threads", {"bench", "scaling", "--threads", "0"}, {"--threads 0", "ask for 1"}},
    {"scaling_of_depths", {"bench", "scaling", "--needs", "depth"}, {"needs depth", "witnesses"}},
    {"scaling_of_vertices", {"bench", "scaling", "--table", "points_soa_f64"}, {"points_soa_f64", "vclip"}},
    {"two_tolerances",
     {"query", "x", "--needs", "nearer", "--contact-tolerance", "1"},
     {"--margin", "--contact-tolerance"}},
    {"no_rounds", {"sweep", "--rounds", "0"}, {"--rounds"}},
    {"negative_queries", {"sweep", "--queries", "-1"}, {"--queries '-1'", "queries, 1 to 100000000"}},
    {"stability_of_2_to_63", {"sweep", "--stability", "9223372036854775808"}, {"--stability", "10000000"}},
    {"no_proofs_given", {"stability", "--proofs", ""}, {"--proofs ''"}},
    {"turn_of_a_store",
     {"advise", "--store", "s.db", "--turn", "0.1"},
     {"--store answers from what was measured"}},
    {"paging_of_a_layout_that_does_not_serve",
     {"paging", "--layouts", "aos_f64,points_soa_f64", "--algorithm", "vclip"},
     {"points_soa_f64 does not serve vclip"}},
    {"thrash_of_a_layout_that_does_not_serve",
     {"paging", "thrash", "--layouts", "points_soa_f64"},
     {"points_soa_f64 does not serve vclip"}},
    {"limit_below_a_page", {"paging", "--limits", "1e-7"}, {"--limits 1e-07", "less than a page"}},
    {"effort_of_nothing",
     {"bench", "effort", "--layouts", "points_soa_f64", "--algorithms", "vclip"},
     {"none of these layouts serves any of these algorithms"}},
    {"shape_of_no_family",
     {"campaign", "--families", "grazing", "--shape", "none.stl"},
     {"--shape is of the family random"}},
    {"stability_shape_of_no_family",
     {"stability", "--families", "grazing", "--shape", "cube8"},
     {"--shape is of the family real_hulls_at_gaps"}},
    {"part_of_a_pair", {"campaign", "--pairs", "2.5"}, {"--pairs 2.5", "whole number"}},
    {"add_with_pairs", {"campaign", "--add", "a.json", "--pairs", "10"}, {"--add", "--pairs"}},
    {"pair_with_layouts", {"campaign", "--pair", "5", "--layouts", "aos"}, {"--pair", "--layouts"}},
    {"gap_tolerance_of_vclip", {"query", "x", "--gap-tolerance", "0.1"}, {"--gap-tolerance is GJK's"}},
    {"record_with_format",
     {"export", "s.db", "--machine-record", "--format", "csv"},
     {"--machine-record", "--format"}},
    {"callgrind_as_json", {"export", "s.db", "--format", "callgrind", "--json"}, {"--format", "--json"}},
    {"callgrind_with_figures",
     {"export", "s.db", "--format", "callgrind", "--figures", "time.*"},
     {"leave --figures out"}},
    {"header_as_json", {"lock", "--header", "--json"}, {"--header", "--json"}},
    {"header_with_limit", {"lock", "--header", "--limit", "bytes=16"}, {"--header", "--limit"}},
    {"limit_twice", {"lock", "--limit", "bytes=50%", "--limit", "bytes=20%"}, {"--limit bytes: given twice"}},
    {"costs_of_no_shard", {"sweep", "--costs", "old.db"}, {"--costs", "--shard"}},
    {"parameter_twice",
     {"bench", "model", "--parameter", "bodies=10", "--parameter", "bodies=20"},
     {"bodies=20", "given twice"}},
    {"shard_beyond_the_last", {"sweep", "--shard", "8/8"}, {"--shard 8/8", "0 to 7"}},
    {"two_bodies_for_one", {"bytes", "--shape", "cube8", "--mesh", "flat.obj"}, {"--shape"}},
    {"as_stored_of_no_file", {"bytes", "--shape", "cube8", "--as-stored"}, {"--as-stored", "mesh files"}},
    {"lock_as_stored_of_no_file", {"lock", "--shape", "cube8", "--as-stored"}, {"--as-stored"}},
    {"heat_as_stored_of_no_file", {"draw", "heat", "--as-stored"}, {"--as-stored", "mesh files"}},
    {"judge_as_stored_of_no_file",
     {"judge", "--a", "cube8", "--b", "tetra4", "--as-stored"},
     {"--as-stored", "mesh files"}},
    {"campaign_as_stored_of_no_file", {"campaign", "--as-stored"}, {"--as-stored", "mesh files"}},
    {"stability_as_stored_of_no_file", {"stability", "--as-stored"}, {"--as-stored", "mesh files"}},
    {"sweep_as_stored_of_no_file", {"sweep", "--as-stored"}, {"--as-stored", "mesh files"}},
    {"sweep_as_stored_of_a_built_in_scene",
     {"sweep", "--as-stored", "--scenes", "tumble"},
     {"--as-stored", "mesh files"}},
    {"bad_plan_file", {"sweep", "--plan", "plan.json"}, {"plan.json"}},
    {"misspelt_plan_member", {"sweep", "--plan", "misspelt.json"}, {"misspelt.json", "shaps", "shapes"}},
    {"missing_mesh_of_plan", {"sweep", "--plan", "mesh.json"}, {"missing.stl"}},
    {"each_of_no_mesh", {"sweep", "--each-mesh"}, {"--each-mesh", "--shape"}},
    {"machines_of_no_caches",
     {"sweep", "--shapes", "cube8", "--scenes", "cold", "--machines", "zen5"},
     {"--machines", "--caches all"}},
    {"level_without_size", {"caches", "--machines", "l2=large"}, {"l2=large", "l2=256K,l3=8M"}},
    {"folder_of_a_slip", {"sweep", "--store", "no/such/x.db"}, {"no/such", "there is no folder no"}},
    {"folder_of_a_slip_in_stability",
     {"stability", "--store", "no/such/x.db", "--layouts", "aos_f64"},
     {"there is no folder no"}},
    {"out_folder_of_a_slip", {"sweep", "--shapes", "cube8", "--out", "no/such"}, {"--out", "no/such"}},
    {"advice_on_one_body", {"advise", "--bodies", "1"}, {"--bodies '1'", "bodies, 2 to 10000"}},
    {"advice_on_two_shapes", {"advise", "--shape", "cube8", "--vertices", "8"}, {"--shape", "--vertices"}},
    {"advice_without_error", {"advise", "--error", "0"}, {"--error"}},
    {"advice_in_no_time",
     {"advise", "--time", "nan"},
     {"'nan' wants a decimal number of seconds, 5 to 3600"}},
    {"whole_gap", {"query", "x", "--gap-tolerance", "1"}, {"wants a decimal number, 0 to 0.999"}},
    {"negative_contact", {"query", "x", "--contact-tolerance", "-1"}, {"0 or more"}},
    {"limit_of_nan", {"paging", "--limits", "4,nan"}, {"--limits 'nan' wants a decimal number of MiB"}},
    {"thrash_of_one_body", {"paging", "thrash", "--bodies", "1"}, {"--bodies '1'"}},
    {"no_tolerance", {"advise", "budget", "--tolerance", "0"}, {"wants a decimal number, above 0"}},
    {"budget_of_three_vertices",
     {"advise", "budget", "--shape", "cube8", "--vertices", "3"},
     {"--vertices '3'"}},
    {"budget_without_a_limit",
     {"advise", "budget", "--shape", "cube8", "--out", "a.obj"},
     {"add --vertices or"}},
    {"folder_of_a_slip_in_budget",
     {"advise", "budget", "--shape", "cube8", "--vertices", "4", "--out", "no/such/a.obj"},
     {"no/such/a.obj"}},
    {"gate_of_no_file", {"bench", "gate", "--write"}, {"file"}},
    {"advice_at_once", {"advise", "--time", "1"}, {"--time"}},
    {"advice_on_nearness", {"advise", "--needs", "nearer"}, {"nearer", "distance"}},
    {"advice_on_no_machine", {"advise", "--machines", "zen55"}, {"did you mean 'zen5'?"}},
    {"advice_on_no_shape", {"advise", "--shape", "sphere385"}, {"sphere385", "sphere386"}},
    {"judge_of_a_word", {"judge", "text.obj", "--said", "fcl=0x1p3"}, {"--said fcl=0x1p3"}},
    {"folder_of_a_slip_in_merge", {"merge", "not_a_store.db", "--out", "no/such/x.db"}, {"--out", "no/such"}},
    {"folder_of_a_slip_in_campaign",
     {"campaign", "--pairs", "10", "--layouts", "aos_f64", "--state", "no/such/x.json"},
     {"--state", "there is no folder no"}},
    {"fields_of_few_rounds", {"fields", "--rounds", "8"}, {"--rounds '8'", "rounds, 9 to 1000"}},
    {"no_case_at_all", {"query", "-"}, {"-: no case in it", "--help"}},
    {"shard_of_campaign", {"campaign", "--shard", "9/8"}, {"count from 0 to 7"}},
    {"scene_of_gate", {"bench", "gate", "b.json", "--scene", "cold"}, {"--scene"}},
    {"slack_of_gate", {"bench", "gate", "b.json", "--slack", "-1"}, {"--slack"}},
    {"trace_beside_a_shape", {"caches", "--trace", "bad.din", "--shape", "cube8"}, {"--shape"}},
    {"fetches_of_no_trace", {"caches", "--fetches"}, {"--trace"}},
    {"folder_of_a_slip_in_caches",
     {"caches", "--shape", "cube8", "--write", "no/such/folder/t.din"},
     {"cannot be written"}},
    {"limit_below_0", {"lock", "--shape", "cube8", "--queries", "50", "--limit", "bytes=-1"}, {"limit"}},
    {"limit_of_nothing", {"lock", "--shape", "cube8", "--queries", "50", "--limit", "bite=5%"}, {"limit"}},
    {"format_of_compare", {"compare", "object.json", "object.json", "--format", "xml"}, {"--format"}},
    {"format_beside_json", {"compare", "object.json", "--json", "--format", "junit"}, {"--json"}},
    {"format_of_no_check", {"lock", "--format", "junit"}, {"--check"}},
};

const std::vector<Slip> bad_files = {
    {"missing_mesh", {"bytes", "--mesh", "missing.stl"}, {"missing.stl"}},
    {"missing_mesh_of_sweep", {"sweep", "--mesh", "missing.stl"}, {"missing.stl"}},
    {"empty_mesh", {"bytes", "--mesh", "empty.stl"}, {"empty.stl", "empty"}},
    {"garbage_mesh", {"bytes", "--mesh", "garbage.stl"}, {"garbage.stl"}},
    {"text_mesh", {"bytes", "--mesh", "text.obj"}, {"text.obj"}},
    {"flat_mesh", {"bytes", "--mesh", "flat.obj"}, {"flat.obj", "flat"}},
    {"folder_for_mesh", {"bytes", "--mesh", "."}, {"directory"}},
    {"missing_mesh_of_advice", {"advise", "--mesh", "missing.stl"}, {"missing.stl"}},
    {"no_scene_of_advice", {"advise", "--scene", "tumble"}, {"--scene tumble", "NAME.json"}},
    {"missing_baseline", {"bench", "gate", "none.json"}, {"none.json"}},
    {"baseline_cut_short", {"bench", "gate", "cut.json"}, {"cut.json", "--write"}},
    {"missing_progress", {"campaign", "--add", "nothing.json"}, {"nothing.json: no such file"}},
    {"no_progress",
     {"campaign", "--pairs", "10", "--layouts", "aos_f64", "--state", "object.json"},
     {"object.json: no progress of a campaign"}},
    {"missing_trace", {"caches", "--trace", "missing"}, {"missing: no such file"}},
    {"trace_of_no_accesses", {"caches", "--trace", "empty.stl"}, {"no accesses"}},
    {"line_of_no_trace", {"caches", "--trace", "bad.din"}, {"bad.din:2: 'r 18' wants", "SIZE"}},
    {"text_of_no_pair", {"judge", "text.obj"}, {"a case line of JSON, a message of FCL or Drake"}},
    {"no_machine_at_all", {"sweep", "--caches", "all", "--machines", "mesh.json"}, {"mesh.json", "machine"}},
    {"missing_cases", {"query", "missing.jsonl"}, {"missing.jsonl"}},
    {"folder_for_cases", {"query", "."}, {"directory"}},
    {"device_for_cases", {"query", "/dev/zero"}, {"/dev/zero", "no regular file", "standard input"}},
    {"device_for_mesh", {"bytes", "--mesh", "/dev/zero"}, {"/dev/zero", "no regular file"}},
    {"device_for_a_pair", {"judge", "/dev/zero"}, {"/dev/zero", "no regular file"}},
    {"device_for_bodies", {"judge", "--a", "/dev/zero", "--b", "text.obj"}, {"/dev/zero", "no regular file"}},
    {"pipe_for_bodies", {"judge", "--a", "pipe.obj", "--b", "pipe.obj"}, {"pipe.obj", "no regular file"}},
    {"device_for_records", {"compare", "/dev/zero"}, {"/dev/zero", "no regular file"}},
    {"device_for_groups", {"fields", "--groups", "/dev/zero"}, {"/dev/zero", "no regular file"}},
    {"device_for_a_campaign", {"campaign", "--add", "/dev/zero"}, {"/dev/zero", "no regular file"}},
    {"nested_groups", {"fields", "--groups", "deep.json"}, {"deep.json", "nested deeper"}},
    {"nested_record", {"compare", "deep.json"}, {"deep.json", "nested deeper", "edgewise_record"}},
    {"nested_machine", {"caches", "--machines", "deep.json"}, {"deep.json", "nested deeper"}},
    {"nested_plan", {"sweep", "--plan", "deep.json"}, {"deep.json", "nested deeper"}},
    {"device_for_plan", {"sweep", "--plan", "/dev/zero"}, {"/dev/zero", "no regular file"}},
    {"scene_file_called_as_a_kind", {"sweep", "--scenes", "tumble.json"}, {"tumble.json", "kind of scene"}},
    {"no_store", {"report", "missing.db"}, {"missing.db", "sweep"}},
    {"report_of_no_store", {"report", "not_a_store.db"}, {"not_a_store.db"}},
    {"export_of_missing_store", {"export", "missing.db"}, {"missing.db", "sweep"}},
    {"export_of_no_store", {"export", "not_a_store.db"}, {"not_a_store.db"}},
    {"export_as_what", {"export", "not_a_store.db", "--format", "parquet"}, {"--format", "csv", "json"}},
    {"claims_of_missing_store", {"report", "claims", "missing.db"}, {"missing.db", "sweep"}},
    {"claims_beside_missing_store",
     {"report", "claims", "missing.db", "--diff", "other.db"},
     {"missing.db", "sweep"}},
    {"claims_of_no_store", {"report", "claims", "not_a_store.db", "--json"}, {"not_a_store.db"}},
    {"sweep_into_no_store", {"sweep", "--store", "not_a_store.db", "--shapes", "cube8"}, {"not_a_store.db"}},
};

TEST(Usage, NamesTheKnownNames) { expect_refusals(unknown_names); }

TEST(Usage, NamesWhatWasProbablyMeant) { expect_refusals(near_names); }

TEST(Usage, RefusesBadValuesInOneLine) { expect_refusals(bad_values); }

TEST(Usage, RefusesBadFilesInOneLine) { expect_refusals(bad_files); }

TEST(Help, GoesToStdout) {
    const Folder folder;
    for (const Arguments& arguments : {Arguments{"--help"}, Arguments{"sweep", "--help"}}) {
        const Outcome outcome = run(arguments, folder);
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_EQ(outcome.err, "");
        EXPECT_THAT(outcome.out, HasSubstr("sweep"));
    }
}

/// Every --help ends with two lines that can be typed; of `query` with a case, too. They are read by the
/// program as a shell would hand them over.
TEST(Help, EndsWithTwoExamplesThatCanBeTyped) {
    const Folder folder;
    const std::vector<std::string> commands = listed_commands(folder);
    EXPECT_GE(commands.size(), 25U);
    for (const std::string& command : commands) {
        const std::string help = run(called(command, {"--help"}), folder).out;
        const std::size_t at = help.find("Examples:\n");
        ASSERT_NE(at, std::string::npos) << command;
        int examples = 0;
        for (const std::string& line : lines_of(help.substr(at))) {
            if (!line.starts_with("  edgewise ")) continue;
            ++examples;
            EXPECT_TRUE(line.starts_with("  edgewise " + command)) << line;
            Arguments words = {"--parse-only"};
            std::istringstream text(line.substr(11));
            for (std::string word; text >> word && word != ">" && word != "<";) {
                std::erase(word, '\'');
                words.push_back(word);
            }
            const Outcome outcome = run(words, folder);
            EXPECT_EQ(outcome.exit_code, 0) << line << ": " << outcome.err;
        }
        EXPECT_EQ(examples, 2) << command;
    }
}

TEST(Help, HidesWhatOnlyOtherCommandsCall) {
    const Folder folder;
    const Outcome outcome = run({}, folder);
    EXPECT_THAT(outcome.err, testing::Not(HasSubstr(" pass")));
    EXPECT_THAT(outcome.err, HasSubstr("draw"));
}

TEST(Usage, VersionRevisionAndCompilerAreOneLine) {
    const Outcome outcome = run({"--version"}, Folder());
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, testing::MatchesRegex("edgewise [0-9]+[.][0-9]+[.][0-9]+, revision .+, .+\n"));
    EXPECT_EQ(outcome.err, "");
}

/// A slip must not leave a store behind that the next command would take for a sweep's.
TEST(Usage, LeavesNothingBehind) {
    for (const Arguments& slip :
         {Arguments{"sweep", "--scenes", "nope"}, Arguments{"sweep", "--shapes", "nope"},
          Arguments{"sweep", "--layouts", "nope"}, Arguments{"sweep", "--plan", "nope"},
          Arguments{"sweep", "--store", "reports/such/x.db"},
          Arguments{"sweep", "--shapes", "cube8", "--out", "reports/such"}}) {
        const Folder folder;
        EXPECT_EQ(run(slip, folder).exit_code, 2);
        EXPECT_FALSE(std::filesystem::exists(folder / "reports")) << slip.back() << " after " << slip[1];
    }
}

}  // namespace
}  // namespace edgewise::cli_test
