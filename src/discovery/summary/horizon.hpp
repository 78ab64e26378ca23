// The knowledge that a site has of the world: which sites offer what it is interested in, and how much.
#ifndef GEMINGA_DISCOVERY_SUMMARY_HORIZON_HPP
#define GEMINGA_DISCOVERY_SUMMARY_HORIZON_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "base/time.hpp"
#include "discovery/summary/message.hpp"

namespace geminga::summary {

/// A site that offers something of an interest.
struct Offerer {
  SiteId site{};
  unsigned magnitude = 0;
  friend bool operator==(const Offerer&, const Offerer&) = default;
};

/// The interests of a site: the concepts that its subscriptions ask the world for. It carries what it asks for and not
/// the world: an answer about anything else is dropped. Not thread-safe.
class Horizon {
 public:
  /// `digest` is that of the site's own ontology; 0: none.
  Horizon(SiteId site, std::uint64_t digest) : site_(site), digest_(digest) {}

  /// Begins an interest in a concept; `rank` is its number in the own ontology, nothing where that does not know it.
  /// False: there are max_interests. An interest that is there stays as it is.
  bool want(const std::string& iri, std::optional<std::uint32_t> rank, base::Instant now);
  /// Ends an interest, and forgets what was answered.
  void end(const std::string& iri);
  /// The topics that an interest subscribes to.
  [[nodiscard]] std::vector<Topic> topics(const std::string& iri) const;

  /// Takes in a question or an answer of another site. A question for one of our topics is answered for us, too, so
  /// that ours can wait.
  void hear(const Message& message, base::Instant now, base::Random& random);
  /// When take_questions() has something to give; base::never: there are no interests.
  [[nodiscard]] base::Instant next_due() const { return dues_.empty() ? base::never : dues_.begin()->first; }
  /// The questions that are due, to be sent on the subjects of their topics.
  [[nodiscard]] std::vector<Message> take_questions(base::Instant now, base::Random& random);

  /// The sites that offer something of an interest, those with the most first, then by number. What was said
  /// remembered_for ago counts no more.
  [[nodiscard]] std::vector<Offerer> offerers(const std::string& iri, base::Instant now) const;
  /// The first of them that offer so many services together, by the least numbers of their magnitudes; all if these are
  /// not enough. Those are asked for an expansion.
  [[nodiscard]] std::vector<Offerer> enough(const std::string& iri, std::uint64_t services, base::Instant now) const;
  /// A site was not reachable: what it said is forgotten.
  void forget(SiteId site);

  /// Answers that are remembered.
  [[nodiscard]] std::size_t remembered() const { return remembered_; }
  /// Answers that were dropped because max_remembered were there.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

 private:
  struct Said {
    unsigned magnitude = 0;
    base::Instant at;
  };
  struct Interest {
    std::vector<Topic> topics;
    std::map<SiteId, Said> said;
  };
  struct Asking {
    std::string iri;  ///< of the interest
    base::Instant due = base::never;
  };
  using Topics = std::map<Topic, Asking>;

  void hear_answer(const Message& answer, base::Instant now);
  void forget_old(base::Instant now);
  void ask_at(Topics::iterator topic, base::Instant due);

  SiteId site_;
  std::uint64_t digest_;
  std::map<std::string, Interest, std::less<>> interests_;
  Topics topics_;
  std::set<std::pair<base::Instant, Topic>> dues_;
  std::size_t remembered_ = 0;
  std::uint64_t refused_ = 0;
};

}  // namespace geminga::summary

#endif
