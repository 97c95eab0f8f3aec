#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "catch.hpp"
#include "places.hpp"

namespace fs = std::filesystem;

namespace {

// The reading order of the library: a folder needs only those before it.
const std::vector<std::string> order{"geometry", "files",    "mesh_io", "sweep", "trees",  "bvh",    "batch",
                                     "pairs",    "response", "motion",  "stage", "figure", "program"};
const std::size_t mathematics = 11;  // the first eleven are what a user gets with Eigen and Highway

// The header that includes all the others; and those that are nobody's but their neighbours'.
const std::string everything = "first_contact.hpp";
const std::vector<std::string> insides{
    "files/decimal.hpp",        "files/input.hpp",          "files/output.hpp",
    "files/printable.hpp",      "mesh_io/flat_polygon.hpp", "mesh_io/mesh_bytes.hpp",
    "mesh_io/mesh_formats.hpp", "mesh_io/orientation.hpp",  "mesh_io/ply_header.hpp",
    "mesh_io/polygons.hpp",     "mesh_io/text_lines.hpp",   "batch/desk.hpp",
    "batch/loops.hpp"};

std::size_t rank(const std::string& folder) {
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), folder) - order.begin());
}

struct Line {
  fs::path file;
  std::string folder;  // of the file
  std::string text;
};

std::vector<Line> all_lines() {
  std::vector<Line> lines;
  const fs::path library = fs::path(first_contact::places::source) / "common/first_contact";
  for (const auto& entry : fs::recursive_directory_iterator(library)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path());
    const std::string folder = entry.path().lexically_relative(library).begin()->string();
    for (std::string line; std::getline(in, line);) lines.push_back({entry.path(), folder, line});
  }
  return lines;
}

struct Include {
  fs::path file;
  std::string folder;
  std::string what;  // as it stands between the quotes or brackets
};

std::vector<Include> all_includes() {
  std::vector<Include> includes;
  const std::regex form("^#include [<\"]([^>\"]+)[>\"]");
  std::smatch match;
  for (const auto& [file, folder, text] : all_lines())
    if (std::regex_search(text, match, form)) includes.push_back({file, folder, match[1]});
  return includes;
}

}  // namespace

TEST_CASE("The reading order of the library is its dependency order") {
  const std::string own = "first_contact/";
  for (const Include& include : all_includes()) {
    if (!include.what.starts_with(own) || include.folder == everything) continue;
    const std::string needed =
        include.what.substr(own.size(), include.what.find('/', own.size()) - own.size());
    CAPTURE(include.file.string(), include.what);
    CHECK(rank(include.folder) < order.size());
    CHECK(rank(needed) <= rank(include.folder));
  }
}

TEST_CASE("One header includes all that is for users, each after what it includes itself") {
  const fs::path library = fs::path(first_contact::places::source) / "common/first_contact";
  std::vector<std::string> included;
  for (const Include& include : all_includes())
    if (include.folder == everything) included.push_back(include.what.substr(include.what.find('/') + 1));
  const auto place = [&](const std::string& header) {
    return std::find(included.begin(), included.end(), header) - included.begin();
  };
  std::size_t for_users = 0;
  for (std::size_t i = 0; i < mathematics; ++i)
    for (const auto& entry : fs::directory_iterator(library / order[i])) {
      const std::string header = order[i] + "/" + entry.path().filename().string();
      if (entry.path().extension() != ".hpp") continue;
      if (std::find(insides.begin(), insides.end(), header) != insides.end()) continue;
      INFO(header << " is missing in " << everything);
      CHECK(std::find(included.begin(), included.end(), header) != included.end());
      ++for_users;
    }
  CHECK(included.size() == for_users);
  for (const Include& include : all_includes()) {
    const std::string header = include.file.lexically_relative(library).generic_string();
    const std::string needed = include.what.substr(include.what.find('/') + 1);
    if (place(header) == std::ssize(included) || place(needed) == std::ssize(included)) continue;
    CAPTURE(header, needed);
    CHECK(place(needed) < place(header));
  }
}

TEST_CASE("The fast tree is built, then walked, then decided about, and what one calls comes last") {
  const std::vector<std::string> rooms{"build", "kernels", "cast", "bvh.hpp"};
  const auto room = [&](const std::string& path) {  // what follows bvh/ in a path, up to the next slash
    const std::string rest =
        path.substr(path.rfind("bvh/") == std::string::npos ? 0 : path.find("/bvh/") + 5);
    return std::find(rooms.begin(), rooms.end(), rest.substr(0, rest.find('/'))) - rooms.begin();
  };
  for (const Include& include : all_includes()) {
    if (include.folder != "bvh" || include.what.find("/bvh/") == std::string::npos) continue;
    CAPTURE(include.file.string(), include.what);
    CHECK(room(include.what) <= room(include.file.string()));
  }
}

TEST_CASE("Mathematics needs Eigen, the standard library, Highway in kernels, the system for large pages") {
  const std::regex allowed("^(first_contact/.*|Eigen/.*|hwy/.*|[a-z_0-9]+)$");
  const std::regex kernels(".*/(batch|kernels)/[^/]*");
  for (const Include& include : all_includes()) {
    if (rank(include.folder) >= mathematics) continue;
    CAPTURE(include.file.string(), include.what);
    if (include.file.filename() == "large_pages.cpp" && include.what == "sys/mman.h") continue;
    CHECK(std::regex_match(include.what, allowed));
    if (include.what.starts_with("hwy/")) CHECK(std::regex_match(include.file.string(), kernels));
  }
}

// Eigen's own order depends on options and on addresses: \see geometry/products.hpp. The fast tree's floats
// only bound.
TEST_CASE("What the mathematics adds up it adds in an order of its own, never in Eigen's") {
  const std::regex sum(
      "\\.(dot|norm|squaredNorm|stableNorm|blueNorm|normalize|normalized|stableNormalized|sum|mean|prod|trace"
      "|determinant|lpNorm<[12]>)\\(");
  const std::regex bounds(".*/bvh/(build|kernels)/[^/]*");
  for (const auto& [file, folder, line] : all_lines()) {
    if (rank(folder) >= mathematics || std::regex_match(file.string(), bounds)) continue;
    CAPTURE(file.string(), line);
    CHECK_FALSE(std::regex_search(line.substr(0, line.find("//")), sum));
  }
}

TEST_CASE("Only figure/ sees gnuplot-iostream, and only in one place") {
  const auto includes = all_includes();
  CHECK(std::count_if(includes.begin(), includes.end(), [](const Include& include) {
          return include.what.find("gnuplot-iostream") != std::string::npos;
        }) == 1);
}
