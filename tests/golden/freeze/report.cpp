// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "edgewise/reports/page/report.hpp"
#include "frozen.hpp"

namespace edgewise::golden {

namespace {

using nlohmann::json;

/// Data of this name that the page carries for its scripts: JSON, by gzip and in base64.
json packed(const std::string& page, const std::string& name) {
    const std::string mark = "id=\"packed-" + name + "\">";
    const std::size_t at = page.find(mark) + mark.size();
    const cli_test::Folder folder;
    folder.write("packed", page.substr(at, page.find('<', at) - at));
    return json::parse(
        cli_test::Process("/bin/sh", {"-c", "base64 -di packed | gzip -dc"}, folder).wait().out);
}

/// Replaces each stretch from `open` to the end of `close` by its hash.
void hash_stretches(std::string& text, const std::string& open, const std::string& close) {
    for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
        const std::size_t end = text.find(close, at) + close.size();
        const std::string hash = hash_of(text.substr(at, end - at));
        text.replace(at, end - at, "[" + hash + "]");
    }
}

/// Visible words of HTML: its lines without tags; "|" before each cell of a table; no blank lines.
std::string words_of(std::string html) {
    hash_stretches(html, "<svg", "</svg>");
    hash_stretches(html, "<script", "</script>");
    std::string words, line;
    bool in_tag = false;
    for (std::size_t i = 0; i < html.size(); ++i) {
        const char c = html[i];
        if (c == '<') {
            in_tag = true;
            if (html.compare(i, 3, "<td") == 0 || html.compare(i, 3, "<th") == 0) line += "| ";
        } else if (c == '\n') {
            if (line.find_first_not_of(" |") != std::string::npos) words += line + "\n";
            line.clear();
        } else if (!in_tag) {
            line += c;
        }
        in_tag = in_tag && c != '>';
    }
    return words + line;
}

/// The page's words, from its title to its data.
std::string words_of_page(const std::string& page) {
    const std::size_t from = page.find("<h1"), to = page.find("<script type=\"text/plain\"");
    return words_of(page.substr(from, to - from)) + "\n";
}

/// A folded table of the page: caption, columns and rows; a long table has its number of rows and a hash.
std::string lines_of_grid(const json& grid) {
    constexpr std::size_t longest = 40;
    std::string lines = fmt::format("== {}\n", grid["caption"].get<std::string>());
    for (const json& column : grid["columns"]) lines += fmt::format("{} | ", column[0].get<std::string>());
    const json& columns = grid["cells"];
    const std::size_t rows = columns.empty() ? 0 : columns[0].size();
    std::string body;
    for (std::size_t row = 0; row < rows; ++row) {
        for (const json& column : columns)
            body += (column[row].is_string() ? column[row].get<std::string>() : column[row].dump()) + " | ";
        body += '\n';
    }
    lines += rows > longest ? fmt::format("\n{} rows {}\n", rows, hash_of(body)) : "\n" + body;
    return lines;
}

/// The answers with their HTML in one piece, as the page's script shows them.
json whole_answers(const json& data) {
    json answers = data["answers"];
    for (json& answer : answers) {
        std::string html;
        for (const std::size_t line : answer["html"]) html += data["lines"][line].get<std::string>() + "\n";
        answer["html"] = html;
    }
    return answers;
}

/// One hash per member of the page's other data, because some members are long HTML.
std::string hashes_of(const std::string& page) {
    std::string lines;
    for (const char* name : {"answers", "maps", "cells", "bodies", "folds"}) {
        json data = packed(page, name);
        if (name == std::string("answers")) data = whole_answers(data);
        for (const auto& [key, value] : data.items())
            lines += fmt::format("{} {} {}\n", name, key, hash_of(value.dump()));
    }
    return lines;
}

/// One hash per file next to the two pages: specifications of charts, pictures, tables of figures.
std::string files_below(const std::filesystem::path& report) {
    std::vector<std::string> lines;
    for (const auto& file : std::filesystem::recursive_directory_iterator(report)) {
        const std::string name = std::filesystem::relative(file.path(), report);
        if (!file.is_regular_file() || name == "index.html" || name == "report.md") continue;
        lines.push_back(fmt::format("{} {}\n", name, hash_of(cli_test::text_of(file.path()))));
    }
    std::sort(lines.begin(), lines.end());
    return fmt::format("{}", fmt::join(lines, ""));
}

std::string without_blank_lines(const std::string& text) {
    std::string kept;
    for (const std::string& line : cli_test::lines_of(text))
        if (!line.empty()) kept += line + "\n";
    return kept;
}

}  // namespace

void add_report(Texts& texts) {
    const cli_test::Folder folder;
    const std::filesystem::path report = folder / "report";
    // Without the bundles of the chart engine, which not every machine has.
    static_cast<void>(reports::write_report(make_golden_store(folder), report, ""));
    const std::string page = cli_test::text_of(report / "index.html");
    std::string grids;
    for (const json& grid : packed(page, "grids")) grids += lines_of_grid(grid);
    texts["report_md.txt"] = without_blank_lines(cli_test::text_of(report / "report.md"));
    texts["report_page.txt"] = words_of_page(page);
    texts["report_tables.txt"] = grids;
    texts["report_data.txt"] = hashes_of(page) + files_below(report);
}

}  // namespace edgewise::golden
