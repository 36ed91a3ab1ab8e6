// SPDX-License-Identifier: MIT
//
// Writes the corpus as seeds for the fuzz targets, and their names as libFuzzer's -seed_inputs needs them:
// seeds FOLDER CASES.jsonl... (libFuzzer would write its findings into a folder of seeds, and the next run
// would be another.)
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "pair_bytes.hpp"

int main(int count, char** arguments) {
    const std::filesystem::path folder = count > 1 ? arguments[1] : "";
    std::filesystem::create_directories(folder);
    std::ofstream list(folder / "list");
    int written = 0;
    for (int i = 2; i < count; ++i) {
        std::ifstream stream(arguments[i]);
        edgewise::scene::CaseReader reader(stream, arguments[i]);
        while (const auto line = reader.next()) {
            const auto bytes = *line ? edgewise::bytes_from_pair(**line) : std::nullopt;
            if (!bytes) continue;
            const auto file = folder / std::to_string(written);
            list << (written++ > 0 ? "," : "") << file.string();
            std::ofstream seed(file, std::ios::binary);
            seed.write(reinterpret_cast<const char*>(bytes->data()),
                       static_cast<std::streamsize>(bytes->size()));
        }
    }
    std::printf("%d seeds\n", written);
    return written > 0 ? 0 : 1;
}
