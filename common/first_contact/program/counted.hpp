#pragma once
#include <Eigen/Core>
#include <cmath>

/// \file
/// What a formula costs, counted while it runs. Any formula that is a template can be asked.

namespace first_contact::program {

/// How often each operation of arithmetic was done. A fused multiply-add is one multiplication and one addition;
/// a change of sign is free.
struct Operations {
  int additions = 0;        ///< and subtractions
  int multiplications = 0;  ///< of two numbers
  int divisions = 0;        ///< the dear ones, with
  int roots = 0;            ///< these
  int comparisons = 0;      ///< each may be a jump
};

/// A number that computes as a double does, and counts.
class Counted {
 public:
  /// A constant, or what is given: free.
  Counted(double value = 0) : value_(value) {}
  /// The number itself.
  double value() const { return value_; }

  ///@{
  /// Arithmetic, comparisons and functions: those of a double, and counted.
  friend Counted operator-(const Counted& a) { return -a.value_; }
  friend Counted operator+(const Counted& a, const Counted& b) {
    return ++done_.additions, a.value_ + b.value_;
  }
  friend Counted operator-(const Counted& a, const Counted& b) {
    return ++done_.additions, a.value_ - b.value_;
  }
  friend Counted operator*(const Counted& a, const Counted& b) {
    return ++done_.multiplications, a.value_ * b.value_;
  }
  friend Counted operator/(const Counted& a, const Counted& b) {
    return ++done_.divisions, a.value_ / b.value_;
  }
  Counted& operator+=(const Counted& b) { return *this = *this + b; }
  Counted& operator-=(const Counted& b) { return *this = *this - b; }
  Counted& operator*=(const Counted& b) { return *this = *this * b; }
  Counted& operator/=(const Counted& b) { return *this = *this / b; }

  friend bool operator==(const Counted& a, const Counted& b) {
    return ++done_.comparisons, a.value_ == b.value_;
  }
  friend bool operator<(const Counted& a, const Counted& b) {
    return ++done_.comparisons, a.value_ < b.value_;
  }
  friend bool operator<=(const Counted& a, const Counted& b) {
    return ++done_.comparisons, a.value_ <= b.value_;
  }
  friend bool operator>(const Counted& a, const Counted& b) { return b < a; }
  friend bool operator>=(const Counted& a, const Counted& b) { return b <= a; }

  friend Counted sqrt(const Counted& a) { return ++done_.roots, std::sqrt(a.value_); }
  friend Counted abs(const Counted& a) { return std::abs(a.value_); }
  friend Counted copysign(const Counted& a, const Counted& sign) {
    return std::copysign(a.value_, sign.value_);
  }
  friend Counted fma(const Counted& a, const Counted& b, const Counted& c) {
    return ++done_.multiplications, ++done_.additions, std::fma(a.value_, b.value_, c.value_);
  }
  ///@}

  /// What this thread does while `work` runs.
  template <class Work>
  static Operations in(const Work& work) {
    done_ = {};
    work();
    return done_;
  }

 private:
  static inline thread_local Operations done_;
  double value_;
};

}  // namespace first_contact::program

/// \cond  What Eigen must know of a scalar.
template <>
struct Eigen::NumTraits<first_contact::program::Counted> : Eigen::NumTraits<double> {
  using Real = first_contact::program::Counted;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum { RequireInitialization = 1 };
};
/// \endcond
