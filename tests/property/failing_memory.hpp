#pragma once

namespace first_contact {

/// While it lives, one request for memory of this program fails with std::bad_alloc, from whatever thread it comes: the
/// next after so many.
struct FailingOnce {
  explicit FailingOnce(long after);
  ~FailingOnce();
  FailingOnce(const FailingOnce&) = delete;
  FailingOnce& operator=(const FailingOnce&) = delete;
  bool has_failed() const;
};

}  // namespace first_contact
