#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "mesh_files.hpp"
#include "places.hpp"

using namespace first_contact;
using Catch::Matchers::StartsWith;
namespace fs = std::filesystem;

namespace {

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

TEST_CASE("PLY in binary: each number takes the bytes of its type, by its old name or its new one") {
  using namespace std::string_literals;
  struct Kind {
    std::string name, two;  // and the number 2
  };
  for (const Kind& kind :
       {Kind{"char", "\2"s}, Kind{"int8", "\2"s}, Kind{"uchar", "\2"s}, Kind{"uint8", "\2"s},
        Kind{"short", "\2\0"s}, Kind{"int16", "\2\0"s}, Kind{"ushort", "\2\0"s}, Kind{"uint16", "\2\0"s},
        Kind{"int", "\2\0\0\0"s}, Kind{"int32", "\2\0\0\0"s}, Kind{"uint", "\2\0\0\0"s},
        Kind{"uint32", "\2\0\0\0"s}, Kind{"float", bytes_of(2.F)}, Kind{"float32", bytes_of(2.F)},
        Kind{"double", bytes_of(2.0)}, Kind{"float64", bytes_of(2.0)}}) {
    CAPTURE(kind.name);
    std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty " + kind.name +
                       " x\nproperty float y\nproperty " + kind.name +
                       " z\nelement face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
    for (const float y : {0.F, 1.F, 5.F}) file += kind.two + bytes_of(y) + kind.two;
    const Mesh mesh = read("a.ply", file + "\3\0\1\2"s);
    CHECK(mesh.vertices()[1] == Point(2, 1, 2));
    CHECK(mesh.vertices()[2] == Point(2, 5, 2));
  }
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
