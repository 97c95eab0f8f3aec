#include "first_contact/figure/interruption.hpp"

#include <array>
#include <csignal>

namespace first_contact::figure {

namespace {

#ifdef SIGHUP
constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
#else
constexpr std::array signals{SIGINT, SIGTERM};
#endif

using Handler = void (*)(int);

volatile std::sig_atomic_t come = 0;
std::array<Handler, signals.size()> before{};

extern "C" void take_down(int signal) { come = signal; }

}  // namespace

Interruption::Interruption() {
  come = 0;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    before[i] = std::signal(signals[i], take_down);
    if (before[i] == SIG_IGN) std::signal(signals[i], SIG_IGN);
  }
}

Interruption::~Interruption() {
  for (std::size_t i = 0; i < signals.size(); ++i)
    if (before[i] != SIG_ERR) std::signal(signals[i], before[i]);
}

void Interruption::check() const {
  if (come != 0) throw Interrupted(come);
}

}  // namespace first_contact::figure
