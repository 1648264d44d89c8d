// Tells ThreadSanitizer of an order that it cannot see: TBB's library is not compiled for it.
#pragma once

#if defined(__SANITIZE_THREAD__)
#define CRAZE_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CRAZE_THREAD_SANITIZER 1
#endif
#endif

#ifdef CRAZE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace craze {

/// A point in time shared by threads: what a thread did before it says passed() happens before what
/// another does after it says seen(). Nothing at all in other builds: it orders no memory.
class KnownOrder {
 public:
#ifdef CRAZE_THREAD_SANITIZER
  void passed() {
    __tsan_release(this);
  }
  void seen() {
    __tsan_acquire(this);
  }
#else
  void passed() {}
  void seen() {}
#endif
};

}  // namespace craze
