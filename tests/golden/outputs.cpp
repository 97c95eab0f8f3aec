#include <algorithm>
#include <csignal>
#include <fstream>
#include <future>

#include "catch.hpp"
#include "places.hpp"
#include "run_program.hpp"

namespace fs = std::filesystem;

namespace {

long files_in(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

void check_refused(const Run& run, const std::vector<std::string>& named) {
  CAPTURE(run.err);
  CHECK(run.status == 2);
  CHECK(run.out.empty());
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  for (const auto& part : named) CHECK(run.err.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("A table goes to standard output by its device, before the report, and the device stays") {
  const Run run = run_program("tween_bounce", {"--csv", "/dev/stdout", "--no-figures"});
  CHECK(run.status == 0);
  CHECK(run.out.starts_with("t,y\n"));
  CHECK(run.out.find("\n\n") != std::string::npos);
  CHECK(fs::exists("/dev/stdout"));
}

TEST_CASE("A table that is a symbolic link is written where the link leads") {
  const TemporaryFolder folder;
  fs::create_symlink("target.csv", folder.path() / "link.csv");
  CHECK(run_program("tween_bounce", {"--csv", "link.csv", "--no-figures"}, folder.path()).status == 0);
  CHECK(fs::is_symlink(folder.path() / "link.csv"));
  CHECK(content_of(folder.path() / "target.csv").starts_with("t,y\n"));
}

TEST_CASE("What cannot be written is refused in the name of the option that says where, always alike") {
  const TemporaryFolder folder;
  const fs::path casts = folder.path() / "casts.csv";
  { std::ofstream(casts) << "0,0,5,0,0,0,1\n"; }
  for (const std::string file : {"/dev/full", "/nowhere/file", "."}) {
    CAPTURE(file);
    check_refused(run_program("plane", {"--values", file, "--no-figures"}, folder.path()),
                  {"--values " + file});
    check_refused(run_program("tween_bounce", {"--csv", file, "--no-figures"}, folder.path()),
                  {"--csv " + file});
    check_refused(
        run_program("general_sphere", {"--casts", casts.string(), "--results", file}, folder.path()),
        {"--results " + file});
  }
  check_refused(run_program("plane", {"--out", "casts.csv"}, folder.path()), {"--out casts.csv"});
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE(
    "Casts that cannot be read are refused: a folder, a table without a cast, what never ends its line") {
  const TemporaryFolder folder;
  const auto with = [&](const std::string& content) {
    std::ofstream(folder.path() / "in.csv", std::ios::binary) << content;
    return run_program("general_sphere", {"--casts", "in.csv", "--results", "out.csv", "--no-figures"},
                       folder.path());
  };
  check_refused(run_program("general_sphere", {"--casts", ".", "--results", "out.csv"}, folder.path()),
                {"--casts .", "not a folder"});
  check_refused(with(""), {"--casts in.csv", "at least one cast"});
  check_refused(with("x0,y0,z0,x1,y1,z1,r\n"), {"--casts in.csv", "at least one cast"});
  check_refused(with("0,0,5,0,0,0," + std::string(100000, '1') + "x\n"), {"line 1", "(100013 bytes)"});
  check_refused(with("0,0,5,0,0,\x1b[31m,1\n"), {"line 1", "\\x1b[31m"});
  CHECK_FALSE(fs::exists(folder.path() / "out.csv"));
  CHECK(with("\xEF\xBB\xBFx0,y0,z0,x1,y1,z1,r\r\n0,0,5,0,0,0,1\r\n").status == 0);
  CHECK(content_of(folder.path() / "out.csv").starts_with("hit,time,"));
}

TEST_CASE("Results do not take the place of the casts that they answer") {
  const TemporaryFolder folder;
  const std::string casts = "0,0,5,0,0,0,1\n";
  std::ofstream(folder.path() / "in.csv") << casts;
  for (const std::string same : {"in.csv", "./in.csv"})
    check_refused(run_program("general_sphere", {"--casts", "in.csv", "--results", same}, folder.path()),
                  {"--results " + same, "another file than --casts"});
  CHECK(content_of(folder.path() / "in.csv") == casts);
}

TEST_CASE("Two outputs of one run are two files") {
  const TemporaryFolder folder;
  check_refused(run_program("tween_bounce", {"--csv", "same", "--values", "./same"}, folder.path()),
                {"--values ./same", "another file than --csv"});
  CHECK_FALSE(std::filesystem::exists(folder.path() / "same"));
}

TEST_CASE("Two outputs that can be no files are not taken for one, but refused for what they are") {
  const TemporaryFolder folder;
  fs::create_symlink("loop", folder.path() / "loop");
  check_refused(
      run_program("tween_bounce", {"--csv", "loop", "--values", std::string(300, 'a')}, folder.path()),
      {"cannot be written ("});
}

TEST_CASE("Where one output cannot be written, no other is: neither a table nor a picture") {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "in.csv") << "0,0,5,0,0,0,1\n";
  for (const std::string file : {"none/values", "."}) {
    check_refused(
        run_program("tween_bounce", {"--csv", "a.csv", "--values", file, "--out", "a"}, folder.path()),
        {"--values " + file});
    check_refused(run_program("tween_bounce", {"--film", "hall", "--csv", file, "--out", "a"}, folder.path()),
                  {"--csv " + file});
    check_refused(
        run_program("general_sphere", {"--casts", "in.csv", "--results", file, "--out", "a"}, folder.path()),
        {"--results " + file});
  }
  check_refused(run_program("tween_bounce", {"--csv", "a.csv", "--out", "in.csv"}, folder.path()),
                {"--out in.csv"});
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("A program that cannot print says so: also its help") {
  for (const std::string option : {"--help", "--json", "--no-figures"}) {
    CAPTURE(option);
    const Run run = run_into("/dev/full", "plane", {option, "--no-figures"});
    CHECK(run.status == 1);
    CHECK(run.err.find("standard output") != std::string::npos);
  }
}

TEST_CASE("Where there is no room for a script, TMPDIR is named, which it is written in, and the reason") {
  const TemporaryFolder folder;
  const std::string plane = std::string(first_contact::places::build) + "/bin/plane";
  const Run run = run_command("sh", {"-c", "trap '' XFSZ; ulimit -f 0; exec \"$0\" --out \"$1\"", plane,
                                     (folder.path() / "out").string()});
  CAPTURE(run.err);
  CHECK(run.status == 1);
  CHECK(run.err.starts_with("plane: TMPDIR "));
  CHECK(run.err.find(std::make_error_code(std::errc::file_too_large).message()) != std::string::npos);
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
}

TEST_CASE("Two runs into one folder at the same time leave each picture whole") {
  const TemporaryFolder folder;
  const auto run = [&] { return run_program("plane", {"--out", folder.path().string()}).status; };
  auto other = std::async(std::launch::async, run);
  CHECK(run() == 0);
  CHECK(other.get() == 0);
  for (const auto& entry : fs::directory_iterator(folder.path()))
    if (entry.path().extension() == ".svg")
      CHECK(content_of(entry.path()).find("</svg>") != std::string::npos);
  CHECK(files_in(folder.path()) == 8);
}

TEST_CASE("A run that is stopped while it draws leaves no picture that is not whole, and nothing beside") {
  const TemporaryFolder folder, temporary;
  const fs::path slow = folder.path() / "slow";
  { std::ofstream(slow) << "#!/bin/sh\necho '<svg>' >figure-02.svg\nsleep 30\n"; }
  fs::permissions(slow, fs::perms(0755));
  const fs::path out = folder.path() / "out";
  const Run run = run_stopped(SIGTERM, {{"GNUPLOT", slow.string()}, {"TMPDIR", temporary.path().string()}},
                              "plane", {"--out", out.string()});
  CHECK(run.status == SIGTERM);
  CHECK(fs::exists(out / "figure-02.gp"));
  CHECK(files_in(out) == 1);
  CHECK(fs::is_empty(temporary.path()));
}
