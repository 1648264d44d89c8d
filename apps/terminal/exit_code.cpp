#include "terminal/exit_code.h"

#include <exception>
#include <new>
#include <string>

#include "craze/context.h"
#include "craze/error.h"
#include "terminal/error_line.h"
#include "terminal/interrupt.h"

namespace craze::app {

int exit_code_of(MessageStyle style, const std::function<int()>& run) {
  try {
    return run();
  } catch (const Cancelled&) {
    print_stopped(style);
    return interrupt_code();
  } catch (const Error& e) {
    print_error(style, e.what());
    return e.kind() == ErrorKind::usage ? wrong_usage : failed;
  } catch (const std::bad_alloc&) {
    print_error(style, "out of memory (mesh.edge): try a longer one, or a smaller input");
  } catch (const std::exception& e) {
    print_error(style, std::string("unexpected failure: ") + e.what());
  }
  return failed;
}

}  // namespace craze::app
