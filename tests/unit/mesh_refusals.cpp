#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "mesh_files.hpp"

using Catch::Matchers::StartsWith;
namespace fs = std::filesystem;

TEST_CASE("Who listens to the reading of a file that is refused is never told that all is read") {
  const Folder folder;
  double last = 0;
  CHECK_THROWS_AS(read_mesh(folder.file("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"),
                            [&](double part) { last = part; }),
                  MeshFileError);
  CHECK(last < 1);
}

TEST_CASE("A missing file, a folder and an unknown ending are refused by name") {
  const Folder folder;
  CHECK_THROWS_WITH(read_mesh(folder.path() / "none.obj"),
                    ContainsSubstring("none.obj: must be a file that exists"));
  fs::create_directory(folder.path() / "dir.off");
  CHECK_THROWS_WITH(read_mesh(folder.path() / "dir.off"), ContainsSubstring("dir.off: must be a file"));
  CHECK(refusal("a.fbx", "v 0 0 0") == "a.fbx: the name must end in .obj, .off, .ply or .stl");
  CHECK(refusal("obj", "v 0 0 0") == "obj: the name must end in .obj, .off, .ply or .stl");
}

TEST_CASE("An empty file and one without a face are refused") {
  const std::string ending = GENERATE("obj", "off", "ply", "stl");
  CHECK(refusal("a." + ending, "") == "a." + ending + ": is empty, must hold a mesh");
  CHECK(refusal("a.obj", "all but a mesh\n") == "a.obj: holds no face, must hold at least one");
  CHECK(refusal("a.off", "OFF 0 0 0") == "a.off: holds no face, must hold at least one");
  CHECK(refusal("a.stl", "solid a\nendsolid a\n") == "a.stl: holds no face, must hold at least one");
}

TEST_CASE("OBJ: what is refused, and on which line") {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  CHECK(refusal("a.obj", "v 0 0\n") == "a.obj, line 1: a number is missing after \"0\"");
  CHECK(refusal("a.obj", "\nv 0 nan 0\n") == "a.obj, line 2: \"nan\": must be a finite number");
  CHECK(refusal("a.obj", "v 0 1e999 0\n") == "a.obj, line 1: \"1e999\": must be a finite number");
  CHECK(refusal("a.obj", "v 0 1,5 0\n") == "a.obj, line 1: \"1,5\": must be a number");
  CHECK(refusal("a.obj", corners + "f 1 2 4\n") == "a.obj, line 4: vertex 4: must be from 1 to 3");
  CHECK(refusal("a.obj", corners + "f 1 2 0\n") ==
        "a.obj, line 4: vertex 0: counted from 1, or from -1 for the last one");
  CHECK_THAT(refusal("a.obj", corners + "f -4 2 1\n"), StartsWith("a.obj, line 4: vertex -4"));
  CHECK_THAT(refusal("a.obj", corners + "f 1 2 99999999999\n"),
             StartsWith("a.obj, line 4: vertex 99999999999"));
  CHECK(refusal("a.obj", corners + "f 1 x 3\n") == "a.obj, line 4: \"x\": must be a whole number");
  CHECK(refusal("a.obj", corners + "f 1 2\n") == "a.obj, line 4: a face must have at least 3 corners");
  CHECK_THAT(refusal("a.obj", corners + "f 1 2 \\"), StartsWith("a.obj, line 4: the file ends early"));
}

TEST_CASE("OFF: what is refused, and on which line") {
  const std::string corners = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  CHECK_THAT(refusal("a.off", "PLY\n"), StartsWith("a.off, line 1: must begin with OFF"));
  CHECK_THAT(refusal("a.off", "4OFF\n"), StartsWith("a.off, line 1: must begin with OFF"));
  CHECK_THAT(refusal("a.off", "OFF BINARY\n"), StartsWith("a.off, line 1: binary OFF"));
  CHECK_THAT(refusal("a.off", "OFF\n3\n"), StartsWith("a.off, line 2: must have the counts"));
  CHECK(refusal("a.off", "OFF\n-3 1 0\n") == "a.off, line 2: a count must not be negative");
  CHECK(refusal("a.off", "OFF\n9999999999999 1 0\n0 0 0\n") ==
        "a.off, line 3: the file ends early: 1 of 9999999999999 vertices");
  CHECK(refusal("a.off", "OFF\n3 1 0\n0 0 0 1\n") == "a.off, line 3: a vertex must have 3 numbers");
  CHECK(refusal("a.off", corners) == "a.off, line 5: the file ends early: 0 of 1 faces");
  CHECK(refusal("a.off", corners + "3 0 1 3\n") == "a.off, line 6: vertex 3: must be from 0 to below 3");
  CHECK(refusal("a.off", corners + "3 0 1 -1\n") == "a.off, line 6: vertex -1: must be from 0 to below 3");
  CHECK(refusal("a.off", corners + "2 0 1\n") == "a.off, line 6: a face must have at least 3 corners");
  CHECK(refusal("a.off", corners + "4000000000 0 1\n") ==
        "a.off, line 6: 2 of 4000000000 corners: all must be on the line");
  CHECK(refusal("a.off", corners + "3 0 1 2\n3 0 1 2\n") ==
        "a.off, line 7: more follows than the counts promise");
}

