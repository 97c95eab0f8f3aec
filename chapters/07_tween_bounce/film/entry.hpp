#pragma once
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "first_contact/geometry/space.hpp"

namespace tween_bounce {

/// What is wrong in a film file. The message names the place, the value and the rule: "keys[2].time: 0.5: must be
/// after the key before, 0.7".
class FilmError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A value of a JSON file that knows where it stands, so that whoever does not like it can say so.
class Entry {
 public:
  /// The whole of a text, which must be one object, without a name that stands twice in one object.
  /// \throws FilmError that names the line of the text, or the place.
  static Entry of(const std::string& text);

  /// \throws FilmError "place: value: rule".
  [[noreturn]] void refuse(const std::string& rule) const;

  ///@{
  /// An object's member: one that must be there, or one that may.
  /// \throws FilmError if this is no object, or the member is missing.
  Entry member(const std::string& name) const;
  std::optional<Entry> find(const std::string& name) const;
  ///@}
  /// Refuses all members but these.
  void only(std::initializer_list<const char*> names) const;
  /// The one member of these that is there.
  /// \throws FilmError if there is none, or more than one.
  std::string one_of(std::initializer_list<const char*> names) const;
  /// The parts of a list.
  /// \throws FilmError if this is no list, or an empty one, or one of more than that many parts.
  std::vector<Entry> items(std::size_t most) const;
  /// Is it a text?
  bool is_word() const;
  /// Is it a list?
  bool is_list() const;
  /// A text.
  std::string word() const;
  /// True or false.
  bool truth() const;
  /// A number from `least` to `most`.
  double number(double least, double most) const;
  /// So many numbers, none of them larger than `most` in size.
  std::vector<double> numbers(std::size_t count, double most) const;
  /// Three lengths.
  first_contact::Vector vector() const;

 private:
  Entry(std::shared_ptr<const nlohmann::json> whole, const nlohmann::json& value, std::string place);
  void must_be_object() const;

  std::shared_ptr<const nlohmann::json> whole_;
  const nlohmann::json* value_;
  std::string place_;
};

/// Makes something of an entry, or refuses it in its own name: what `make` throws as std::invalid_argument.
template <class Make>
auto made_of(const Entry& entry, Make make) -> decltype(make()) {
  try {
    return make();
  } catch (const FilmError&) {
    throw;
  } catch (const std::invalid_argument& error) {
    entry.refuse(error.what());
  }
}

}  // namespace tween_bounce
