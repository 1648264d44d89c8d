// Distributions as a plan writes them.
#pragma once

#include <functional>
#include <string>

#include <toml++/toml.h>

#include "craze/job/plan/distribution.h"

namespace craze {

/// A value by itself, or a table: {uniform = [a, b]}, {log_uniform = [a, b]}, {normal = [mean, sd],
/// within = [a, b]}, {choice = [...], weights = [...]}, {linked = "key", factor = f, offset = o} or
/// {linked = "key", map = {word = value}}; and axes, where allowed: {values = [...]}, {linear = [a,
/// b, n]}, {log = [a, b, n]}. Numbers may be lengths with units: "4mm". Throws Error(usage) naming
/// `key` and the node's place.
Distribution read_distribution(const toml::node& node, const std::string& key, bool axes,
                               const std::function<std::string(const toml::node&)>& locate);

}  // namespace craze
