#include "first_contact/program/in_chinese.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace first_contact::program {

namespace {

constexpr std::string_view value = "{}", colon = ": ";

// What stands in a message where the pattern has {}, each as short as it can be and within one part of the message;
// nothing if it is another message.
std::optional<std::vector<std::string_view>> values_in(std::string_view message, std::string_view pattern) {
  std::vector<std::string_view> values;
  for (;;) {
    const std::size_t place = pattern.find(value);
    if (!message.starts_with(pattern.substr(0, place))) return std::nullopt;
    if (place == pattern.npos) return message == pattern ? std::optional(values) : std::nullopt;
    message.remove_prefix(place);
    pattern.remove_prefix(place + value.size());
    const std::string_view next = pattern.substr(0, pattern.find(value));
    const std::size_t end = next.empty() ? message.size() : message.find(next);
    if (end == message.npos || message.substr(0, end).find(colon) != message.npos) return std::nullopt;
    values.push_back(message.substr(0, end));
    message.remove_prefix(end);
  }
}

std::optional<std::string> said(std::string_view message);

// A value may be a saying itself.
std::string filled(std::string_view pattern, const std::vector<std::string_view>& values) {
  std::string text;
  for (const std::string_view each : values) {
    const std::size_t place = pattern.find(value);
    text.append(pattern.substr(0, place)).append(said(each).value_or(std::string(each)));
    pattern.remove_prefix(place + value.size());
  }
  return text.append(pattern);
}

std::optional<std::string> said(std::string_view message) {
  for (const auto& [english, chinese] : sayings())
    if (const auto values = values_in(message, english)) return filled(chinese, *values);
  return std::nullopt;
}

}  // namespace

std::string in_chinese(std::string_view message) {
  if (const auto whole = said(message)) return *whole;
  const std::size_t end = message.find(colon);
  if (end == message.npos) return std::string(message);
  const std::string_view first = message.substr(0, end);
  return said(first).value_or(std::string(first)) + "：" + in_chinese(message.substr(end + colon.size()));
}

}  // namespace first_contact::program
