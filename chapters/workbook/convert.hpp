#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "workbook/value.hpp"

/// C++ types as values, and back: numbers, optional, vector, array, pair, and structs of up to eight members.
namespace workbook {

namespace members {

struct Any {
  template <class T>
  operator T() const;
};
/// Of how many members is T made?
template <class T, class... Any_>
constexpr std::size_t count() {
  if constexpr (sizeof...(Any_) > 8)
    return 0;
  else if constexpr (requires { T{Any_{}..., Any{}}; })
    return count<T, Any_..., Any>();
  else
    return sizeof...(Any_);
}

/// The members of a struct, by reference.
template <class T>
constexpr auto of(T& object) {
  constexpr std::size_t n = count<std::remove_const_t<T>>();
  static_assert(n >= 1 && n <= 7, "a struct of an exercise has one to seven members");
  if constexpr (n == 1) {
    auto& [a] = object;
    return std::tie(a);
  } else if constexpr (n == 2) {
    auto& [a, b] = object;
    return std::tie(a, b);
  } else if constexpr (n == 3) {
    auto& [a, b, c] = object;
    return std::tie(a, b, c);
  } else if constexpr (n == 4) {
    auto& [a, b, c, d] = object;
    return std::tie(a, b, c, d);
  } else if constexpr (n == 5) {
    auto& [a, b, c, d, e] = object;
    return std::tie(a, b, c, d, e);
  } else if constexpr (n == 6) {
    auto& [a, b, c, d, e, f] = object;
    return std::tie(a, b, c, d, e, f);
  } else {
    auto& [a, b, c, d, e, f, g] = object;
    return std::tie(a, b, c, d, e, f, g);
  }
}

template <class>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class>
inline constexpr bool is_tuple = false;
template <class... T>
inline constexpr bool is_tuple<std::tuple<T...>> = true;
template <class A, class B>
inline constexpr bool is_tuple<std::pair<A, B>> = true;
template <class T, std::size_t n>
inline constexpr bool is_tuple<std::array<T, n>> = true;

}  // namespace members

template <class T>
Value to_value(const T& object) {
  if constexpr (std::is_same_v<T, bool>) {
    return {Value::Kind::truth, object ? 1.0 : 0.0, {}};
  } else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
    return {Value::Kind::whole, static_cast<double>(object), {}};
  } else if constexpr (std::is_floating_point_v<T>) {
    return {Value::Kind::number, static_cast<double>(object), {}};
  } else if constexpr (members::is_optional<T>) {
    return object ? to_value(*object) : Value{};
  } else if constexpr (members::is_vector<T>) {
    Value list{Value::Kind::list, 0, {}};
    for (const auto& part : object) list.parts.push_back(to_value(part));
    return list;
  } else if constexpr (members::is_tuple<T>) {
    return std::apply(
        [](const auto&... part) {
          return Value{Value::Kind::group, 0, {to_value(part)...}};
        },
        object);
  } else {
    return std::apply(
        [](const auto&... part) {
          return Value{Value::Kind::group, 0, {to_value(part)...}};
        },
        members::of(object));
  }
}

template <class T>
void from_value(const Value& value, T& object) {
  const auto fill = [&](auto&... part) {
    std::size_t i = 0;
    (from_value(value.parts.at(i++), part), ...);
  };
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    object = static_cast<T>(value.number);
  } else if constexpr (members::is_optional<T>) {
    object.reset();
    if (value.kind != Value::Kind::nothing) from_value(value, object.emplace());
  } else if constexpr (members::is_vector<T>) {
    object.resize(value.parts.size());
    for (std::size_t i = 0; i < object.size(); ++i) from_value(value.parts[i], object[i]);
  } else if constexpr (members::is_tuple<T>) {
    std::apply(fill, object);
  } else {
    std::apply(fill, members::of(object));
  }
}

/// The arguments of a function, kept.
template <class>
struct Arguments;
template <class Result_, class... Arguments_>
struct Arguments<Result_(Arguments_...)> {
  using Result = Result_;
  using Tuple = std::tuple<std::decay_t<Arguments_>...>;
};

/// What a function answers to a value that holds its arguments.
template <class Signature>
Value answer_of(Signature* function, const Value& input) {
  typename Arguments<Signature>::Tuple arguments;
  from_value(input, arguments);
  return to_value(std::apply(function, arguments));
}

}  // namespace workbook
