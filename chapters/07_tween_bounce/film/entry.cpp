#include "entry.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "film.hpp"
#include "first_contact/files/decimal.hpp"
#include "first_contact/files/printable.hpp"

using first_contact::printable;
using first_contact::shortest;
using nlohmann::json;

namespace tween_bounce {

namespace {

constexpr int deepest = 16;
constexpr std::size_t quoted = 60;

std::string joined(const std::string& place, const std::string& name) {
  return place.empty() ? name : place + "." + name;
}

std::string counted(const std::string& place, std::size_t i) { return place + "[" + std::to_string(i) + "]"; }

/// Looks on while a text is read: the reader itself would take the last of two members with one name.
class Watch {
 public:
  bool operator()(int depth, json::parse_event_t event, const json& value) {
    using Event = json::parse_event_t;
    if (depth > deepest)
      throw FilmError(place() + ": must not be nested deeper than " + std::to_string(deepest));
    if (event == Event::key) return name(value.get<std::string>());
    if (event == Event::object_end || event == Event::array_end) return open_.pop_back(), true;
    if (!open_.empty() && open_.back().is_list) ++open_.back().count;
    if (event == Event::object_start) open_.push_back({false, 0, "", {}});
    if (event == Event::array_start) open_.push_back({true, 0, "", {}});
    return true;
  }

  /// Where the value stands that would be read next.
  std::string next_place() {
    if (!open_.empty()) ++open_.back().count;
    return place();
  }

 private:
  struct Open {
    bool is_list;
    std::size_t count;  // of its parts that have begun
    std::string last;   // of its names
    std::set<std::string> names;
  };

  std::string place() const {
    std::string all;
    for (const Open& open : open_)
      all = open.is_list ? counted(all, std::max<std::size_t>(open.count, 1) - 1) : joined(all, open.last);
    return printable(all);
  }

  bool name(const std::string& text) {
    Open& object = open_.back();
    object.last = text;
    if (!object.names.insert(text).second) throw FilmError(place() + ": must not be given twice");
    return true;
  }

  std::vector<Open> open_;
};

// What stands in a text between two marks.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t first = text.find(begin) + begin.size();
  return text.substr(first, text.find(end, first) - first);
}

// The place and the reason, of "[...] parse error at line 3, column 7: syntax error while parsing value - unexpected ...".
FilmError no_json(const json::parse_error& error) {
  const std::string all = error.what();
  std::string reason = all.substr(std::min(all.size(), all.find(" - ") + 3));
  for (std::size_t colon; (colon = reason.find(": ")) != reason.npos;) reason.replace(colon, 1, ",");
  return FilmError(between(all, "parse error at ", ": ") + ": must be JSON (" + printable(reason, 300) + ")");
}

// The number, of "[...] number overflow parsing '1e999'".
FilmError too_large(const std::string& place, const json::out_of_range& error) {
  const std::string number = printable(between(error.what(), "'", "'"), quoted);
  return FilmError(place + ": " + number + ": must stay within the range of numbers");
}

}  // namespace

Entry Entry::of(const std::string& text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw FilmError("begins with the mark of UTF-16: must be UTF-8");
  Watch watch;
  try {
    const auto look = [&](int depth, json::parse_event_t event, json& value) {
      return watch(depth, event, value);
    };
    auto whole = std::make_shared<const json>(json::parse(text, look));
    Entry all(whole, *whole, "");
    all.must_be_object();
    return all;
  } catch (const json::parse_error& error) {
    throw no_json(error);
  } catch (const json::out_of_range& error) {
    throw too_large(watch.next_place(), error);
  }
}

Entry::Entry(std::shared_ptr<const json> whole, const json& value, std::string place)
    : whole_(std::move(whole)), value_(&value), place_(std::move(place)) {}

void Entry::refuse(const std::string& rule) const {
  const std::string value = value_->dump(-1, ' ', false, json::error_handler_t::replace);
  const std::string where = place_.empty() ? "film" : printable(place_);
  throw FilmError(where + ": " + printable(value, quoted) + ": " + rule);
}

void Entry::must_be_object() const {
  if (!value_->is_object()) refuse("must be an object, { }");
}

std::optional<Entry> Entry::find(const std::string& name) const {
  must_be_object();
  const auto found = value_->find(name);
  if (found == value_->end()) return std::nullopt;
  return Entry(whole_, *found, joined(place_, name));
}

Entry Entry::member(const std::string& name) const {
  if (auto found = find(name)) return *found;
  throw FilmError(joined(printable(place_), name) + ": is missing");
}

void Entry::only(std::initializer_list<const char*> names) const {
  must_be_object();
  std::string all;
  for (const char* name : names) all += (all.empty() ? "" : ", ") + std::string(name);
  for (const auto& [name, value] : value_->items())
    if (std::find(names.begin(), names.end(), name) == names.end())
      Entry(whole_, value, joined(place_, name)).refuse("is none of " + all);
}

std::string Entry::one_of(std::initializer_list<const char*> names) const {
  std::string all, found;
  for (const char* name : names) {
    all += (all.empty() ? "" : ", ") + std::string(name);
    if (!find(name)) continue;
    if (!found.empty()) refuse("must have one of " + all + ", not more");
    found = name;
  }
  if (found.empty()) refuse("must have one of " + all);
  return found;
}

std::vector<Entry> Entry::items(std::size_t most) const {
  if (!value_->is_array()) refuse("must be a list, [ ]");
  if (value_->empty()) refuse("must not be empty");
  if (value_->size() > most) refuse("must have at most " + std::to_string(most) + " parts");
  std::vector<Entry> all;
  for (const json& part : *value_) all.push_back(Entry(whole_, part, counted(place_, all.size())));
  return all;
}

bool Entry::is_word() const { return value_->is_string(); }
bool Entry::is_list() const { return value_->is_array(); }

std::string Entry::word() const {
  if (!is_word()) refuse("must be a text");
  return value_->get<std::string>();
}

bool Entry::truth() const {
  if (!value_->is_boolean()) refuse("must be true or false");
  return value_->get<bool>();
}

double Entry::number(double least, double most) const {
  if (!value_->is_number()) refuse("must be a number");
  const double number = value_->get<double>();
  if (!(number >= least && number <= most))
    refuse("must be from " + shortest(least) + " to " + shortest(most));
  return number;
}

std::vector<double> Entry::numbers(std::size_t count, double most) const {
  if (!is_list() || value_->size() != count)
    refuse("must be a list of " + std::to_string(count) + " numbers");
  std::vector<double> all;
  for (const Entry& part : items(count)) all.push_back(part.number(-most, most));
  return all;
}

first_contact::Vector Entry::vector() const {
  const std::vector<double> all = numbers(3, most_length);
  return {all[0], all[1], all[2]};
}

}  // namespace tween_bounce
