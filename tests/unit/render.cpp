#include "first_contact/figure/render.hpp"

#include <chrono>
#include <functional>
#include <thread>

#include "catch.hpp"
#include "first_contact/figure/figure.hpp"
#include "folder.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace fs = std::filesystem;

namespace {

// A folder with something in it that calls itself gnuplot.
struct Impostor : Folder {
  explicit Impostor(const std::string& does) {
    const fs::path program = file("gnuplot", "#!/bin/sh\n" + does + "\n");
    fs::permissions(program, fs::perms(0755));
    studio.folder = path() / "out";
    studio.gnuplot = program.string();
    studio.patience = 0.4;
  }
  void draw() const { Figure(studio, "a").draw(); }

  Studio studio;
};

double seconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

TEST_CASE("A gnuplot that does nothing and says that all is well is noticed: there is no whole picture") {
  const Impostor idle("exit 0"), half("echo '<svg>' >a.svg");
  CHECK_THROWS_WITH(idle.draw(), ContainsSubstring("drew no whole a.svg"));
  CHECK_THROWS_WITH(half.draw(), ContainsSubstring("drew no whole a.svg"));
  CHECK_FALSE(fs::exists(half.studio.folder / "a.svg"));
}

TEST_CASE("A gnuplot that hangs is stopped in time, with all that it has started") {
  const Impostor hanging("touch \"$0.began\"; sleep 3; touch \"$0.ended\"");
  CHECK(seconds_of([&] { CHECK_THROWS_WITH(hanging.draw(), ContainsSubstring("was not done in 0.4 s")); }) <
        3);
  CHECK(fs::exists(hanging.path() / "gnuplot.began"));
  std::this_thread::sleep_for(std::chrono::seconds(4));
  CHECK_FALSE(fs::exists(hanging.path() / "gnuplot.ended"));
}

TEST_CASE("Ten megabytes of a gnuplot's complaints are cut to a line") {
  const Impostor loud("head -c 10000000 /dev/zero | tr '\\0' 'x' >&2; exit 1");
  try {
    loud.draw();
    FAIL("nothing was noticed");
  } catch (const std::exception& error) {
    CHECK(std::string(error.what()).size() < 1200);
    CHECK_THAT(error.what(), ContainsSubstring("xxxx"));
  }
}

TEST_CASE("A gnuplot's own words are told, on one line") {
  const Impostor failing("printf 'line 3:\\n  undefined\\n' >&2; exit 7");
  CHECK_THROWS_WITH(failing.draw(), ContainsSubstring("ended with status 7 and said: line 3: undefined"));
}

TEST_CASE("A picture that has no end is not whole, in each format") {
  CHECK(is_whole("<svg></svg>\n\n", "svg"));
  CHECK_FALSE(is_whole("<svg></sv", "svg"));
  CHECK_FALSE(is_whole("", "svg"));
  CHECK(is_whole("\x89PNG IEND\xAE\x42\x60\x82", "png"));
  CHECK_FALSE(is_whole("\x89PNG IEND", "png"));
  CHECK(is_whole("%PDF %%EOF\n", "pdf"));
  CHECK(is_whole(std::string("GIF89a\0;", 8), "gif"));
  CHECK_FALSE(is_whole("GIF89a", "gif"));
}

TEST_CASE("Pictures appear whole: the folder never holds anything unfinished") {
  const Folder folder;
  Studio studio;
  studio.folder = folder.path() / "碰撞 out";
  Figure figure(studio, "a");
  figure.script() << "plot sin(x)\n";
  CHECK_FALSE(fs::exists(studio.folder));
  figure.draw();
  CHECK(std::distance(fs::directory_iterator(studio.folder), fs::directory_iterator()) == 2);
}
