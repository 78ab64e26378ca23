// Read once for all tests: GoogleTest, and what of the standard library most of them use. A test includes what it uses
// all the same, as the preset dev compiles without this file.
#ifndef GEMINGA_TESTS_PRECOMPILED_HPP
#define GEMINGA_TESTS_PRECOMPILED_HPP

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#endif
