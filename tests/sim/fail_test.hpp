// Where the checkers of a simulated world complain in a test.
#ifndef GEMINGA_TESTS_SIM_FAIL_TEST_HPP
#define GEMINGA_TESTS_SIM_FAIL_TEST_HPP

#include <string>

namespace geminga::sim {

/// Fails the test that is running. A program gives its world another place to complain to and does not link this.
void fail_test(const std::string& complaint);

}  // namespace geminga::sim

#endif
