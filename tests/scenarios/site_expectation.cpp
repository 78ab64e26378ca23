#include <algorithm>
#include <cmath>

#include "discovery/summary/limits.hpp"
#include "scenarios/sites.hpp"

namespace geminga::scenarios {

SiteExpectation expectation(const SiteConditions& conditions) {
  // Of a message with its subject and what NATS adds, about.
  constexpr double question_octets = 100;
  constexpr double answer_octets = 97;
  const double n = static_cast<double>(conditions.sites);
  const double duration = std::chrono::duration<double>(conditions.time).count();
  const auto concepts = static_cast<double>(conditions.concepts);
  const auto of_leaves = static_cast<double>(conditions.leaf_interests);
  const auto of_middles = static_cast<double>(conditions.middle_interests);
  const double offers_leaf = 1 - std::pow(1 - 1.0 / site_leaves, concepts);
  const double offers_middle = 1 - std::pow(1 - 10.0 / site_leaves, concepts);
  const double remembered = n * (of_leaves * offers_leaf + of_middles * offers_middle);
  const double interests = of_leaves + of_middles;
  // Each class that somebody wants is a topic by rank in each ontology and one by IRI, which sites of each ask.
  const auto wanted_of = [n](double all, double each) { return all * (1 - std::pow(1 - 1 / all, n * each)); };
  const double wanted = wanted_of(site_leaves, of_leaves) + wanted_of(site_middles, of_middles);
  const double topics = wanted * (conditions.other_ontology > 0 ? 4 : 2);
  // Of the sites that want a topic the first one asks again, after a little more than the least time.
  const double rounds = std::floor(duration / (0.84 * std::chrono::duration<double>(summary::ask_again).count()));
  const double questions = 2 * n * interests + rounds * topics;
  // At first each site asks for itself, and those that want the same hear the answers, too.
  const double askers = std::max(1.0, n * interests / wanted);
  const double answers = remembered * (askers / 2 + rounds);
  return {.remembered = remembered,
          .received_octets = (questions * question_octets + answers * answer_octets) / duration};
}

}  // namespace geminga::scenarios
