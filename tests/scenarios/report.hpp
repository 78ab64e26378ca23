// How a run is told to a reader, or to a program.
#ifndef GEMINGA_TESTS_SCENARIOS_REPORT_HPP
#define GEMINGA_TESTS_SCENARIOS_REPORT_HPP

#include <cstdint>
#include <ostream>

#include "scenarios/conditions.hpp"
#include "scenarios/simulation.hpp"
#include "scenarios/sites.hpp"

namespace geminga::scenarios {

/// The cost of the run on this machine; not the same on another one.
struct Cost {
  double real_seconds = 0;
  std::uint64_t peak_octets = 0;  ///< of memory, of the whole process
};

/// The table at the end of a run.
void print_report(std::ostream& out, const Conditions& conditions, const Result& result, const Cost& cost);
/// The table of a world of sites.
void print_sites(std::ostream& out, const SiteConditions& conditions, const SiteResult& result, const Cost& cost);
/// One JSON document with the figures of print_report(); times in seconds.
void print_json(std::ostream& out, const Conditions& conditions, const Result& result, const Cost& cost);

}  // namespace geminga::scenarios

#endif
