// What a program tells: a number given once reaches all who want it.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "catch.hpp"
#include "first_contact/program/program.hpp"

using namespace first_contact;
using namespace first_contact::program;

namespace {

/// What a program prints that tells of a tenth, a count, a vector and a rounded third.
std::string printed(std::vector<const char*> arguments) {
  Program program("told", "01_plane", {"Tells.", "說明。"});
  arguments.insert(arguments.begin(), {"told", "--no-figures"});
  std::ostringstream text;
  std::streambuf* const screen = std::cout.rdbuf(text.rdbuf());
  const int status =
      program.run(static_cast<int>(arguments.size()), const_cast<char**>(arguments.data()), [&] {
        program.row("t", 0.1, {"a tenth", ""}).result("/contact/time").value("time");
        program.row("n", std::size_t{1234567}, {"a count", ""}).result("/count").value("count");
        program.row("v", Vector(1, 2, 3), {"a vector", ""}).result("/vector");
        program.row("s", Shown{1.0 / 3, "0.33"}, {"a third", ""}).result("/third").value("third");
      });
  std::cout.rdbuf(screen);
  REQUIRE(status == 0);
  return text.str();
}

}  // namespace

TEST_CASE(
    "A number given once stands in the report, in --json and among the notes' values, the same to the last "
    "bit",
    "[program]") {
  const std::string report = printed({});
  CHECK(report.find("t = 0.1 ") != std::string::npos);
  CHECK(report.find("n = 1234567 ") != std::string::npos);
  CHECK(report.find("v = (1, 2, 3) ") != std::string::npos);
  CHECK(report.find("s = 0.33 ") != std::string::npos);

  const auto json = nlohmann::json::parse(printed({"--json"}));
  CHECK(json["contact"]["time"] == 0.1);
  CHECK(json["count"] == 1234567);
  CHECK(json["vector"] == std::vector<double>{1, 2, 3});
  CHECK(json["third"] == 1.0 / 3);

  const auto file = std::filesystem::temp_directory_path() / "first-contact-told-once.json";
  printed({"--values", file.c_str()});
  std::ifstream in(file);
  const auto values = nlohmann::json::parse(in);
  CHECK(values["time"] == 0.1);
  CHECK(values["count"] == 1234567);
  CHECK(values["third"] == 1.0 / 3);
  std::filesystem::remove(file);
}
