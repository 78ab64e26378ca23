// Which services somebody uses.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_USE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_USE_HPP

#include <optional>
#include <set>
#include <string>

#include "discovery/matching/conversions/converter.hpp"
#include "discovery/matching/matcher.hpp"

namespace geminga::participant {

/// For the time of one answer: what chains go through is looked up once.
class Use {
 public:
  /// Whether somebody asks for it, or a chain for somebody goes through it.
  [[nodiscard]] bool is_of(const matching::Matcher& matcher, const registry::PublicationEntry& entry) {
    return matcher.is_used(entry) || is_in_chain(matcher, entry);
  }

  [[nodiscard]] bool is_in_chain(const matching::Matcher& matcher, const registry::PublicationEntry& entry) {
    if (!matching::is_converter(entry.publication.attributes)) return false;
    if (!converters_) converters_ = matcher.converters_in_use();
    return converters_->contains(matching::place_of(entry));
  }

 private:
  std::optional<std::set<std::string>> converters_;  ///< when the first was asked for
};

}  // namespace geminga::participant

#endif
