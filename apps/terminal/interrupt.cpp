#include "terminal/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace craze::app {

namespace {

// A signal handler reaches nothing but what is global.
volatile std::sig_atomic_t caught = 0;

void on_interrupt(int signal) {
  caught = signal;
}

}  // namespace

void catch_interrupt() {
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    action.sa_handler = on_interrupt;
    // No SA_RESTART: what waits for a stream returns.
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(signal, &action, nullptr);
  }
}

bool was_interrupted() {
  return caught != 0;
}

int interrupt_code() {
  return 128 + caught;
}

}  // namespace craze::app
