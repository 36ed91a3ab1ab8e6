// SPDX-License-Identifier: MIT
#include "function_spans.hpp"

#include <algorithm>
#include <regex>

namespace edgewise::house {

namespace {

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// One text of all lines, preprocessor lines blanked out.
std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        const auto first = line.find_first_not_of(' ');
        const bool directive = first != std::string::npos && line[first] == '#';
        text += (directive ? std::string(line.size(), ' ') : line) + "\n";
    }
    return text;
}

/// End of the comment or literal that begins at `at`; `at` itself when none does.
std::size_t end_of_blank(const std::string& text, std::size_t at) {
    const auto after = [&](const std::string& closing, std::size_t from) {
        const auto found = text.find(closing, from);
        return found == std::string::npos ? text.size() : found + closing.size();
    };
    if (text.compare(at, 2, "//") == 0) return after("\n", at) - 1;
    if (text.compare(at, 2, "/*") == 0) return after("*/", at + 2);
    if (text.compare(at, 2, "R\"") == 0) {
        const auto open = text.find('(', at);
        return after(")" + text.substr(at + 2, open - at - 2) + "\"", open);
    }
    const char quote = text[at];
    const bool between_digits = at > 0 && std::isxdigit(static_cast<unsigned char>(text[at - 1]));
    if (quote != '"' && (quote != '\'' || between_digits)) return at;
    std::size_t i = at + 1;
    while (i < text.size() && text[i] != quote) i += text[i] == '\\' ? 2 : 1;
    return std::min(i + 1, text.size());
}

enum class Brace { scope, type, body, value };

/// What stands before a brace decides what it opens.
Brace kind_of(const std::string& before) {
    static const std::regex is_scope(
        R"(^\s*(template\s*<[\s\S]*>\s*)?(inline\s+)?(namespace|class|struct|union|enum|extern)\b)");
    static const std::regex is_value(R"([=,({]\s*$|\bconcept\b)");
    if (before.empty() || !is_space(before.back()) || std::regex_search(before, is_value))
        return Brace::value;
    if (std::smatch what; std::regex_search(before, what, is_scope))
        return what[3] == "class" || what[3] == "struct" ? Brace::type : Brace::scope;
    if (before.find('(') == std::string::npos) return Brace::scope;
    return Brace::body;
}

class Scan {
  public:
    explicit Scan(const std::string& code) : code_(code) {}

    /// Of what such braces enclose.
    std::vector<Span> run(Brace wanted) {
        wanted_ = wanted;
        for (; at_ < code_.size(); ++at_) {
            step(code_[at_]);
            if (code_[at_] == '\n') ++line_;
        }
        return spans_;
    }

  private:
    void step(char c) {
        if (c == '{') open();
        if (c == '}') close();
        if (c == '(') ++parentheses_;
        if (c == ')') --parentheses_;
        const bool ends = c == ';' || (c == ':' && after_access_word());
        if (ends && between_declarations() && parentheses_ == 0) begin_statement();
    }

    [[nodiscard]] bool between_declarations() const {
        return open_.empty() || open_.back().kind == Brace::scope || open_.back().kind == Brace::type;
    }

    void open() {
        const Brace kind = between_declarations() && parentheses_ == 0
                               ? kind_of(code_.substr(statement_, at_ - statement_))
                               : Brace::value;
        open_.push_back({kind, line_of_statement()});
        if (between_declarations()) begin_statement();
    }

    /// After an initialiser's brace the statement goes on: `Name(int a) : a_{a} {`.
    void close() {
        if (open_.empty()) return;
        const Opened brace = open_.back();
        open_.pop_back();
        if (brace.kind == wanted_) spans_.push_back({brace.first, line_});
        if (brace.kind != Brace::value) begin_statement();
    }

    [[nodiscard]] bool after_access_word() const {
        for (const std::string word : {"public", "protected", "private"}) {
            if (at_ >= word.size() && code_.compare(at_ - word.size(), word.size(), word) == 0) return true;
        }
        return false;
    }

    void begin_statement() { statement_ = at_ + 1; }

    [[nodiscard]] std::size_t line_of_statement() const {
        const auto from = code_.begin() + static_cast<std::ptrdiff_t>(statement_);
        const auto begin = std::find_if_not(from, code_.end(), is_space);
        return 1 + static_cast<std::size_t>(std::count(code_.begin(), begin, '\n'));
    }

    const std::string& code_;
    struct Opened {
        Brace kind;
        std::size_t first;  ///< line of the statement
    };

    std::size_t at_ = 0, line_ = 1, statement_ = 0;
    int parentheses_ = 0;
    Brace wanted_ = Brace::body;
    std::vector<Opened> open_;
    std::vector<Span> spans_;
};

}  // namespace

std::string bare_code(const std::vector<std::string>& lines) {
    std::string text = joined(lines);
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t end = end_of_blank(text, i);
        std::replace_if(
            text.begin() + static_cast<std::ptrdiff_t>(i), text.begin() + static_cast<std::ptrdiff_t>(end),
            [](char c) { return c != '\n'; }, ' ');
        i = std::max(end, i + 1);
    }
    return text;
}

std::vector<Span> function_spans(const std::vector<std::string>& lines) {
    const std::string code = bare_code(lines);
    return Scan(code).run(Brace::body);
}

std::vector<Span> class_spans(const std::vector<std::string>& lines) {
    const std::string code = bare_code(lines);
    return Scan(code).run(Brace::type);
}

}  // namespace edgewise::house