TEST_CASE("PLY: what is refused, and on which line") {
  const std::string header = "ply\nformat ascii 1.0\n";
  const std::string vertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string corners = header + vertex + face + "0 0 0\n1 0 0\n0 1 0\n";
  CHECK(refusal("a.ply", "plx\n") == "a.ply, line 1: must begin with ply");
  CHECK_THAT(refusal("a.ply", "ply\nformat ascii 2.0\n"), StartsWith("a.ply, line 2: must be format"));
  CHECK_THAT(refusal("a.ply", header + "element vertex 3\n"),
             StartsWith("a.ply, line 3: the file ends early"));
  CHECK_THAT(refusal("a.ply", header + "property float x\n"),
             StartsWith("a.ply, line 3: must be an element"));
  CHECK(refusal("a.ply", header + "element vertex 3\nproperty half x\n") ==
        "a.ply, line 4: \"half\": must be a type of PLY");
  CHECK(refusal("a.ply", header + "element vertex 99999999999999999999\n") ==
        "a.ply, line 3: \"99999999999999999999\": must be a whole number");
  CHECK(refusal("a.ply", header + "element vertex 9999999999\nend_header\n") ==
        "a.ply, line 4: element vertex must have a property");
  CHECK(refusal("a.ply", header + "element vertex -1\n") == "a.ply, line 3: a count must not be negative");
  CHECK(refusal("a.ply", header + "element vertex 1\nproperty float x\nend_header\n0\n") ==
        "a.ply, line 6: a vertex must have x, y and z");
  CHECK(refusal("a.ply", header + vertex + face + "0 0 0\n") ==
        "a.ply, line 10: the file ends early: 1 of 3 rows of vertex");
  CHECK(refusal("a.ply", header + vertex + face + "0 inf 0\n") ==
        "a.ply, line 10: a coordinate must be a finite number");
  CHECK(refusal("a.ply", header + vertex + face + "0 0\n") ==
        "a.ply, line 10: a number is missing after \"0\"");
  CHECK(refusal("a.ply", header + vertex + face + "0 0 0 0\n") ==
        "a.ply, line 10: the line must end after 3 numbers");
  CHECK(refusal("a.ply", corners + "3 0 1 3\n") ==
        "a.ply, line 13: a vertex of a face must be a whole number from 0 to below 3");
  CHECK_THAT(refusal("a.ply", corners + "3 0 1 1.5\n"), StartsWith("a.ply, line 13: a vertex of a face"));
  CHECK_THAT(refusal("a.ply", corners + "-3 0 1 2\n"),
             StartsWith("a.ply, line 13: a list must have a whole"));
  CHECK_THAT(refusal("a.ply", corners + "2 0 1\n"), StartsWith("a.ply, line 13: a face must have a list"));
  CHECK(refusal("a.ply", corners + "3 0 1 2\n3 0 1 2\n") ==
        "a.ply, line 14: more follows than the counts promise");
}

TEST_CASE("PLY in binary: what is refused, and at which byte") {
  const std::string whole = binary_ply(true, true, 0.5);
  const std::size_t body = whole.find("end_header\n") + 11;
  CHECK(refusal("a.ply", whole.substr(0, body + 30)) ==
        "a.ply, byte " + std::to_string(body + 26) + ": the file ends early: 1 of 4 rows of vertex");
  CHECK(refusal("a.ply", binary_ply(true, true, std::numeric_limits<double>::quiet_NaN())) ==
        "a.ply, byte " + std::to_string(body + 17) + ": a coordinate must be a finite number");
  CHECK_THAT(refusal("a.ply", binary_ply(true, true, 0, 4)), ContainsSubstring("from 0 to below 4"));
  CHECK_THAT(refusal("a.ply", whole + "x"), ContainsSubstring("more follows than the counts promise"));
}

TEST_CASE("STL: what is refused, and on which line or at which byte") {
  CHECK(refusal("a.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\n") ==
        "a.stl, line 4: the file ends early: endsolid is missing");
  CHECK(refusal("a.stl", "solid\nvertex 0 0 0\nendloop\n") == "a.stl, line 3: a facet must have 3 vertices");
  CHECK(refusal("a.stl", "solid\nvertex 0 0 0\nendsolid\n") ==
        "a.stl, line 3: the last facet is not complete");
  CHECK(refusal("a.stl", "solid\nvertex 0 0 x\n") == "a.stl, line 2: \"x\": must be a number");
  CHECK(refusal("a.stl", "solid\nfacets\n") == "a.stl, line 2: \"facets\": must be a line of an STL file");
  CHECK(refusal("a.stl", "solid\nsolid\n") == "a.stl, line 2: solid and endsolid must alternate");
  CHECK(refusal("a.stl", "short") ==
        "a.stl, line 1: \"short\": must be solid: a text begins with it, and so does each of its parts");
  CHECK(refusal("a.stl", binary_stl(4000000000u, 2)) ==
        "a.stl, byte 80: 4000000000 triangles need 200000000000 bytes after the header, not 100");
  CHECK(refusal("a.stl", binary_stl(1, 1, std::numeric_limits<float>::infinity())) ==
        "a.stl, byte 96: must be a finite number");
}

TEST_CASE("A file cut short anywhere, or with a byte changed, is read or refused, never more") {
  const std::string files[][2] = {
      {"a.ply", binary_ply(true, true, 0.5)},
      {"a.ply", binary_ply(false, false, 0.5)},
      {"a.stl", binary_stl(2, 2)},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2 -1\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"a.stl",
       "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"}};
  const Folder folder;
  std::mt19937 random(20240501);
  const auto tolerated = [&](const std::string& name, const std::string& bytes) {
    try {
      return read_mesh(folder.file(name, bytes)).size() > 0;
    } catch (const MeshFileError& error) {
      return std::string(error.what()).find(name) != std::string::npos;
    }
  };
  for (const auto& [name, bytes] : files)
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      std::string changed = bytes;
      changed[i] = static_cast<char>(random() % 256);
      INFO(name << ", byte " << i << " becomes " << static_cast<int>(changed[i]));
      CHECK(tolerated(name, bytes.substr(0, i)));
      CHECK(tolerated(name, changed));
    }
}
