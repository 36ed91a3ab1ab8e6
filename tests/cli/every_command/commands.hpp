// SPDX-License-Identifier: MIT
//
// Every command of the program with cheap arguments.
#pragma once

#include <cstdlib>
#include <map>
#include <string>

#include "program.hpp"

namespace edgewise::cli_test {

/// Makes a store (s.db), a machine record (r.json) and a case file (c.jsonl), as the arguments name them.
void fill(const Folder& folder);

/// Cheap arguments with which a command prints something.
[[nodiscard]] const std::map<std::string, Arguments>& printing();

/// While it lives, commands find no Valgrind, which takes its time: they say so, and print the rest.
class NoOtherPrograms {
  public:
    NoOtherPrograms() { setenv("PATH", "/nowhere", 1); }
    ~NoOtherPrograms() { setenv("PATH", before_.c_str(), 1); }
    NoOtherPrograms(const NoOtherPrograms&) = delete;
    NoOtherPrograms& operator=(const NoOtherPrograms&) = delete;

  private:
    std::string before_ = std::getenv("PATH");
};

}  // namespace edgewise::cli_test
