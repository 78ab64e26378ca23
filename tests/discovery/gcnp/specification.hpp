// The worked examples of src/discovery/gcnp/GCNP.md, as the tests walk them.
#ifndef GEMINGA_TESTS_DISCOVERY_GCNP_SPECIFICATION_HPP
#define GEMINGA_TESTS_DISCOVERY_GCNP_SPECIFICATION_HPP

#include <string>
#include <string_view>
#include <vector>

namespace geminga::gcnp {

/// A line of an example, and the line behind `=`; if there is none, the line itself.
struct Example {
  std::string line;
  std::string expected;
};

/// The examples of the fenced block with this name; none if there is no such block.
[[nodiscard]] std::vector<Example> examples(std::string_view block);

}  // namespace geminga::gcnp

#endif
