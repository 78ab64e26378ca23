// The offers of a site to the world: how many services below which class, said to those who ask.
#ifndef GEMINGA_DISCOVERY_SUMMARY_OFFERINGS_HPP
#define GEMINGA_DISCOVERY_SUMMARY_OFFERINGS_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "base/time.hpp"
#include "discovery/summary/message.hpp"
#include "geminga/identity.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::summary {

/// Counts publications under every superclass of their concepts, as the registry files them, so that a question is one
/// look-up. Nothing is said of a topic that nobody asked for. Only concepts are summed up: services that are named by a
/// text or a number are not told to the world. For another ontology another one is made. Not thread-safe.
class Offerings {
 public:
  Offerings(SiteId site, vocabulary::Vocabulary vocabulary)
      : site_(site), vocabulary_(std::move(vocabulary)), digest_(vocabulary_.digest()) {}

  /// A publication of this identity has come, or is gone. O(superclasses).
  void add(const Identity& identity, base::Instant now) { change(identity, true, now); }
  void remove(const Identity& identity, base::Instant now) { change(identity, false, now); }
  /// How many services meet a topic.
  [[nodiscard]] std::uint32_t count(const Topic& topic) const;

  /// Takes in a question of another site. It is answered at a random moment, by all that is offered then, and changes
  /// are said for asked_for.
  void hear(const Message& question, base::Instant now, base::Random& random);
  /// When take_answers() has something to give; base::never: nothing is to be said.
  [[nodiscard]] base::Instant next_due() const { return dues_.empty() ? base::never : dues_.begin()->first; }
  /// The answers that are due, to be sent on the subjects of their topics.
  [[nodiscard]] std::vector<Message> take_answers(base::Instant now);
  /// Topics that somebody asked for.
  [[nodiscard]] std::size_t asked() const { return asked_.size(); }
  /// Questions that were dropped because max_asked topics were remembered.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

 private:
  struct Asked {
    base::Instant until;  ///< changes are said until then
    base::Instant due = base::never;
    base::Instant said = base::Instant::min();
    unsigned magnitude = 0;    ///< as it was last said
    bool is_question = false;  ///< a question is to be answered, whatever was said before
  };
  using Topics = std::map<Topic, Asked>;

  void change(const Identity& identity, bool is_there, base::Instant now);
  void changed(const Topic& topic, base::Instant now);
  void set_due(Topics::iterator one, base::Instant due);
  [[nodiscard]] std::uint32_t count_of_iri(const std::string& iri) const;
  void forget_old(base::Instant now);

  SiteId site_;
  vocabulary::Vocabulary vocabulary_;
  std::uint64_t digest_;
  std::map<vocabulary::ClassNumber, std::uint32_t> below_;     ///< services below each class, itself included
  std::map<std::string, std::uint32_t, std::less<>> unknown_;  ///< services by concepts that are no classes here
  Topics asked_;
  std::set<std::pair<base::Instant, Topic>> dues_;
  std::uint64_t refused_ = 0;
};

}  // namespace geminga::summary

#endif
