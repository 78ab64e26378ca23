#include "discovery/gcnp/way.hpp"

#include "discovery/gcnp/attribute.hpp"
#include "discovery/gcnp/parameters.hpp"

namespace geminga::gcnp {

void append_way(std::vector<Parameter>& parameters, const Way& way) {
  if (way.hops != 0) {
    for (Parameter& one : parameters) {
      if (one.key == path_key) one.key = std::string(attribute_prefix) + one.key;
    }
    append(parameters, "hops", way.hops);
    append_stated(parameters, path_key, way.path);
  }
  if (!way.is_reachable) append(parameters, "reachable", "no");
}

}  // namespace geminga::gcnp
