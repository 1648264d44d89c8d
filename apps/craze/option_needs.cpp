#include "option_needs.h"

#include <algorithm>

#include "craze/error.h"

namespace craze::app {

void check_needs(const CLI::App& verb, const std::vector<OptionNeed>& needs) {
  for (const OptionNeed& need : needs) {
    if (need.is_asked()) continue;
    for (const std::string& name : need.options) {
      if (verb.get_option(name)->empty()) continue;
      throw Error(ErrorKind::usage, "an option that would do nothing", name,
                  "give " + need.needed + " too, or leave it out");
    }
  }
}

std::vector<std::string> options_of_groups(const CLI::App& verb,
                                           const std::vector<std::string>& groups) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options()) {
    const auto& group = option->get_group();
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) continue;
    names.push_back(option->get_name());
  }
  return names;
}

}  // namespace craze::app
