#pragma once

#include <map>
#include <string>

namespace eerie::bench {

/// Counters of every benchmark that ran, by its name.
using Counters = std::map<std::string, std::map<std::string, double>>;

/// What the stages of the reference impact do for a particle and step, over what this machine was
/// seen to do in the same run. Prints nothing where the benchmarks that it needs did not run.
void print_roofline(const Counters& counters);

}  // namespace eerie::bench
