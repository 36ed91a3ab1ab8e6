// SPDX-License-Identifier: MIT
#include "container_recipe.hpp"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

namespace edgewise::house {

namespace {

/// Adds faults with their place.
class Faults {
  public:
    explicit Faults(std::string file) : file_(std::move(file)) {}
    void add(std::size_t line, const std::string& what) { all_.push_back({file_, line, what}); }
    [[nodiscard]] std::vector<Violation> all() const { return all_; }

  private:
    std::string file_;
    std::vector<Violation> all_;
};

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

/// A file of the tree, a folder of it, or all of it.
bool is_there(const std::string& path, const std::vector<SourceFile>& tree) {
    return path == "." || std::any_of(tree.begin(), tree.end(), [&](const SourceFile& file) {
               return file.path == path || file.path.starts_with(path + "/");
           });
}

/// Scripts that a command or a list of strings names: words with a slash that are no options.
std::vector<std::string> scripts_in(const std::string& command) {
    std::vector<std::string> scripts;
    const std::regex word(R"([A-Za-z_][A-Za-z0-9_.]*(/[A-Za-z0-9_.]+)+)");
    for (std::sregex_iterator at(command.begin(), command.end(), word), end; at != end; ++at)
        if (!at->str().starts_with("build/")) scripts.push_back(at->str());
    return scripts;
}

void check_variables(const Instruction& one, std::set<std::string>& known, Faults& faults) {
    if (one.name == "ARG" || one.name == "ENV") known.insert(one.rest.substr(0, one.rest.find('=')));
    const std::regex variable(R"(\$\{?([A-Za-z_]+))");
    for (std::sregex_iterator at(one.rest.begin(), one.rest.end(), variable), end; at != end; ++at)
        if (!known.contains((*at)[1])) faults.add(one.line, "no ARG or ENV sets " + (*at)[1].str());
}

void check_files(const Instruction& one, const std::vector<SourceFile>& tree, Faults& faults) {
    std::vector<std::string> paths;
    if (one.name == "COPY") {
        paths = words_of(one.rest);
        paths.pop_back();
    }
    if (one.name == "RUN" || one.name == "ENTRYPOINT" || one.name == "CMD") paths = scripts_in(one.rest);
    for (const std::string& path : paths)
        if (!is_there(path, tree)) faults.add(one.line, "not in the tree: " + path);
    if (one.name == "RUN" && std::regex_search(one.rest, std::regex(R"(\b(apt|apt-get|dpkg|npm|pip)\b)")))
        faults.add(one.line, "packages are installed by cmake/set_up.sh alone");
}

/// What must be there once, and where.
void check_frame(const std::vector<Instruction>& all, Faults& faults) {
    const auto count = [&](const char* name) {
        return std::count_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    };
    if (count("FROM") != 1) faults.add(0, "one FROM is wanted");
    if (count("ENTRYPOINT") != 1) faults.add(0, "one ENTRYPOINT is wanted");
    const bool debian = std::any_of(all.begin(), all.end(), [](const Instruction& one) {
        return (one.name == "FROM" || one.name == "ARG") && one.rest.ends_with("/library/debian:bookworm");
    });
    if (!debian) faults.add(0, "the base is Debian 12");
    for (const Instruction& one : all) {
        if (one.name == "FROM") break;
        if (one.name != "ARG") faults.add(one.line, one.name + " before FROM");
    }
}

}  // namespace

std::vector<Instruction> instructions_of(const SourceFile& recipe) {
    std::vector<Instruction> all;
    bool continues = false;
    for (std::size_t i = 0; i < recipe.lines.size(); ++i) {
        std::string line = recipe.lines[i];
        if (line.starts_with("#") || (line.empty() && !continues)) continue;
        const bool goes_on = line.ends_with("\\");
        if (goes_on) line.pop_back();
        if (continues) {
            all.back().rest += " " + line;
        } else {
            const std::size_t space = std::min(line.find(' '), line.size());
            all.push_back({i + 1, line.substr(0, space), line.substr(std::min(space + 1, line.size()))});
        }
        continues = goes_on;
    }
    return all;
}

std::vector<Violation> recipe_faults(const SourceFile& recipe, const std::vector<SourceFile>& tree) {
    static const std::set<std::string> names = {"ARG",  "FROM", "WORKDIR",    "COPY",  "RUN",   "ENV",
                                                "USER", "CMD",  "ENTRYPOINT", "LABEL", "VOLUME"};
    Faults faults(recipe.path);
    std::set<std::string> variables;
    const std::vector<Instruction> all = instructions_of(recipe);
    check_frame(all, faults);
    for (const Instruction& one : all) {
        if (!names.contains(one.name)) faults.add(one.line, "no instruction of a recipe: " + one.name);
        if (one.rest.empty()) faults.add(one.line, one.name + " of nothing");
        check_variables(one, variables, faults);
        if (!one.rest.empty()) check_files(one, tree, faults);
    }
    return faults.all();
}

}  // namespace edgewise::house
