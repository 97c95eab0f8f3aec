#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <vector>

#include "first_contact/sweep/contact.hpp"

namespace digest {

/// Answers, as one number that changes with any of their bits (Fowler, Noll and Vo's FNV-1a).
class Record {
 public:
  /// \param show  also print each number, to find out where two machines part
  explicit Record(bool show) : show_(show) {}

  void add(std::uint64_t bits) {
    for (int i = 0; i < 8; ++i) hash_ = (hash_ ^ (bits >> 8 * i & 0xff)) * 0x100000001b3;
  }
  void add(double value) {
    if (show_) std::printf(" %a", value);
    add(std::bit_cast<std::uint64_t>(value));
  }
  void add(bool value) { count(value); }
  void count(std::size_t value) {
    if (show_) std::printf(" #%zu", value);
    add(static_cast<std::uint64_t>(value));
  }
  template <class Derived>
  void add(const Eigen::DenseBase<Derived>& numbers) {
    for (Eigen::Index j = 0; j < numbers.cols(); ++j)
      for (Eigen::Index i = 0; i < numbers.rows(); ++i) add(numbers(i, j));
  }
  void add(const first_contact::Contact& contact) {
    add(contact.time);
    add(contact.points);
    add(contact.normal);
    count(static_cast<std::size_t>(contact.feature));
    if (contact.triangle != first_contact::no_triangle) count(contact.triangle);
    add(contact.point());
  }
  template <class Value>
  void add(const std::optional<Value>& value) {
    count(value.has_value());
    if (value) add(*value);
  }
  void add(const std::vector<std::size_t>& numbers) {
    count(numbers.size());
    for (const std::size_t number : numbers) count(number);
  }
  /// One answer is complete.
  void next() {
    if (show_) std::printf("\n");
    ++answers_;
  }

  std::uint64_t hash() const { return hash_; }
  std::size_t answers() const { return answers_; }

 private:
  bool show_;
  std::uint64_t hash_ = 0xcbf29ce484222325;
  std::size_t answers_ = 0;
};

/// A verb of the library, and how it is asked.
struct Verb {
  const char* name;
  void (*ask)(Record&);
};

constexpr int cases = 10000;

std::vector<Verb> shape_verbs();
std::vector<Verb> sweep_verbs();
std::vector<Verb> box_verbs();
std::vector<Verb> surface_verbs();
std::vector<Verb> motion_verbs();

}  // namespace digest
