#include <cmath>

#include "app.h"
#include "craze/base/text/format.h"
#include "craze/recipe/length_text.h"

namespace craze::app {

namespace {

/// CLI11's own ranges take NaN, which compares with nothing.
CLI::Validator number_that(const std::function<bool(double)>& fits, const std::string& must) {
  return CLI::Validator(
      [=](std::string& text) -> std::string {
        double value = 0;
        if (!CLI::detail::lexical_cast(text, value)) return text + " is not a number";
        if (std::isfinite(value) && fits(value)) return {};
        return text + " is out of range: must be " + must;
      },
      "");
}

}  // namespace

CLI::Validator any_number() {
  return number_that([](double) { return true; }, "finite");
}

CLI::Validator not_negative() {
  return number_that([](double value) { return value >= 0; }, "at least 0");
}

CLI::Validator number_in(double low, double high) {
  return number_that([=](double value) { return value >= low && value <= high; },
                     fmt::format("{} to {}", low, high));
}

CLI::Option* add_length(CLI::App& verb, const std::string& name, Length& length,
                        const std::string& help) {
  const auto take = [&length, name](const std::string& text) {
    const auto given = parse_length(text);
    if (!given || !std::isfinite(given->number()) || given->number() < 0) {
      throw CLI::ValidationError(
          name, text + " is not a number of at least 0, nor such a length as 2mm or 1%");
    }
    length = *given;
  };
  return verb.add_option_function<std::string>(name, take, help)->type_name("LENGTH");
}

}  // namespace craze::app
