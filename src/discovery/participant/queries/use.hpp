// The use of services: whether anybody asks for one, or a chain goes through it.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_USE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_USE_HPP

#include <optional>
#include <set>
#include <string>

#include "discovery/matching/conversions/converter.hpp"
#include "discovery/matching/search.hpp"

namespace geminga::participant {

/// Lives for one answer: the converters that chains go through are looked up once.
class Use {
 public:
  /// Whether somebody asks for it, or a chain for somebody goes through it.
  [[nodiscard]] bool is_of(const matching::Search& search, const registry::PublicationEntry& entry) {
    return search.is_used(entry) || is_in_chain(search, entry);
  }

  [[nodiscard]] bool is_in_chain(const matching::Search& search, const registry::PublicationEntry& entry) {
    if (!matching::is_converter(entry.publication.attributes)) return false;
    if (!converters_) converters_ = search.converters_in_use();
    return converters_->contains(matching::place_of(entry));
  }

 private:
  std::optional<std::set<std::string>> converters_;  ///< when the first was asked for
};

}  // namespace geminga::participant

#endif
