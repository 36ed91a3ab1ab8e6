// SPDX-License-Identifier: MIT
//
// The work of a sweep and how far it came, kept in the store while it runs: a report then knows one that
// was stopped, and how many of its cells are missing.
#pragma once

#include <array>
#include <ctime>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/store/store.hpp"

namespace edgewise::cli {

class RunNote {
  public:
    /// `command`: as it would be typed again; `cells`: those of its plan.
    RunNote(store::Store& store, std::string command, std::size_t cells)
        : store_(store), command_(std::move(command)) {
        store_.set_meta(store::command_key + command_, bench::this_build().id);
        note_ = {{"build", bench::this_build().id},
                 {"cells", cells},
                 {"done", 0},
                 {"started", utc_time()},
                 {"ended", nullptr}};
        keep();
    }
    void add_done(std::size_t cells) {
        note_["done"] = note_["done"].get<std::size_t>() + cells;
        keep();
    }
    /// All of it is done, with what follows the cells.
    void end() {
        note_["ended"] = utc_time();
        keep();
    }

  private:
    /// Now, as "2026-01-31T23:59:59Z" (ISO 8601, UTC).
    static std::string utc_time() {
        const std::time_t now = std::time(nullptr);
        std::tm parts{};
        ::gmtime_r(&now, &parts);
        std::array<char, 32> text{};
        const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
        return {text.data(), length};
    }
    void keep() { store_.set_meta(store::run_key + command_, note_.dump()); }

    store::Store& store_;
    std::string command_;
    nlohmann::json note_;
};

}  // namespace edgewise::cli
