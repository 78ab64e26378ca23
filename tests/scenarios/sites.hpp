// A world of sites: light models of sites with the real summaries, on a modelled supercluster.
#ifndef GEMINGA_TESTS_SCENARIOS_SITES_HPP
#define GEMINGA_TESTS_SCENARIOS_SITES_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/time.hpp"
#include "scenarios/simulation.hpp"

namespace geminga::scenarios {

/// Classes of the ontology that have none below them, and classes with ten of these below each.
inline constexpr std::size_t site_leaves = 1000;
inline constexpr std::size_t site_middles = 100;

/// Each site offers services of some leaves of an ontology of 1111 classes in three levels, and is interested in some
/// leaves and classes above ten of them (src/discovery/summary/SCALE.md).
struct SiteConditions {
  std::uint64_t seed = 1;
  std::size_t sites = 1000;
  std::size_t clusters = 10;
  std::size_t concepts = 60;         ///< leaves that a site offers services of
  std::size_t leaf_interests = 8;    ///< of a site
  std::size_t middle_interests = 2;  ///< of a site
  double other_ontology = 0.1;       ///< the share of sites that have another ontology
  /// Interests begin within this time.
  base::Duration start = std::chrono::minutes(10);
  base::Duration time = std::chrono::minutes(60);
  /// A service of a site comes or goes so often, ± 50 %.
  base::Duration change = std::chrono::minutes(1);
  base::Duration leaf_delay = std::chrono::milliseconds(20);     ///< between a site and its cluster
  base::Duration gateway_delay = std::chrono::milliseconds(80);  ///< between two clusters
  double loss = 0;                                               ///< the share of messages that a receiver misses
  /// Each interest asks as many sites for an expansion as offer so many services together.
  std::uint64_t expanded = 10;
};

/// The figures that were measured, and those that the formulae of SCALE.md give.
struct SiteResult {
  std::uint64_t questions = 0;  ///< sent
  std::uint64_t answers = 0;
  double received_octets = 0;  ///< of a site in a second
  double sent_octets = 0;
  double gateway_octets = 0;            ///< between clusters in a second
  double expected_received = 0;         ///< octets of a site in a second
  double remembered = 0;                ///< answers that a site keeps, on average
  double expected_remembered = 0;       ///< interests times sites times the share that offers
  std::size_t missing = 0;              ///< offerers that an interested site does not know in the end
  std::size_t surplus = 0;              ///< offerers that it knows and that offer nothing any more
  std::size_t pairs = 0;                ///< of an interest and a site that offers it
  std::vector<base::Duration> told;     ///< from the beginning of an interest to each first answer
  std::uint64_t expansions = 0;         ///< sites that were asked for one
  std::uint64_t unanswered = 0;         ///< of them, those that did not answer four times
  double listing_octets = 0;            ///< of a site in a second: expansions and listings that it receives
  std::vector<base::Duration> listed;   ///< from the first request for an expansion until all its pages are there
  std::vector<base::Duration> changed;  ///< from a change of magnitude to each interested site's knowledge
};

/// The means of a site by the formulae of SCALE.md, "What a site receives", without loss and changes.
struct SiteExpectation {
  double remembered = 0;       ///< answers
  double received_octets = 0;  ///< in a second
};
[[nodiscard]] SiteExpectation expectation(const SiteConditions& conditions);

/// Equal conditions give equal results.
[[nodiscard]] SiteResult simulate_sites(const SiteConditions& conditions, const OnProgress& progress = {});

}  // namespace geminga::scenarios

#endif
