// The two sides of `query why`. Either may be one that nobody has stated.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_SIDES_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_SIDES_HPP

#include <expected>
#include <optional>

#include "base/time.hpp"
#include "discovery/gcnp/request.hpp"
#include "discovery/participant/knowledge/resolver.hpp"
#include "discovery/participant/knowledge/self.hpp"
#include "discovery/participant/queries/checks.hpp"

namespace geminga::participant {

/// An offer that is asked about.
struct Offered {
  registry::PublicationEntry entry;
  bool is_living = true;
  bool is_any_mode = false;  ///< it takes that of each request
};

/// The parts by which a side is resolved that nobody has stated.
struct Stating {
  const matching::Matcher& matcher;
  Resolver& resolver;
  const Self& self;
  base::Instant now;
};

/// Nothing where no request is asked about; 404 where there is none, 422 where a name or a text cannot be understood.
[[nodiscard]] std::expected<std::optional<Asked>, Error> asked_of(const Stating& by, const gcnp::QueryWhy& query);
/// Nothing where no offer is asked about. One without mode has the mode of the request, or any where there is none.
[[nodiscard]] std::expected<std::optional<Offered>, Error> offered_of(const Stating& by, const gcnp::QueryWhy& query,
                                                                      const std::optional<Asked>& asked);

}  // namespace geminga::participant

#endif
