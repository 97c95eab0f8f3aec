#include <bit>
#include <clocale>
#include <cstdlib>
#include <future>
#include <limits>

#include "catch.hpp"
#include "first_contact/files/decimal.hpp"
#include "first_contact/files/input.hpp"
#include "first_contact/files/output.hpp"
#include "first_contact/files/printable.hpp"
#include "folder.hpp"

using namespace first_contact;
namespace fs = std::filesystem;

TEST_CASE(
    "A symbolic link is followed, also to a file that is not there yet: the target is written, the link "
    "stays") {
  const Folder folder;
  const bool exists = GENERATE(true, false);
  const fs::path target = folder.path() / "target", first = folder.path() / "first",
                 second = folder.path() / "second";
  if (exists) folder.file("target", "old");
  fs::create_symlink("target", first);
  fs::create_symlink(first, second);
  write_file(second, "new");
  CHECK(fs::is_symlink(first));
  CHECK(fs::is_symlink(second));
  CHECK(read_file(target) == "new");
  CHECK(folder.files() == 3);
}

TEST_CASE("A link that leads back to itself is refused by name") {
  const Folder folder;
  fs::create_symlink("b", folder.path() / "a");
  fs::create_symlink("a", folder.path() / "b");
  CHECK_THROWS_AS(write_file(folder.path() / "a", "x"), FileError);
  CHECK(folder.files() == 2);
}

TEST_CASE("A file that is replaced keeps its permissions, and one that must not be written is not replaced") {
  const Folder folder;
  const fs::path file = folder.file("a", "old");
  fs::permissions(file, fs::perms(0600));
  write_file(file, "new");
  CHECK(fs::status(file).permissions() == fs::perms(0600));
  CHECK(read_file(file) == "new");
}

TEST_CASE("A device is written to and stays a device, and what cannot be written there is noticed") {
  if (!fs::is_character_file("/dev/full")) return;
  CHECK_THROWS_AS(write_file("/dev/full", "x"), FileError);
  CHECK(fs::is_character_file("/dev/full"));
  write_file("/dev/null", "x");
  CHECK(fs::is_character_file("/dev/null"));
}

#ifdef __unix__
TEST_CASE("A pipe with a name is written to, and read from") {
  const Folder folder;
  const fs::path pipe = folder.path() / "pipe";
  REQUIRE(std::system(("mkfifo '" + pipe.string() + "'").c_str()) == 0);
  auto reader = std::async(std::launch::async, [&] { return read_file(pipe); });
  write_file(pipe, "through");
  CHECK(reader.get() == "through");
  CHECK(fs::is_fifo(pipe));
  CHECK(folder.files() == 1);
}
#endif

TEST_CASE("A write that fails leaves what was there, and nothing beside it") {
  const Folder folder;
  fs::create_directory(folder.path() / "taken");
  CHECK_THROWS_WITH(write_file(folder.path() / "taken", "x"),
                    ContainsSubstring("taken: must be a file, not a folder"));
  CHECK_THROWS_AS(write_file(folder.path() / "missing" / "a", "x"), FileError);
  CHECK_THROWS_AS(write_file("", "x"), FileError);
  CHECK(folder.files() == 1);
}

TEST_CASE("Of many runs that write one file at the same time, the last one's content stays, whole") {
  const Folder folder;
  const fs::path file = folder.path() / "a";
  std::vector<std::future<void>> runs;
  for (char letter = 'a'; letter < 'i'; ++letter)
    runs.push_back(std::async(std::launch::async, [&, letter] {
      for (int i = 0; i < 50; ++i) write_file(file, std::string(10000, letter));
    }));
  for (auto& run : runs) run.get();
  const std::string content = read_file(file);
  CHECK(content == std::string(10000, content[0]));
  CHECK(folder.files() == 1);
}

TEST_CASE("What cannot be read is refused by name: a folder, what is missing, what has no end") {
  const Folder folder;
  CHECK_THROWS_WITH(read_file(folder.path()), ContainsSubstring("must be a file, not a folder"));
  CHECK_THROWS_WITH(read_file(folder.path() / "none"),
                    ContainsSubstring("none: must be a file that exists and can be read"));
  CHECK(read_file(folder.file("a", std::string("\0b\n", 3))) == std::string("\0b\n", 3));
}

TEST_CASE("A name with a zero in it is no file's, and a message shows all of it") {
  const Folder folder;
  const fs::path name = folder.file("nul", "read by mistake").string() + std::string("\0.obj", 5);
  CHECK_THROWS_WITH(read_file(name),
                    ContainsSubstring("nul\\x00.obj: must be a file that exists and can be read"));
}

