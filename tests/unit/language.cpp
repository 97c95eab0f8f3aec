// The reports' columns in a terminal.
#include "first_contact/program/language.hpp"

#include "catch.hpp"

using first_contact::program::columns;
using first_contact::program::padded;

TEST_CASE("A Chinese character takes two columns, as its punctuation does, and a letter of mathematics one") {
  CHECK(columns("") == 0);
  CHECK(columns("t = 1") == 5);
  CHECK(columns("碰撞") == 4);
  CHECK(columns("〈，）") == 6);
  CHECK(columns("θ₁ − e² ⊥ V′") == 12);
}

TEST_CASE("A mark that stands over a letter takes no column of its own") {
  CHECK(columns("n\u0302") == 1);
  CHECK(columns("V\u20D7") == 1);
}

TEST_CASE("What is padded ends at the same column in either language, and nothing is cut off") {
  for (const std::string text : {"time", "時間", "n\u0302"}) CHECK(columns(padded(text, 7) + "|") == 8);
  CHECK(padded("碰撞時間", 7) == "碰撞時間");
}
