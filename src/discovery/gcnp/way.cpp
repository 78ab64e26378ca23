#include "discovery/gcnp/way.hpp"

#include "discovery/gcnp/attribute.hpp"
#include "discovery/gcnp/parameters.hpp"

namespace geminga::gcnp {

void append_way(std::vector<Parameter>& parameters, const Way& way) {
  if (way.hops == 0) return;
  for (Parameter& one : parameters) {
    if (one.key == "hops" || one.key == "path") one.key = std::string(attribute_prefix) + one.key;
  }
  append(parameters, "hops", way.hops);
  append_stated(parameters, "path", way.path);
}

}  // namespace geminga::gcnp
