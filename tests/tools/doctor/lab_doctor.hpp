// The doctor on the hosts of a lab.
#ifndef GEMINGA_TESTS_TOOLS_DOCTOR_LAB_DOCTOR_HPP
#define GEMINGA_TESTS_TOOLS_DOCTOR_LAB_DOCTOR_HPP

#include <gtest/gtest.h>

#include <boost/json/value.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "support/lab.hpp"

namespace geminga::tools {

using Codes = std::vector<std::string>;

/// The codes of a document of findings.
[[nodiscard]] Codes codes_in(const std::string& text);
/// Whether the doctor may listen to whole packets.
enum class Rights : std::uint8_t { all, none };
/// The document of the doctor on a host.
[[nodiscard]] std::string examined(const system::Lab& lab, std::size_t host, Rights rights = Rights::all);
/// Asks until the doctor finds this and nothing else, as long as the test's patience lasts.
[[nodiscard]] ::testing::AssertionResult comes_to(const system::Lab& lab, std::size_t host, const Codes& wanted,
                                                  Rights rights = Rights::all);
/// How the only finding was seen; empty where there is not exactly one.
[[nodiscard]] std::string seen_on(const system::Lab& lab, std::size_t host);

/// Runs a program of the system on a host, which has to succeed.
void must_run(const system::Lab& lab, std::size_t host, const std::vector<std::string>& words);
/// Writes a file of /proc/sys/net of a host.
void set_kernel(const system::Lab& lab, std::size_t host, const std::string& name, const std::string& value);

}  // namespace geminga::tools

#endif
