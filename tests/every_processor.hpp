#pragma once
#include <hwy/highway.h>

/// Runs something once for each kind of processor that this one can stand for, and leaves the best chosen
/// again.
template <class Something>
void on_every_processor(const Something& something) {
  const struct Afterwards {
    ~Afterwards() {
      hwy::SetSupportedTargetsForTest(0);
      hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
  } afterwards;
  for (const auto kind : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(kind);
    hwy::GetChosenTarget().Update(kind);
    something(hwy::TargetName(kind));
  }
}
