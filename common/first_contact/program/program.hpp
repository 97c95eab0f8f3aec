#pragma once
#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "first_contact/figure/figure.hpp"
#include "first_contact/files/output.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/program/numbers.hpp"
#include "first_contact/program/report.hpp"

namespace first_contact::program {

/// What every chapter shares: options, `--help`, `--json`, `--lang`, `--out`, figures, and the exit status:
/// 0, or 2 for bad usage (a line on standard error names the option, its value and the rule), or 1 for a
/// failure.
///
///     int main(int argc, char** argv) {
///       Program program("plane", "01_plane", {"A moving sphere meets a plane.", "球面與平面之間的碰撞。"});
///       double radius = 1;
///       program.option("--radius", radius, "r", {"radius of the sphere", "球的半徑"}, not_negative);
///       return program.run(argc, argv, [&] {
///         ...
///         program.row("t", contact->time, {"time of impact", "碰撞時間"}).result("/contact/time");
///       });
///     }
class Program {
 public:
  /// \param name  of the program
  /// \param purpose  one line for `--help`
  /// \param chapter  the folder of the chapter, also of its figures: "01_plane"
  Program(std::string name, const std::string& chapter, const Text& purpose);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  /// A rule for a number: it returns what the number must be if it is not that, else nothing.
  using Rule = std::function<std::string(double)>;

  ///@{
  /// Options with their default values; vectors are comma-separated, `--p1=-1,8` and `--p1 -1,8` alike.
  void option(const std::string& name, double& value, const std::string& letters, const Text& help,
              const Rule& rule = {});
  void option(const std::string& name, long& value, const std::string& letters, const Text& help,
              const Rule& rule = {});
  void option(const std::string& name, Vector& value, const std::string& letters, const Text& help);
  void option(const std::string& name, Eigen::Vector2d& value, const std::string& letters, const Text& help,
              const Rule& rule = {}, Range range = Range::finite);
  void option(const std::string& name, Plane& value, const std::string& letters, const Text& help);
  void option(const std::string& name, std::string& value, const std::string& letters, const Text& help);
  void option(const std::string& name, std::string& value, const std::vector<std::string>& choices,
              const Text& help);
  ///@}

  /// Was this option given on the command line?
  bool given(const std::string& name) const;

  /// Makes something of an option's value, or refuses that value in the option's name: what `make` throws as
  /// std::invalid_argument or std::runtime_error becomes bad usage (exit status 2).
  template <class Make>
  auto checked(const char* name, Make make) -> decltype(make()) {
    return checked(std::vector<std::string>{name}, make);
  }
  /// The same for what is made of several options: those are named that the user gave, else the first.
  template <class Make>
  auto checked(const std::vector<std::string>& names, Make make) -> decltype(make()) {
    try {
      return make();
    } catch (const std::exception& error) {
      throw Refused(told(names) + ": " + error.what());
    }
  }

  /// Reads the command line, checks all of it, runs the chapter, then prints the report or the JSON.
  int run(int argc, char** argv, const std::function<void()>& chapter);

  /// What is printed for a reader.
  Report& report();
  /// A number that has been told to the reader, and is told to others by the rest of the line.
  template <class Value>
  class Told {
   public:
    /// What was told, and where else it may go.
    Told(Program& program, const Value& value) : program_(program), value_(value) {}

    /// Also a result of `--json`, at that place.
    const Told& result(const std::string& place) const {
      program_.result(place, value_);
      return *this;
    }
    /// Also a number that the notes show by that name.
    const Told& value(const std::string& name) const {
      program_.value(name, value_);
      return *this;
    }

   private:
    Program& program_;
    Value value_;
  };
  /// A row of the report, as Report::row has it, and a number for all who want it:
  ///
  ///     program.row("t", time, {"time of impact", "碰撞時間"}).result("/contact/time").value("time");
  template <class Value>
  Told<Value> row(const std::string& equation, const Value& number, const Text& meaning) {
    report().row(equation, number, meaning);
    return {*this, number};
  }
  ///@{
  /// A result that `--json` prints, at a place that a JSON pointer names (RFC 6901), such as "/impacts/0/speed".
  /// A vector is [x, y, z], what is not there is null; what is infinite or no number is refused.
  void result(const std::string& place, std::nullptr_t);
  void result(const std::string& place, bool value);
  void result(const std::string& place, double value);
  void result(const std::string& place, long value);
  void result(const std::string& place, const std::string& value);
  void result(const std::string& place, const std::vector<double>& value);
  void result(const std::string& place, const Vector& value);
  void result(const std::string& place, const char* value) { result(place, std::string(value)); }
  void result(const std::string& place, const Shown& value) { result(place, value.number); }
  template <std::integral Whole>
  void result(const std::string& place, Whole value) {
    result(place, static_cast<long>(value));
  }
  template <class Value>
  void result(const std::string& place, const std::optional<Value>& value) {
    value ? result(place, *value) : result(place, nullptr);
  }
  ///@}
  /// A list among the results that may stay empty; its items are "/impacts/0", "/impacts/1" and so on.
  void result_list(const std::string& place);
  ///@{
  /// One more number of this run, which the notes show by this name: `--values FILE` writes them all, as JSON;
  /// one that this scene does not have, such as a quotient by zero, is null.
  void value(const std::string& name, double number);
  void value(const std::string& name, const Shown& number) { value(name, number.number); }
  template <std::integral Whole>
  void value(const std::string& name, Whole number) {
    value(name, static_cast<double>(number));
  }
  ///@}
  /// Is nobody there for the report, nor for the notes? With `--json` alone, studies that go to them can be left
  /// out.
  bool results_alone() const;
  /// The language of this run.
  Language language() const;
  /// Text in the language of this run.
  std::string say(const Text& text) const { return text.in(language()); }
  /// Gives a figure's script a variable of that name, for a label in the language that the user chose.
  void label(figure::Figure& figure, std::string_view variable, const Text& text) const {
    figure.script() << variable << " = \"" << say(text) << "\"\n";
  }
  /// False with `--no-figures`.
  bool draws() const;
  /// Where figures go and how they are drawn.
  const figure::Studio& studio() const;

 private:
  std::string told(const std::vector<std::string>& names) const;
  void add(const std::string& name, const std::string& letters, const Text& help, const std::string& value,
           std::function<void(const std::string&)> take);
  void run_chapter(const std::function<void()>& chapter);
  int execute(int argc, char** argv, const std::function<void()>& chapter);

  struct Inside;
  std::unique_ptr<Inside> inside_;
};

/// Rules for numbers.
std::string not_negative(double value);
std::string positive(double value);
std::string at_most_one(double value);  ///< in [0, 1], such as a coefficient of restitution

}  // namespace first_contact::program
