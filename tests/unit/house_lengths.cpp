// No file and no function is too long to be read in one go.
#include <algorithm>
#include <filesystem>

#include "catch.hpp"
#include "first_contact/files/input.hpp"
#include "function_lengths.hpp"
#include "places.hpp"

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_file = 300, longest_function = 40, middle_of_library = 4;

/// All files of C++ below a folder of the project.
std::vector<fs::path> code_in(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(first_contact::places::source) / folder))
    if (const auto ending = entry.path().extension(); ending == ".cpp" || ending == ".hpp")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::size_t> lengths_in(const std::string& text) {
  std::vector<std::size_t> lengths;
  for (const auto& function : function_lengths::of(text)) lengths.push_back(function.length);
  return lengths;
}

}  // namespace

TEST_CASE("Functions are counted with their lambdas, and nothing else is taken for one") {
  using Lengths = std::vector<std::size_t>;
  CHECK(lengths_in("int one() { return 1; }\n") == Lengths{1});
  CHECK(lengths_in("int f() {\n  const auto g = [] {\n    return 1;\n  };\n  return g();\n}\n") ==
        Lengths{6});
  CHECK(lengths_in("struct S {\n  S() : a{1}, b(2) {}\n  int a = 0, b;\n};\n") == Lengths{1});
  CHECK(lengths_in("namespace n {\nconst P p{1, 2};\nint a[] = {f(1), 2};\n}\n").empty());
  CHECK(lengths_in("template <class T>\n  requires requires(T t) { t.x(); }\nvoid f(T t) {\n}\n") ==
        Lengths{4});
  CHECK(lengths_in("// int f() {\nconst char* s = \"{ ( \";\nvoid g() {\n}\n") == Lengths{2});
  CHECK(lengths_in("bool operator()(int) const noexcept {\n\n}\nenum class E { a, b };\n") == Lengths{3});
}

TEST_CASE("No function is longer than forty lines, and half of the library's have four at most") {
  std::vector<std::size_t> library;
  for (const char* folder : {"common", "chapters", "tests"})
    for (const fs::path& file : code_in(folder))
      for (const auto& [line, length, body] : function_lengths::of(first_contact::read_file(file))) {
        INFO(file.string() << ":" << line);
        CHECK(length <= longest_function);
        if (std::string(folder) == "common") library.push_back(body);
      }
  REQUIRE(library.size() > 500);
  const auto middle = library.begin() + static_cast<std::ptrdiff_t>(library.size() / 2);
  std::nth_element(library.begin(), middle, library.end());
  CHECK(*middle <= middle_of_library);
}

TEST_CASE("No file of the library, of the chapters and of the tests is longer than three hundred lines") {
  for (const char* folder : {"common", "chapters", "tests"})
    for (const fs::path& file : code_in(folder)) {
      const std::string text = first_contact::read_file(file);
      CAPTURE(file.string());
      CHECK(std::count(text.begin(), text.end(), '\n') <= static_cast<std::ptrdiff_t>(longest_file));
    }
}
