#include "first_contact/mesh_io/mesh_file.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "catch.hpp"
#include "places.hpp"

using namespace first_contact;

namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, gone when the test ends.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("first_contact_" + std::to_string(std::random_device{}()))) {
    fs::create_directory(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  fs::path file(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

Mesh read(const std::string& name, const std::string& bytes) {
  const Folder folder;
  return read_mesh(folder.file(name, bytes));
}

/// What the exception says, without the folder's name; empty if there was none.
std::string refusal(const std::string& name, const std::string& bytes) {
  const Folder folder;
  try {
    read_mesh(folder.file(name, bytes));
  } catch (const MeshFileError& error) {
    const std::string message = error.what(), prefix = (folder.path() / "").string();
    REQUIRE(message.starts_with(prefix));  // every message names the file
    return message.substr(prefix.size());
  }
  return "";
}

using Catch::Matchers::StartsWith;

/// A number as the bytes of a file, the lowest first or the highest first.
template <class Number>
std::string bytes_of(Number value, bool little = true) {
  std::string bytes;
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t,
                                  std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint8_t>>;
  const auto bits = std::bit_cast<Bits>(value);
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    const std::size_t byte = little ? i : sizeof(Number) - 1 - i;
    bytes += static_cast<char>(static_cast<std::uint64_t>(bits) >> (8 * byte) & 0xff);
  }
  return bytes;
}

/// The square (0,0) (1,0) (1,1) (0,1) at height z, as a binary PLY with doubles, or with floats, and unread
/// extras.
std::string binary_ply(bool little, bool doubles, double z, std::uint32_t last_vertex = 3) {
  std::string text =
      std::string("ply\nformat binary_") + (little ? "little" : "big") + "_endian 1.0\ncomment made here\n";
  const std::string real = doubles ? "double" : "float32";
  text += "element vertex 4\nproperty uchar red\nproperty " + real + " x\nproperty " + real +
          " y\nproperty " + real +
          " z\nelement face 1\nproperty list uchar uint vertex_indices\nproperty int group\nend_header\n";
  const double xy[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const auto& [x, y] : xy) {
    text += bytes_of(std::uint8_t{255});
    for (const double value : {x, y, z})
      text += doubles ? bytes_of(value, little) : bytes_of(static_cast<float>(value), little);
  }
  text += bytes_of(std::uint8_t{4});
  for (const std::uint32_t vertex : {0u, 1u, 2u, last_vertex}) text += bytes_of(vertex, little);
  return text + bytes_of(std::uint32_t{7}, little);
}

std::string binary_stl(std::uint32_t promised, std::size_t triangles, float first = 0) {
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");  // as many real files have it
  bytes += bytes_of(promised);
  const float corners[2][9] = {{first, 0, 0, 1, 0, 0, 1, 1, 0}, {first, 0, 0, 1, 1, 0, 0, 1, 0}};
  for (std::size_t i = 0; i < triangles; ++i) {
    for (int k = 0; k < 3; ++k) bytes += bytes_of(0.f);
    for (const float value : corners[i % 2]) bytes += bytes_of(value);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

const std::vector<Mesh::Face> two_halves{{0, 1, 2}, {0, 2, 3}};

}  // namespace

TEST_CASE("OBJ: a polygon becomes a fan, and texture and normal numbers are passed over") {
  const Mesh mesh = read("square.OBJ",
                         "# a square\nmtllib none\nv 0 0 0.1\nv 1 0 0.1 1 1 1\r\nv 1 1 +0.1\nv 0 1 0.1\n\n"
                         "vn 0 0 1\nf 1/1/1 2//1 3 4/2 # all four\n");
  CHECK(mesh.faces() == two_halves);
  CHECK(mesh.vertices()[2] == Point(1, 1, 0.1));
}

TEST_CASE("OBJ: negative numbers count from the last vertex so far, and a backslash continues a line") {
  const Mesh mesh = read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 \\\n -2 -3");
  CHECK(mesh.faces() == std::vector<Mesh::Face>{{0, 1, 2}, {3, 2, 1}});
}

TEST_CASE("OBJ: a face may stand before its vertices") {
  CHECK(read("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").size() == 1);
}

TEST_CASE("OFF: comments, counts on the first line, and polygons") {
  const Mesh mesh =
      read("square.off", "OFF 4 1 0 # counts\n0 0 0\n# between\n1 0 0\n\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n");
  CHECK(mesh.faces() == two_halves);
}

TEST_CASE("OFF: colours and normals of vertices are passed over") {
  CHECK(read("a.off", "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 2 1 0 0 1\n3 0 1 2\n").vertices()[2] ==
        Point(0, 1, 2));
  CHECK(read("a.off", "CNOFF\n3 1\n0 0 0 0 0 1 9\n1 0 0 0 0 1 9\n0 1 2 0 0 1 9\n3 0 1 2\n").size() == 1);
}

TEST_CASE("PLY in ASCII: properties in any order, unknown elements and lists passed over") {
  const Mesh mesh = read(
      "square.ply",
      "ply\r\nformat ascii 1.0\r\ncomment x\r\nobj_info y\r\nelement vertex 4\r\nproperty double z\r\n"
      "property double y\r\nproperty double x\r\nproperty uchar red\r\nelement edge 1\r\n"
      "property list uchar int ends\r\nelement face 1\r\nproperty list uchar int vertex_index\r\n"
      "end_header\r\n0.5 0 0 255\r\n0.5 0 1 255\r\n0.5 1 1 255\r\n0.5 1 0 255\r\n2 0 1\r\n4 0 1 2 3\r\n");
  CHECK(mesh.faces() == two_halves);
  CHECK(mesh.vertices()[1] == Point(1, 0, 0.5));
}

TEST_CASE("PLY in binary: both byte orders, floats and doubles") {
  const bool little = GENERATE(true, false), doubles = GENERATE(true, false);
  const Mesh mesh = read("square.ply", binary_ply(little, doubles, 0.1));
  CHECK(mesh.faces() == two_halves);
  CHECK(mesh.vertices()[3] == Point(0, 1, doubles ? 0.1 : static_cast<double>(0.1f)));
}

TEST_CASE("STL in ASCII: equal positions become one vertex, and 0 equals -0") {
  const Mesh mesh =
      read("square.stl",
           "solid two\nfacet normal nan nan nan\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
           "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex -0 0 0\nvertex 1 1 0\nvertex 0 1 0\n"
           "endloop\nendfacet\nendsolid two\n");
  CHECK(mesh.faces() == two_halves);
  CHECK(mesh.vertices().size() == 4);
}

TEST_CASE("STL in binary is recognised even if it begins with the word solid") {
  const Mesh mesh = read("square.stl", binary_stl(2, 2));
  CHECK(mesh.faces() == two_halves);
  CHECK(mesh.vertices().size() == 4);
}

TEST_CASE(
    "Who listens is told ever more of a file as it is read, about a hundred times, and in the end all of "
    "it") {
  std::string off = "OFF\n1000 1 0\n", stl = binary_stl(2, 2), ply = binary_ply(true, true, 0);
  for (int i = 0; i < 1000; ++i) off += std::to_string(i) + " 0 0\n";
  off += "3 0 1 2\n";
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.off", off}, {"a.stl", stl}, {"a.ply", ply}};
  for (const auto& [name, bytes] : files) {
    CAPTURE(name);
    const Folder folder;
    std::vector<double> parts;
    const auto told = read_mesh(folder.file(name, bytes), [&](double part) { parts.push_back(part); });
    CHECK(told.vertices() == read(name, bytes).vertices());
    REQUIRE(parts.size() > 1);
    CHECK(parts.size() <= 102);
    CHECK(parts.size() >= (name == "a.off" ? 90 : 2));
    CHECK(parts.front() >= 0);
    CHECK(std::is_sorted(parts.begin(), parts.end()));
    CHECK(parts.back() == 1);
  }
}

TEST_CASE("Who listens to the reading of a file that is refused is never told that all is read") {
  const Folder folder;
  double last = 0;
  CHECK_THROWS_AS(read_mesh(folder.file("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"),
                            [&](double part) { last = part; }),
                  MeshFileError);
  CHECK(last < 1);
}

TEST_CASE("Digits are read as the nearest double, and OFF gives the same doubles back") {
  const Mesh mesh({{0.1, 1.0 / 3, 5e-324}, {-1.0715086071862673e301, 123456789.123456789, 0}, {2e-7, 0, 1}},
                  {{0, 1, 2}});
  const Folder folder;
  write_off(folder.path() / "a.off", mesh);
  const Mesh again = read_mesh(folder.path() / "a.off");
  CHECK(again.vertices() == mesh.vertices());
  CHECK(again.faces() == mesh.faces());
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) ==
        1);  // nothing left over
}

TEST_CASE("A mesh that cannot be written leaves no file, and the message names it") {
  const Folder folder;
  const fs::path target = folder.path() / "missing" / "a.off";
  CHECK_THROWS_WITH(write_off(target, Mesh({{0, 0, 0}}, {{0, 0, 0}})), StartsWith(target.string()));
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("The bunny is closed: every edge has two triangles, and vertices - edges + faces = 2") {
  const Mesh bunny = read_mesh(fs::path(first_contact::places::source) / "chapters/meshes/bunny.off");
  CHECK(bunny.size() == 3674);
  CHECK(bunny.vertices().size() == 1839);
  CHECK(bunny.vertices()[0] == Point(1.301895, -2.550061, 0.122622));
  CHECK(bunny.vertices().size() + bunny.size() - 3 * bunny.size() / 2 == 2);
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
  CHECK(refusal("a.obj", "v 0 1,5 0\n") == "a.obj, line 1: \"1,5\": must be a finite number");
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
        "a.ply, line 10: \"inf\": must be a finite number");
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
        "a.ply, byte " + std::to_string(body + 17) + ": must be a finite number");
  CHECK_THAT(refusal("a.ply", binary_ply(true, true, 0, 4)), ContainsSubstring("from 0 to below 4"));
  CHECK_THAT(refusal("a.ply", whole + "x"), ContainsSubstring("more follows than the counts promise"));
}

TEST_CASE("STL: what is refused, and on which line or at which byte") {
  CHECK(refusal("a.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\n") ==
        "a.stl, line 4: the file ends early: endsolid is missing");
  CHECK(refusal("a.stl", "solid\nvertex 0 0 0\nendloop\n") == "a.stl, line 3: a facet must have 3 vertices");
  CHECK(refusal("a.stl", "solid\nvertex 0 0 0\nendsolid\n") ==
        "a.stl, line 3: the last facet is not complete");
  CHECK(refusal("a.stl", "solid\nvertex 0 0 x\n") == "a.stl, line 2: \"x\": must be a finite number");
  CHECK(refusal("a.stl", "solid\nfacets\n") == "a.stl, line 2: \"facets\": must be a line of an STL file");
  CHECK(refusal("a.stl", "solid\nsolid\n") == "a.stl, line 2: solid and endsolid must alternate");
  CHECK(refusal("a.stl", "short") == "a.stl, byte 5: the file ends early: STL has 84 bytes of header");
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
