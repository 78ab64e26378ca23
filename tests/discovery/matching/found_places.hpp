// The places of class expressions as the reasoner finds them, each found once.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_FOUND_PLACES_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_FOUND_PLACES_HPP

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "discovery/matching/degrees/degree.hpp"
#include "reasoning/vocabulary/expression.hpp"

namespace geminga::matching {

/// Requires vocabularies that are prepared for expressions, or have no ontology. Its placings borrow it.
class FoundPlaces {
 public:
  FoundPlaces() = default;
  FoundPlaces(const FoundPlaces&) = delete;
  FoundPlaces& operator=(const FoundPlaces&) = delete;

  [[nodiscard]] Placing placing() {
    return [this](const vocabulary::Vocabulary& by, const std::string& expression, ParticipantId) {
      return place(by, expression);
    };
  }

 private:
  std::shared_ptr<const vocabulary::Place> place(const vocabulary::Vocabulary& by, const std::string& expression) {
    if (!by.is_prepared()) return nullptr;
    const auto [known, is_new] = found_.try_emplace({by.digest(), expression});
    if (!is_new) return known->second;
    const auto read = by.read(expression, 400);
    if (!read) return nullptr;
    auto place = std::make_shared<const vocabulary::Place>(by.place(*read));
    if (place->is_satisfiable) known->second = std::move(place);
    return known->second;
  }

  std::map<std::pair<std::uint64_t, std::string>, std::shared_ptr<const vocabulary::Place>> found_;
};

}  // namespace geminga::matching

#endif
