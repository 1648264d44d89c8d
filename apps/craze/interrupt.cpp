#include "interrupt.h"

#include <csignal>

namespace craze::app {

namespace {

// A signal handler reaches nothing but what is global.
volatile std::sig_atomic_t interrupt_count = 0;

void on_interrupt(int) {
  interrupt_count = 1;
}

}  // namespace

void catch_interrupt() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
}

bool was_interrupted() {
  return interrupt_count != 0;
}

}  // namespace craze::app
