// An ontology taken from providers, one after the other until it is whole (TRAVEL.md).
#ifndef GEMINGA_ONTOLOGY_TRAVEL_TAKING_HPP
#define GEMINGA_ONTOLOGY_TRAVEL_TAKING_HPP

#include <chrono>
#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geminga/client.hpp"
#include "ontology/travel/arrival.hpp"
#include "ontology/travel/candidates.hpp"

namespace geminga::ontology {

/// The ontology that is wanted.
struct Wish {
  std::string participant{};             ///< of the provider: an identifier or a name; empty: any
  std::string digest{};                  ///< empty: any, if all that is offered is the same
  std::uint64_t least_version = 0;       ///< 0: also those without a version
  bool is_newest = false;                ///< of several, the greatest version
  std::string connect{};                 ///< where the daemon is
  bool is_open = false;                  ///< also over channels that are not sealed
  std::chrono::milliseconds patience{};  ///< until there is a provider
  std::chrono::milliseconds time{};      ///< for all of it
};

struct Taken {
  Candidate provider;  ///< the last one
  Arrival arrival;     ///< whole
};

/// The reason why nothing was taken.
struct TakingError {
  enum class Kind : std::uint8_t {
    nobody,         ///< nobody offers it
    several,        ///< several are offered, and the wish does not say which one
    not_taken,      ///< no provider brought it whole
    timed_out,      ///< the time was over
    of_the_daemon,  ///< see `client`
  };
  Kind kind = Kind::nobody;
  std::string text;  ///< one line
  std::optional<ClientError> client{};
};

/// The candidates of a wish among all, in their order; of several ontologies the best one alone if is_newest.
[[nodiscard]] std::vector<Candidate> candidates_for(const Wish& wish, const std::vector<Candidate>& all);

/// Takes what is wished for. `warn` is told in one line of each provider that failed.
[[nodiscard]] std::expected<Taken, TakingError> take(const Wish& wish,
                                                     const std::function<void(std::string_view)>& warn);

}  // namespace geminga::ontology

#endif
