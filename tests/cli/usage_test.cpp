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
    std::string name;  ///< of the test
    Arguments arguments;
    std::vector<std::string> mentioned;  ///< in the one line
};

void PrintTo(const Slip& slip, std::ostream* out) { *out << slip.name; }

class Usage : public testing::TestWithParam<Slip> {};

TEST_P(Usage, IsOneLineAndExitCodeTwo) {
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
    const Outcome outcome = run(GetParam().arguments, folder);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
    EXPECT_LT(outcome.err.size(), 600u) << outcome.err;
    for (const std::string& word : GetParam().mentioned) EXPECT_THAT(outcome.err, HasSubstr(word));
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
    {"words_for_threads", {"bench", "scaling", "--threads", "many"}, {"--threads", "many"}},
    {"scaling_of_depths", {"bench", "scaling", "--needs", "depth"}, {"needs depth", "witnesses"}},
    {"scaling_of_vertices", {"bench", "scaling", "--table", "points_soa_f64"}, {"points_soa_f64", "vclip"}},
    {"two_tolerances",
     {"query", "x", "--needs", "nearer", "--contact-tolerance", "1"},
     {"--margin", "--contact-tolerance"}},
    {"no_rounds", {"sweep", "--rounds", "0"}, {"--rounds"}},
    {"negative_queries", {"sweep", "--queries", "-1"}, {"--queries '-1'", "queries, 1 to 100000000"}},
    {"hexadecimal_queries", {"sweep", "--queries", "0x10"}, {"--queries '0x10'"}},
    {"blank_before_queries", {"bench", "model", "--queries", " 5"}, {"--queries ' 5'"}},
    {"sign_before_a_seed", {"sweep", "--seed", "+5"}, {"--seed '+5'"}},
    {"negative_stability", {"sweep", "--stability", "-1"}, {"--stability '-1'", "cases"}},
    {"stability_of_2_to_63", {"sweep", "--stability", "9223372036854775808"}, {"--stability", "10000000"}},
    {"stability_of_1e308", {"sweep", "--stability", "1e308"}, {"--stability '1e308'"}},
    {"no_proofs_given", {"stability", "--proofs", ""}, {"--proofs ''"}},
    {"negative_proofs", {"stability", "--proofs", "-1"}, {"--proofs '-1'"}},
    {"proofs_of_2_to_64", {"stability", "--proofs", "18446744073709551616"}, {"--proofs"}},
    {"parameter_in_hexadecimal",
     {"bench", "model", "--parameter", "bodies=0x10"},
     {"bodies=0x10", "NAME=NUMBER"}},
    {"turn_of_a_store",
     {"advise", "--store", "s.db", "--turn", "0.1"},
     {"--store answers from what was measured"}},
    {"paging_of_a_layout_that_does_not_serve",
     {"paging", "--layouts", "aos_f64,points_soa_f64", "--algorithm", "vclip"},
     {"points_soa_f64 does not serve vclip"}},
    {"parameter_twice",
     {"bench", "model", "--parameter", "bodies=10", "--parameter", "bodies=20"},
     {"bodies=20", "given twice"}},
    {"shard_beyond_the_last", {"sweep", "--shard", "8/8"}, {"--shard 8/8", "0 to 7"}},
    {"scaling_of_a_table_that_queries_write",
     {"bench", "scaling", "--table", "lazy_f64", "--algorithm", "vclip", "--shape", "cube8", "--queries",
      "50"},
     {"lazy_f64", "one thread at a time"}},
    {"words_for_numbers", {"sweep", "--queries", "many"}, {"--queries", "many"}},
    {"two_bodies_for_one", {"bytes", "--shape", "cube8", "--mesh", "flat.obj"}, {"--shape"}},
    {"as_stored_of_no_file", {"bytes", "--shape", "cube8", "--as-stored"}, {"--as-stored", "mesh files"}},
    {"lock_as_stored_of_no_file", {"lock", "--shape", "cube8", "--as-stored"}, {"--as-stored"}},
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
    {"advice_on_hexadecimal", {"advise", "--bodies", "0x10"}, {"--bodies '0x10'"}},
    {"advice_on_two_shapes", {"advise", "--shape", "cube8", "--vertices", "8"}, {"--shape", "--vertices"}},
    {"advice_on_an_endless_turn", {"advise", "--turn", "inf"}, {"inf"}},
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
    {"campaign_of_a_negative_seed", {"campaign", "--seed", "-1"}, {"--seed '-1'"}},
    {"fields_of_few_rounds", {"fields", "--rounds", "8"}, {"--rounds '8'", "rounds, 9 to 1000"}},
    {"no_case_at_all", {"query", "-"}, {"-: no case in it", "--help"}},
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

std::string name_of(const testing::TestParamInfo<Slip>& slip) { return slip.param.name; }

INSTANTIATE_TEST_SUITE_P(UnknownName, Usage, testing::ValuesIn(unknown_names), name_of);
INSTANTIATE_TEST_SUITE_P(NearName, Usage, testing::ValuesIn(near_names), name_of);
INSTANTIATE_TEST_SUITE_P(BadValue, Usage, testing::ValuesIn(bad_values), name_of);
INSTANTIATE_TEST_SUITE_P(BadFile, Usage, testing::ValuesIn(bad_files), name_of);

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

/// A slip must not leave a store behind that the next command would take for a sweep's.
TEST(Usage, VersionRevisionAndCompilerAreOneLine) {
    const Outcome outcome = run({"--version"}, Folder());
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, testing::MatchesRegex("edgewise [0-9]+[.][0-9]+[.][0-9]+, revision .+, .+\n"));
    EXPECT_EQ(outcome.err, "");
}

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
