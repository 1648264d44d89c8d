#include "growth_note.h"

#include <string>

#include "craze/base/text/format.h"
#include "terminal/error_line.h"

namespace craze::app {

void print_growth(const RunOptions& options, const std::optional<PlanGrowth>& growth,
                  const GrowthWords& words) {
  if (!growth || options.quiet) return;
  std::string told = fmt::format("{} goes on from {} {} to {}", words.whole, growth->before,
                                 words.pieces, growth->after);
  if (growth->piece) {
    told += fmt::format("; {} {:06}, which has {} of its {}, gets the others", words.file,
                        *growth->piece, growth->held, growth->wanted);
  }
  print_note(options.style, told);
}

}  // namespace craze::app