TEST_CASE("Of what has no end no more is read than is asked for") {
  if (!fs::is_character_file("/dev/zero")) return;
  CHECK_THROWS_WITH(read_file("/dev/zero", 1000), "/dev/zero: must end within 1000 bytes");
}

TEST_CASE("Whether a file can be written is known before, and asking leaves nothing") {
  const Folder folder;
  const fs::path file = folder.file("a", "old");
  CHECK_NOTHROW(require_writable(file));
  CHECK_NOTHROW(require_writable(folder.path() / "b"));
  CHECK_NOTHROW(require_folder(folder.path() / "c" / "d"));
  CHECK_THROWS_WITH(require_writable(folder.path()), ContainsSubstring("must be a file, not a folder"));
  CHECK_THROWS_WITH(require_writable(folder.path() / "none" / "b"), ContainsSubstring("cannot be written"));
  CHECK_THROWS_WITH(require_folder(file), ContainsSubstring("cannot be made"));
  CHECK_THROWS_WITH(require_folder(file / "c"), ContainsSubstring("cannot be made"));
  CHECK(read_file(file) == "old");
  CHECK(folder.files() == 1);
}

TEST_CASE("A folder of a name that leads nowhere is refused with the reason, before and when it is made") {
  const Folder folder;
  const fs::path loop = folder.path() / "loop", nowhere = folder.path() / "nowhere";
  fs::create_symlink("loop", loop);
  fs::create_symlink("none", nowhere);
  for (const fs::path& name :
       {loop, loop / "a", nowhere, nowhere / "a", folder.path() / std::string(300, 'a')}) {
    CAPTURE(name);
    CHECK_THROWS_AS(require_folder(name), FileError);
    CHECK_THROWS_AS(make_folder(name), FileError);
    CHECK_THROWS_WITH(require_folder(name), ContainsSubstring("cannot be made ("));
    CHECK_THROWS_WITH(make_folder(name), ContainsSubstring("cannot be made ("));
  }
  CHECK(folder.files() == 2);
}

TEST_CASE("A byte order mark is no part of a text, wherever the text goes on") {
  CHECK(without_byte_order_mark("\xEF\xBB\xBFv") == "v");
  CHECK(without_byte_order_mark("v\xEF\xBB\xBF") == "v\xEF\xBB\xBF");
  CHECK(without_byte_order_mark("\xEF\xBB") == "\xEF\xBB");
}

TEST_CASE("What a message quotes is one line, and does nothing to a terminal") {
  CHECK(printable("a\nb\r\t") == "a\\nb\\r\\t");
  CHECK(printable(std::string("\x1b[31m\0", 6)) == "\\x1b[31m\\x00");
  CHECK(printable("\x7f\xff\xc0\x80") == "\\x7f\\xff\\xc0\\x80");
  CHECK(printable("\xc2\x9b") == "\\xc2\\x9b");  // a terminal's control sequence introducer
  CHECK(printable("碰撞") == "碰撞");
  CHECK(printable(std::string("碰").substr(0, 2)) == "\\xe7\\xa2");
  CHECK(printable(std::string(30000000, 'x')) == std::string(quoted_bytes, 'x') + "... (30000000 bytes)");
}

TEST_CASE("A number is the double nearest to its digits, and too small a one is the nearest too") {
  CHECK(decimal("0.1") == 0.1);
  CHECK(decimal("-.5e1") == -5.0);
  CHECK(decimal("5.") == 5.0);
  CHECK(decimal("1e-400") == 0.0);
  CHECK(std::signbit(decimal("-1e-400").value()));
  CHECK(decimal("4.9e-324") == std::numeric_limits<double>::denorm_min());
  CHECK(decimal("1.7976931348623157e308") == std::numeric_limits<double>::max());
  CHECK(decimal("-1e309") == -std::numeric_limits<double>::infinity());
  CHECK(decimal("INF") == std::numeric_limits<double>::infinity());
  CHECK(std::isnan(decimal("nan").value()));
  CHECK(decimal("9007199254740993") == 9007199254740992.0);  // a tie, to even
}

TEST_CASE("What is not a number, all of it, is none") {
  for (const char* text :
       {"", "+1", "--1", "-", ".", "e5", "1e", "1e+", "1 ", " 1", "0x10", "1,5", "1m", "infinit", "nan(1)"}) {
    CAPTURE(text);
    CHECK_FALSE(decimal(text));
  }
}

TEST_CASE("The fewest digits give the same double back") {
  for (const double value : {0.1, 1.0 / 3, 5e-324, -1.7976931348623157e308, 0.0, 123456789.123456789})
    CHECK(decimal(shortest(value)) == value);
  CHECK(shortest(0.1) == "0.1");
}
