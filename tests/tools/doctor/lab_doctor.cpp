#include "tools/doctor/lab_doctor.hpp"

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <chrono>
#include <fstream>

#include "tools/clients/bench.hpp"

namespace geminga::tools {

Codes codes_in(const std::string& text) {
  const boost::json::value document = parsed(text);
  Codes codes;
  for (const auto& finding : document.at("findings").as_array()) codes.emplace_back(finding.at("code").as_string());
  return codes;
}

std::string examined(const system::Lab& lab, std::size_t host, Rights rights) {
  const std::string address = "127.0.0.1:" + std::to_string(lab.gcnp_port(host));
  std::vector<std::string> words;
  if (rights == Rights::none) words = {"/usr/bin/setpriv", "--bounding-set", "-net_raw"};
  words.insert(words.end(), {system::program("geminga-query"), "--connect", address, "--json", "doctor"});
  return system::run(lab.on(host, words)).said;
}

::testing::AssertionResult comes_to(const system::Lab& lab, std::size_t host, const Codes& wanted, Rights rights) {
  const auto end = std::chrono::steady_clock::now() + system::patience;
  std::string found;
  while (std::chrono::steady_clock::now() < end) {
    found = examined(lab, host, rights);
    if (codes_in(found) == wanted) return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << "found at last: " << found;
}

std::string seen_on(const system::Lab& lab, std::size_t host) {
  const boost::json::value document = parsed(examined(lab, host));
  const auto& findings = document.at("findings").as_array();
  return findings.size() == 1 ? std::string(findings[0].at("seen").as_string()) : "";
}

void must_run(const system::Lab& lab, std::size_t host, const std::vector<std::string>& words) {
  const system::Ran ran = system::run(lab.on(host, words));
  ASSERT_EQ(ran.status, 0) << words.front() << ": " << ran.said;
}

void set_kernel(const system::Lab& lab, std::size_t host, const std::string& name, const std::string& value) {
  lab.visit(host, [&] {
    std::ofstream file("/proc/sys/net/" + name);
    file << value << std::flush;
    EXPECT_TRUE(file.good()) << name;
  });
}

}  // namespace geminga::tools
