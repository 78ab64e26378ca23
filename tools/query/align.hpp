// Another participant's ontology aligned with that of this host.
#ifndef GEMINGA_QUERY_ALIGN_HPP
#define GEMINGA_QUERY_ALIGN_HPP

#include <string>

#include "geminga/client.hpp"
#include "query/command.hpp"

namespace geminga::query {

struct AlignFlags {
  std::string participant;  ///< empty: nothing is to be aligned
  std::string folder;       ///< to be made
  bool is_open = false;     ///< also over channels that are not sealed
  bool is_conservative = false;
  bool has_subsumptions = false;
};

/// Has geminga-ontology fetch what the participant offers and align it, and prints the links, and what would be
/// understood with them. The folder gets the ontology and the links; nothing comes into force.
[[nodiscard]] shell::ExitStatus align(const Context& context, Client& client, const AlignFlags& flags);

}  // namespace geminga::query

#endif
