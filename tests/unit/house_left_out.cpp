// Which answers depend on the C library: those that the README names, and no others.
#include <filesystem>
#include <regex>
#include <set>

#include "catch.hpp"
#include "first_contact/files/input.hpp"
#include "places.hpp"

namespace fs = std::filesystem;

namespace {

const fs::path project = first_contact::places::source;

}  // namespace

TEST_CASE("A sine, a power or a logarithm of the C library is asked for in these files alone") {
  const std::set<std::string> known{
      "geometry/bounding.cpp",      // principal_box: Eigen's eigenvectors
      "geometry/transform.cpp",     // perspective, and a turn by an angle
      "motion/bounce.cpp",          // after the first impact
      "motion/easing.cpp",          // sine, and damp
      "motion/easing_family.cpp",   // power
      "motion/easing_formula.cpp",  // exponential, elastic, spring
      "motion/rigid_tween.cpp",     // turns at constant speed
      "motion/squash.cpp",          // a stretch that is eased
      "pairs/first_contacts.cpp"    // into how many pieces motions are cut, not what is found
  };
  const std::regex function(
      R"(std::(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot)\()"
      "|AngleAxisd\\(|EigenSolver");
  std::set<std::string> found;
  const fs::path library = project / "common" / "first_contact";
  for (const auto& entry : fs::recursive_directory_iterator(library)) {
    const std::string place = fs::relative(entry.path(), library).generic_string();
    if (!entry.is_regular_file() || place.starts_with("figure/") || place.starts_with("program/")) continue;
    if (std::regex_search(first_contact::read_file(entry.path()), function)) found.insert(place);
  }
  CHECK(found == known);
}

TEST_CASE("The README names each answer that the C library may round in its own way") {
  const std::string readme = first_contact::read_file(project / "README.md");
  for (const std::string name : {"`sine`", "`exponential`", "`elastic`", "`power`", "`spring`", "`damp`",
                                 "`Rigid::turned`", "`RigidTween`", "`eased_stretch`", "`Turning<Mesh>`",
                                 "`Transform::perspective`", "`Bounce`", "`principal_box`"}) {
    CAPTURE(name);
    CHECK(readme.find(name) != std::string::npos);
  }
}
