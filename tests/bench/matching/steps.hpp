// The longest step and the whole work of what another host can make a matcher do.
#ifndef GEMINGA_TESTS_BENCH_MATCHING_STEPS_HPP
#define GEMINGA_TESTS_BENCH_MATCHING_STEPS_HPP

namespace geminga::matching {

/// Prints the rows: converters that change, publications and requests that concern many, departures, clashing numbers.
void measure_steps();

}  // namespace geminga::matching

#endif
