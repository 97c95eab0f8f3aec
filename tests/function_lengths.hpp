#pragma once
#include <cctype>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

/// How long the functions of a file of C++ are, as clang-format lays them out: from the line on which the head
/// begins to that of the closing brace, lambdas within them counted along.
namespace function_lengths {

struct Function {
  std::size_t line;    ///< where it begins
  std::size_t length;  ///< in lines, with its head
  std::size_t body;    ///< in lines, from the opening brace to the closing one
};

/// The text without comments, directives, and what stands in strings, line for line.
inline std::string code_alone(const std::string& text) {
  static const std::regex aside(
      R"raw(R"(\w*)\([\s\S]*?\)\1"|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+'|//[^\n]*|/\*[\s\S]*?\*/|^#[^\n]*)raw",
      std::regex::ECMAScript | std::regex::multiline);
  std::string code;
  auto rest = text.cbegin();
  for (std::sregex_iterator match(text.begin(), text.end(), aside), end; match != end; ++match) {
    code.append(rest, (*match)[0].first);
    const char blank = *(*match)[0].first == '/' || *(*match)[0].first == '#' ? ' ' : '_';
    for (auto c = (*match)[0].first; c != (*match)[0].second; ++c) code += *c == '\n' ? '\n' : blank;
    rest = (*match)[0].second;
  }
  return code.append(rest, text.cend());
}

enum class Brace { scope, function, other };

/// What a brace opens, from what stands before it since the last statement.
inline Brace opened_by(const std::string& head) {
  static const std::regex scope(
      R"(^\s*(template\s*<.*>\s*)?(inline\s+)?(namespace|class|struct|union|enum)\b[^(]*$)");
  static const std::regex requirement(R"(requires\s*(\([^)]*\))?\s*$)");
  if (std::regex_search(head, scope)) return Brace::scope;
  const std::size_t parameters = head.find('(');
  if (parameters == std::string::npos || !std::isspace(static_cast<unsigned char>(head.back())))
    return Brace::other;  // a list of initial values
  if (std::regex_search(head, requirement)) return Brace::other;
  const std::size_t value = head.find(" = ");
  const bool lambda = value != std::string::npos && head.find('[', value) != std::string::npos;
  return value < parameters && !lambda ? Brace::other : Brace::function;
}

inline std::vector<Function> of(const std::string& text) {
  struct Open {
    Brace brace;
    std::size_t line, opened;
  };
  std::vector<Function> functions;
  std::vector<Open> open;
  std::string head;
  std::size_t line = 1, head_line = 1,
              within = 0;  // how many functions are open: one holds all that is in it
  for (const char c : code_alone(text)) {
    if (c == '{') {
      const Brace brace = within ? Brace::other : opened_by(head);
      open.push_back({brace, head_line, line});
      within += brace == Brace::function;
      if (brace != Brace::other) head.clear();
    } else if (c == '}' && !open.empty()) {
      if (open.back().brace == Brace::function) {
        functions.push_back({open.back().line, line - open.back().line + 1, line - open.back().opened + 1});
        --within;
      }
      if (open.back().brace != Brace::other) head.clear();
      open.pop_back();
    } else if (c == ';' && (open.empty() || open.back().brace == Brace::scope)) {
      head.clear();
    } else if (!head.empty() || !std::isspace(static_cast<unsigned char>(c))) {
      if (head.empty()) head_line = line;
      head += c == '\n' ? ' ' : c;
    }
    line += c == '\n';
  }
  return functions;
}

}  // namespace function_lengths
