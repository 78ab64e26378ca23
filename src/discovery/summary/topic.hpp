// The topic of a question between sites: a class, by its rank where both have the same ontology, by its IRI otherwise.
#ifndef GEMINGA_DISCOVERY_SUMMARY_TOPIC_HPP
#define GEMINGA_DISCOVERY_SUMMARY_TOPIC_HPP

#include <compare>
#include <cstdint>
#include <string>

namespace geminga::summary {

/// Names a site in the world: random bits that its bridge keeps. 0 is no site.
enum class SiteId : std::uint64_t {};

/// A class. `digest` is that of the ontology that numbers it, and 0 where `iri` names it.
struct Topic {
  std::uint64_t digest = 0;
  std::uint32_t rank = 0;
  std::string iri{};
  friend auto operator<=>(const Topic&, const Topic&) = default;
};

/// The last word of the subject on which a topic is asked for and answered: letters and digits, the same on every host.
/// Two IRIs with one word are told apart by the messages.
[[nodiscard]] std::string subject_word(const Topic& topic);

}  // namespace geminga::summary

#endif
