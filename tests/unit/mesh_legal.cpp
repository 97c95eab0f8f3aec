// Files that are legal though few write them so, and files that look legal and are not.
#include <string>

#include "mesh_files.hpp"

using Catch::Matchers::StartsWith;

namespace {

const std::string mark = "\xEF\xBB\xBF";
const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string facet =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
    "0\nendloop\nendfacet\nendsolid\n";
const std::string ply = "ply\nformat ascii 1.0\n";
const std::string vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";

}  // namespace

TEST_CASE("A byte order mark is read past in each format: no vertex is lost") {
  CHECK(read("a.obj", mark + corners + "f 1 2 3\n").vertices().size() == 3);
  CHECK(read("a.obj", mark + corners + "f 1 2 3\n").vertices()[1] == Point(1, 0, 0));
  CHECK(read("a.off", mark + "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").size() == 1);
  CHECK(read("a.stl", mark + facet).size() == 1);
  CHECK(read("a.ply", mark + ply + vertices + faces + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").size() ==
        1);
  CHECK(read("a.ply", mark + binary_ply(true, true, 0.5)).vertices()[3] == Point(0, 1, 0.5));
}

TEST_CASE("A byte order mark may stand before each of two files that were put together") {
  const Mesh both = read("a.obj", mark + mark + corners + "f 1 2 3\n" + mark + corners + "f 4 5 6\n");
  CHECK(both.vertices().size() == 6);
  CHECK(both.faces()[1] == Mesh::Face{3, 4, 5});
}

TEST_CASE("PLY: there may be none of an element that is no vertex") {
  const std::string none = "element edge 0\nproperty int vertex1\nproperty int vertex2\n";
  CHECK(read("a.ply", ply + vertices + none + faces + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").size() ==
        1);
}

TEST_CASE("OBJ: any statement may go on behind a backslash, with a blank before it or without") {
  const Mesh mesh = read("a.obj", "v 0 \\\n0 0\nv 1\\\n 0 0\r\nv 0 1 0\nf 1 2\\\r\n 3\n");
  CHECK(mesh.vertices()[0] == Point(0, 0, 0));
  CHECK(mesh.vertices()[1] == Point(1, 0, 0));
  CHECK(mesh.size() == 1);
}

TEST_CASE("Lines may end with a carriage return alone") {
  CHECK(read("a.obj", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r").vertices().size() == 3);
}

TEST_CASE("A number too small for a double is 0, or the nearest there is") {
  const Mesh mesh = read("a.obj", "v 1e-400 -1e-400 3e-324\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(mesh.vertices()[0] == Point(0, 0, 4.9406564584124654e-324));
}

TEST_CASE("PLY: what is not read may be no number, and faces may stand before their vertices") {
  CHECK(read("a.ply",
             ply +
                 "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float "
                 "quality\n" +
                 faces + "end_header\n0 0 0 nan\n1 0 0 inf\n0 1 0 -nan\n3 0 1 2\n")
            .size() == 1);
  CHECK(read("a.ply", ply + faces + vertices + "end_header\n3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n").vertices()[1] ==
        Point(1, 0, 0));
}

TEST_CASE("PLY: a strip of triangles turns every other one, and goes on anew behind -1") {
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  const std::string five = "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n";
  const Mesh mesh =
      read("a.ply", ply + five + strips + "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n9 0 1 2 3 3 -1 2 3 4\n");
  CHECK(mesh.faces() == std::vector<Mesh::Face>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
}

TEST_CASE("STL: a text may begin with blanks, and be written in capitals") {
  std::string capitals = facet;
  for (char& letter : capitals) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  CHECK(read("a.stl", " \n" + facet).size() == 1);
  CHECK(read("a.stl", capitals).size() == 1);
}

TEST_CASE("OBJ: a corner that is not a, a/b, a//c or a/b/c is refused") {
  for (const std::string word : {"1/", "1//", "1//x", "1/x", "1/2/", "1/2/3/4", "1/0", "1///3", "1/1.5"}) {
    CAPTURE(word);
    CHECK_THAT(refusal("a.obj", corners + "f " + word + " 2 3\n"), StartsWith("a.obj, line 4: "));
  }
  CHECK(read("a.obj", corners + "f 1/1 2//7 3/-1/+2\n").size() == 1);
  CHECK(refusal("a.obj", "v 0 0 0 red\n") == "a.obj, line 1: \"red\": must be a number");
}

TEST_CASE("PLY: what is declared twice is refused") {
  CHECK(refusal("a.ply", ply + vertices + "property double x\n") ==
        "a.ply, line 7: \"x\": must be there only once");
  CHECK(refusal("a.ply", ply + faces + "property list uchar int vertex_index\n") ==
        "a.ply, line 5: \"vertex_indices\": must be there only once");
  CHECK(refusal("a.ply", ply + vertices + vertices) == "a.ply, line 7: \"vertex\": must be there only once");
}

TEST_CASE("OFF: a vertex must have as many numbers as the first word promises") {
  const auto with = [](const std::string& name, const std::string& more) {
    return refusal("a.off",
                   name + "\n3 1 0\n0 0 0" + more + "\n1 0 0" + more + "\n0 1 0" + more + "\n3 0 1 2\n");
  };
  CHECK(with("NOFF", "") == "a.off, line 3: a vertex must have 6 numbers");
  CHECK(with("COFF", "") == "a.off, line 3: a vertex must have 4 to 7 numbers");
  CHECK(with("STOFF", " 0") == "a.off, line 3: a vertex must have 5 numbers");
  CHECK(with("OFF", " 0") == "a.off, line 3: a vertex must have 3 numbers");
  CHECK(with("NOFF", " 0 0 x") == "a.off, line 3: \"x\": must be a number");
  CHECK(with("NOFF", " 0 0 1").empty());
  CHECK(with("STCNOFF", " 1 0 0 1 0 0 1 .5 .5").empty());
}

TEST_CASE("A file that is packed, or in UTF-16, is told as such") {
  const std::string ending = GENERATE("obj", "off", "ply", "stl");
  CHECK_THAT(refusal("a." + ending, "\x1f\x8b\x08 and so on"), ContainsSubstring("is packed (gzip)"));
  CHECK_THAT(refusal("a." + ending, std::string("PK\3\4 and so on")), ContainsSubstring("is packed (zip)"));
  CHECK_THAT(refusal("a." + ending, std::string("\xFF\xFEv\0 \0", 6)),
             ContainsSubstring("is text in UTF-16"));
  CHECK_THAT(refusal("a." + ending, std::string("v\0 \0\x30\0 \0", 8)),
             ContainsSubstring("is text in UTF-16"));
}

TEST_CASE("What a refusal quotes is short, on one line, and does nothing to a terminal") {
  CHECK(refusal("a.obj", std::string("v \x1b[31m\0 0 0\n", 13)) ==
        "a.obj, line 1: \"\\x1b[31m\\x00\": must be a number");
  CHECK(refusal("a.obj", "v " + std::string(3000000, 'x') + " 0 0\n").size() < 300);
  CHECK(refusal("a.stl", "\x1b[31m solid\n").find('\x1b') == std::string::npos);
}

TEST_CASE("STL: a text that is not one is refused as a text, and what is binary by its size") {
  CHECK_THAT(refusal("a.stl", "lid\n" + facet), StartsWith("a.stl, line 1: \"lid\": must be solid"));
  CHECK_THAT(refusal("a.stl", facet + '\0'), StartsWith("a.stl, line 10: \"\\x00\": must be solid"));
  CHECK_THAT(refusal("a.stl", binary_stl(3, 2)), ContainsSubstring("3 triangles need 150 bytes"));
}
