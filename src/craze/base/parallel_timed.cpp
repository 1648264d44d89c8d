// Loops one task after the other, each timed: what a run would take on many cores is printed when
// its threads end (CRAZE_WORK_AND_SPAN). For measuring alone.
#include <cxxabi.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "craze/base/executor.h"
#include "craze/base/work_and_span.h"

namespace craze {

namespace {

// Processor time since the process began, seconds: others on the machine do not add to it.
double now() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The function that a loop's body, a lambda, is in.
std::string name_of(const std::type_info& body) {
  int status = 0;
  char* readable = abi::__cxa_demangle(body.name(), nullptr, nullptr, &status);
  std::string name = status == 0 ? readable : body.name();
  std::free(readable);
  for (const std::string noise : {"craze::", "(anonymous namespace)::"}) {
    if (name.rfind(noise, 0) == 0) name.erase(0, noise.size());
  }
  return name.substr(0, name.find('('));
}

class Timed : public Executor {
 public:
  // Lines of fields between tabs: a row for each loop, then what comes after the last one.
  ~Timed() override {
    const double after = now() - end_;
    for (const auto& [name, row] : record_.rows()) {
      std::fprintf(stderr, "loop\t%s\t%lld\t%lld\t%.6f", name.c_str(),
                   static_cast<long long>(row.loops), static_cast<long long>(row.tasks),
                   row.before);
      for (const double seconds : row.inside) std::fprintf(stderr, "\t%.6f", seconds);
      std::fputc('\n', stderr);
    }
    if (!record_.rows().empty()) std::fprintf(stderr, "after\t%.6f\n", after);
  }

 private:
  // One task is a loop too, unless loops inside it have been added already.
  void alone(const Task& task, const std::type_info& body) override {
    const double start = now(), last = end_;
    task(0);
    if (end_ != last) return;
    record_.add(name_of(body) + ", alone", start - last, {now() - start});
    end_ = now();
  }

  void share_out(std::size_t n, const Task& task, const std::type_info& body) override {
    const double before = now() - end_;
    seconds_.resize(n);
    double start = now();
    for (std::size_t i = 0; i < n; ++i) {
      task(i);
      const double end = now();
      seconds_[i] = end - start;
      start = end;
    }
    record_.add(name_of(body), before, seconds_);
    end_ = now();  // what was added up is nobody's
  }

  WorkAndSpan record_;
  double end_ = 0;  // of the last loop
  std::vector<double> seconds_;
};

}  // namespace

std::shared_ptr<Executor> make_executor(int) {
  return std::make_shared<Timed>();
}

}  // namespace craze
