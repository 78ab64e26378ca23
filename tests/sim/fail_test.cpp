#include "sim/fail_test.hpp"

#include <gtest/gtest.h>

namespace geminga::sim {

void fail_test(const std::string& complaint) { ADD_FAILURE() << complaint; }

}  // namespace geminga::sim
