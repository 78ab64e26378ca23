#include "discovery/gcnp/specification.hpp"

#include <fstream>

namespace geminga::gcnp {

std::vector<Example> examples(std::string_view block) {
  std::ifstream stream(GEMINGA_SOURCE_DIR "/src/discovery/gcnp/GCNP.md");
  std::vector<Example> found;
  bool is_inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      is_inside = std::string_view(line).substr(3) == block;
    } else if (is_inside && line.starts_with("= ")) {
      found.back().expected = line.substr(2);
    } else if (is_inside) {
      found.push_back({line, line});
    }
  }
  return found;
}

}  // namespace geminga::gcnp
