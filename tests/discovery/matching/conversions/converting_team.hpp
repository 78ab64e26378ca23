// A small team with converters, and its events, for tests of the matcher.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_CONVERSIONS_CONVERTING_TEAM_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_CONVERSIONS_CONVERTING_TEAM_HPP

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "discovery/matching/taxonomy.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {

/// Frames A to K, which only Frame subsumes. Declared: A to B for 2, C to D for 1.
inline vocabulary::Vocabulary frames() {
  Taxonomy taxonomy;
  taxonomy.sub("Ball", "Tracked").sub("MyA", "A").sub("Ghost", "Frame").unsatisfiable("Ghost");
  for (char each = 'A'; each <= 'K'; ++each) taxonomy.sub(std::string(1, each), "Frame");
  taxonomy.convert("A", "B", 2).convert("C", "D", 1);
  return taxonomy.classified();
}

/// The value of `converts`: "<http://example.org/B>><http://example.org/C>".
inline std::string converts(std::string_view from, std::string_view to) {
  return "<" + iri(from) + ">><" + iri(to) + ">";
}

inline registry::PublicationEntry converter(const ServiceKey& key, std::string_view from, std::string_view to,
                                            int cost = 1) {
  registry::PublicationEntry entry = offer(key, TextIdentity{"converter"});
  entry.publication.address = "10.0.0." + std::to_string(std::to_underlying(key.participant));
  entry.publication.port = static_cast<std::uint16_t>(6000 + key.number);
  entry.publication.attributes = {{"converts", converts(from, to)}, {"cost", std::to_string(cost)}};
  return entry;
}

inline registry::SubscriptionEntry asks(const ServiceKey& key, std::string_view representation,
                                        std::uint32_t convert = any_cost, std::uint32_t limit = 0) {
  registry::SubscriptionEntry entry = request(key, semantic("Tracked", representation), limit);
  entry.subscription.convert = convert;
  return entry;
}

inline registry::PublicationEntry ball(const ServiceKey& key, std::string_view representation) {
  return offer(key, semantic("Ball", representation));
}

/// Events as in_words(), and behind it "A>B>C cost via" where the service is converted.
inline std::vector<std::string> told_chains(Matcher& matcher) {
  std::vector<std::string> words;
  for (const Event& event : matcher.take_events()) {
    std::string line = in_words(event);
    if (event.chain != nullptr) {
      std::string names = matcher.choices().chain_words(event.to, *event.chain);
      const auto replace = [&names](std::string_view what, std::string_view by) {
        for (auto at = names.find(what); at != std::string::npos; at = names.find(what)) {
          names.replace(at, what.size(), by);
        }
      };
      replace(":", "");  // the empty prefix, which stands for the namespace of the test's ontology
      line += " " + names + " " + std::to_string(event.chain->cost) + " " + event.chain->via;
    }
    words.push_back(line);
  }
  return words;
}

class ConvertersTest : public testing::Test {
 protected:
  Matcher matcher{frames()};

  std::vector<std::string> told() { return told_chains(matcher); }
};

}  // namespace geminga::matching

#endif
