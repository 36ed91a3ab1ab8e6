// SPDX-License-Identifier: MIT
//
// Lines, words and coordinates of mesh files that are text. A place is the number of a line, from 1.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/geometry/result.hpp"
#include "edgewise/geometry/vec.hpp"

namespace edgewise::scene {

/// The lines of a text that outlives this. LF, CR LF and CR each end a line; a byte order mark is left out.
class TextLines {
  public:
    explicit TextLines(std::string_view text);

    /// Moves to the next line; false at the end.
    bool next();
    [[nodiscard]] std::string_view line() const { return line_; }
    [[nodiscard]] std::size_t number() const { return number_; }
    [[nodiscard]] std::string_view rest() const { return rest_; }

  private:
    std::string_view rest_, line_;
    std::size_t number_ = 0;
};

/// Words between blanks and tabs.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view line);

/// A finite number in decimal that a body can have. The error quotes the word and has no place.
[[nodiscard]] Result<double> coordinate_from(std::string_view word);
/// Three of them.
[[nodiscard]] Result<Vec3d> point_from(std::string_view x, std::string_view y, std::string_view z);

/// What a reader throws at a line that it refuses.
struct MeshFault {
    std::size_t line;  ///< 0: of the whole file
    std::string what;

    /// ":LINE: what", or ": what" for the whole file.
    [[nodiscard]] std::string text() const {
        return line == 0 ? ": " + what : ":" + std::to_string(line) + ": " + what;
    }
};

}  // namespace edgewise::scene
