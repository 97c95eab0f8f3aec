// What is added to the library is asked wherever its like is asked: the recipes of CONTRIBUTING.md.
#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "catch.hpp"
#include "first_contact/files/input.hpp"
#include "places.hpp"

namespace fs = std::filesystem;

namespace {

const fs::path project = first_contact::places::source;

/// The headers of a folder of the library in which something is declared: "sweep/sphere_plane.hpp" ...
std::vector<std::string> headers_with(const std::string& folder, const std::regex& declaration) {
  std::vector<std::string> headers;
  for (const auto& entry : fs::directory_iterator(project / "common/first_contact" / folder))
    if (entry.path().extension() == ".hpp" &&
        std::regex_search(first_contact::read_file(entry.path()), declaration))
      headers.push_back(folder + "/" + entry.path().filename().string());
  std::sort(headers.begin(), headers.end());
  return headers;
}

/// Is the header included by a file whose path begins so: "tests/digest/", "tests/unit/same_bits"?
bool included_below(const std::string& beginning, const std::string& header) {
  for (const auto& entry : fs::directory_iterator((project / beginning).parent_path())) {
    const std::string file = entry.path().lexically_relative(project).generic_string();
    if (entry.is_regular_file() && file.starts_with(beginning) &&
        first_contact::read_file(entry.path()).find("#include \"first_contact/" + header + "\"") !=
            std::string::npos)
      return true;
  }
  return false;
}

void check_places(const std::vector<std::string>& headers, const std::vector<std::string>& places) {
  for (const std::string& header : headers)
    for (const std::string& place : places) {
      INFO(header << " is included by no file " << place << "*");
      CHECK(included_below(place, header));
    }
}

}  // namespace

TEST_CASE("Each pair of shapes has its cases, its exact answers, the same bits everywhere, and any unit") {
  const auto pairs = headers_with(
      "sweep", std::regex(R"(\nstd::optional<Contact> sweep\(const Moving<\w+>& \w+, const [^)]*\);)"));
  CHECK(pairs.size() >= 9);
  check_places(pairs, {"tests/unit/", "tests/oracle/", "tests/digest/", "tests/unit/same_bits",
                       "tests/property/any_unit_"});
  const std::string named = first_contact::read_file(project / "common/first_contact/sweep/obstacle.hpp");
  for (const std::string& header : pairs) {
    if (header == "sweep/ray_triangle.hpp") continue;  // a point is no mover of its own there
    CAPTURE(header);
    CHECK(named.find("include first_contact/" + header) != std::string::npos);
  }
}

TEST_CASE("Each tree must agree with the others, has the same bits everywhere, and is the same in any unit") {
  const auto trees = headers_with("trees", std::regex(R"(\nstatic_assert\(Partition<\w+>\);)"));
  CHECK(trees.size() >= 4);
  for (const std::string& tree : trees) {
    CAPTURE(tree);
    CHECK((included_below("tests/property/partition.cpp", tree) ||
           included_below("tests/property/worlds.hpp", tree)));
  }
  check_places(trees, {"tests/digest/", "tests/unit/same_bits", "tests/property/any_unit_trees"});
}
