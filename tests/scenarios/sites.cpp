#include "scenarios/sites.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/assert.hpp"
#include "base/random.hpp"
#include "discovery/summary/horizon.hpp"
#include "discovery/summary/limits.hpp"
#include "discovery/summary/magnitude.hpp"
#include "discovery/summary/message.hpp"
#include "discovery/summary/offerings.hpp"
#include "sim/agenda.hpp"
#include "sim/small_ontology.hpp"

namespace geminga::scenarios {
namespace {

constexpr std::size_t first_leaf = 111;
constexpr std::size_t first_middle = 11;
/// Nothing changes in the end, so that all must be known.
constexpr base::Duration settles_in = std::chrono::minutes(1);
constexpr std::uint64_t most_services = 16;  ///< of one concept at first

/// The octets that NATS writes before and behind a payload: "MSG <subject> <sid> <size>", and the line ends.
constexpr std::size_t protocol_octets = 20;
constexpr std::string_view question_subject = "geminga.team.ask.";
constexpr std::string_view answer_subject = "geminga.team.sum.";
/// Of expansions and listings, with the number of a site or of a reply behind it.
constexpr std::size_t direct_subject_octets = 34;
/// The answers to an interest are there: SUMMARY.md, "Limits".
constexpr base::Duration expands_after = std::chrono::seconds(1);
constexpr base::Duration asks_again_after = std::chrono::seconds(1);
constexpr int most_requests = 4;
/// A participant has nine publications, and a state of so many octets (SCALE.md).
constexpr std::uint32_t services_of_participant = 9;
constexpr std::size_t state_octets = 592;

std::string iri_of(std::size_t number) { return "https://geminga.example/soccer#C" + std::to_string(number); }

struct Site {
  Site(summary::SiteId id, const vocabulary::Vocabulary& the_vocabulary, std::size_t the_cluster)
      : vocabulary(the_vocabulary), cluster(the_cluster), offerings(id, vocabulary), horizon(id, vocabulary.digest()) {}

  vocabulary::Vocabulary vocabulary;
  std::size_t cluster;
  summary::Offerings offerings;
  summary::Horizon horizon;
  std::vector<std::size_t> concepts;               ///< of the services that are there, each as often
  std::map<std::string, base::Instant> interests;  ///< when they began
  std::set<std::pair<std::string, summary::SiteId>> known;
  base::Instant armed = base::never;
};

class Sites {
 public:
  explicit Sites(const SiteConditions& conditions)
      : conditions_(conditions), random_(conditions.seed), air_(conditions.seed + 1) {
    const std::vector<vocabulary::Vocabulary> ontologies{sim::small_ontology("tree"),
                                                         sim::small_ontology("other-tree")};
    for (std::size_t i = 0; i < conditions_.sites; ++i) {
      const bool is_other = random_.chance(conditions_.other_ontology);
      sites_.push_back(
          std::make_unique<Site>(summary::SiteId{i + 1}, ontologies[is_other ? 1 : 0], i % conditions_.clusters));
      furnish(*sites_.back(), i);
    }
  }

  SiteResult run(const OnProgress& progress) {
    while (!agenda_.is_empty() && agenda_.next() <= base::Instant(conditions_.time)) {
      now_ = agenda_.next();
      if (progress) progress(now_.time_since_epoch(), result_.questions + result_.answers);
      const Due due = agenda_.take();
      switch (due.kind) {
        case Due::Kind::interest:
          want(*sites_[due.site], due.number);
          break;
        case Due::Kind::change:
          change(due.site);
          break;
        case Due::Kind::timer:
          ring(due.site);
          break;
        case Due::Kind::arrival:
          arrive(due.number, due.site);
          break;
        case Due::Kind::expansion:
          expand(due.site, due.number);
          break;
        case Due::Kind::request:
          request(due.number);
          break;
        case Due::Kind::listing:
          result_.listed.push_back(now_ - expansions_[due.number].began);
          expansions_[due.number].is_listed = true;
          break;
      }
    }
    finish();
    return std::move(result_);
  }

 private:
  struct Due {
    enum class Kind : std::uint8_t { interest, change, timer, arrival, expansion, request, listing } kind{};
    std::size_t site = 0;    ///< of an arrival: the cluster
    std::size_t number = 0;  ///< of an interest or expansion: the class; of an arrival: the flight; else the expansion
  };
  /// A site that was asked which services it offers.
  struct Expansion {
    std::size_t asker = 0;
    std::size_t offerer = 0;
    summary::Topic topic;
    base::Instant began;
    int requests = 0;
    bool is_listed = false;
  };
  /// A message on its way to the sites of all clusters that want it.
  struct Flight {
    std::size_t sender = 0;
    summary::Message message;
    std::size_t octets = 0;
    base::Instant caused;
    std::size_t left = 0;  ///< clusters that it has not come to
  };

  void furnish(Site& site, std::size_t index) {
    for (std::size_t i = 0; i < conditions_.concepts; ++i) {
      const std::size_t leaf = first_leaf + random_.below(site_leaves);
      for (std::uint64_t left = 1 + random_.below(most_services); left > 0; --left) offer(site, leaf);
    }
    const auto begin = [&](std::size_t number) {
      agenda_.add(base::Instant(random_.between(base::Duration(0), conditions_.start)),
                  {.kind = Due::Kind::interest, .site = index, .number = number});
    };
    for (std::size_t i = 0; i < conditions_.leaf_interests; ++i) begin(first_leaf + random_.below(site_leaves));
    for (std::size_t i = 0; i < conditions_.middle_interests; ++i) begin(first_middle + random_.below(site_middles));
    plan_change(index);
  }

  void offer(Site& site, std::size_t leaf) {
    site.concepts.push_back(leaf);
    site.offerings.add(SemanticIdentity{iri_of(leaf), {}}, now_);
  }

  void plan_change(std::size_t index) {
    const base::Duration pause = random_.between(conditions_.change / 2, conditions_.change * 3 / 2);
    if (now_ + pause > base::Instant(conditions_.time) - settles_in) return;
    agenda_.add(now_ + pause, {.kind = Due::Kind::change, .site = index});
  }

  void change(std::size_t index) {
    Site& site = *sites_[index];
    if (random_.chance(0.5) || site.concepts.empty()) {
      offer(site, site.concepts.empty() || random_.chance(0.5) ? first_leaf + random_.below(site_leaves)
                                                               : site.concepts[random_.below(site.concepts.size())]);
    } else {
      std::swap(site.concepts[random_.below(site.concepts.size())], site.concepts.back());
      site.offerings.remove(SemanticIdentity{iri_of(site.concepts.back()), {}}, now_);
      site.concepts.pop_back();
    }
    plan_change(index);
    settle(index, now_);
  }

  void want(Site& site, std::size_t number) {
    const std::string iri = iri_of(number);
    const auto found = site.vocabulary.find_iri(iri);
    if (site.interests.contains(iri)) return;
    site.interests[iri] = now_;
    (void)site.horizon.want(iri, found ? std::optional(std::to_underlying(*found)) : std::nullopt, now_);
    for (const summary::Topic& topic : site.horizon.topics(iri)) wanted_[topic].push_back(&site);
    const std::size_t index = index_of(site);
    settle(index, now_);
    agenda_.add(now_ + expands_after, {.kind = Due::Kind::expansion, .site = index, .number = number});
  }

  std::size_t index_of(const Site& site) const {
    return static_cast<std::size_t>(std::ranges::find_if(sites_, [&](const auto& one) { return one.get() == &site; }) -
                                    sites_.begin());
  }

  void ring(std::size_t index) {
    if (sites_[index]->armed != now_) return;
    sites_[index]->armed = base::never;
    settle(index, now_);
  }

  /// Sends what is due, and sets the timer.
  void settle(std::size_t index, base::Instant caused) {
    Site& site = *sites_[index];
    for (summary::Message& one : site.offerings.take_answers(now_)) send(index, std::move(one), caused);
    for (summary::Message& one : site.horizon.take_questions(now_, random_)) send(index, std::move(one), caused);
    const base::Instant due = std::min(site.offerings.next_due(), site.horizon.next_due());
    if (due == base::never || due == site.armed) return;
    site.armed = due;
    agenda_.add(due, {.kind = Due::Kind::timer, .site = index});
  }

  void send(std::size_t sender, summary::Message message, base::Instant caused) {
    const bool is_question = message.kind == summary::Kind::question;
    const std::string octets = summary::encode(message);
    const std::string_view subject = is_question ? question_subject : answer_subject;
    auto flight = std::make_unique<Flight>(
        Flight{.sender = sender,
               .message = std::move(*summary::decode(octets)),
               .octets = octets.size() + subject.size() + summary::subject_word(message.topic).size() + protocol_octets,
               .caused = caused});
    ++(is_question ? result_.questions : result_.answers);
    result_.sent_octets += static_cast<double>(flight->octets);
    const std::size_t home = sites_[sender]->cluster;
    std::size_t number = flights_.size();
    if (free_.empty()) {
      flights_.emplace_back();
    } else {
      number = free_.back();
      free_.pop_back();
    }
    for (std::size_t cluster = 0; cluster < conditions_.clusters; ++cluster) {
      if (!is_question && !is_wanted(flight->message.topic, cluster)) continue;
      ++flight->left;
      if (cluster != home) result_.gateway_octets += static_cast<double>(flight->octets);
      const base::Duration between = cluster == home ? base::Duration(0) : conditions_.gateway_delay;
      agenda_.add(now_ + 2 * conditions_.leaf_delay + between,
                  {.kind = Due::Kind::arrival, .site = cluster, .number = number});
    }
    if (flight->left == 0) {
      free_.push_back(number);
      return;
    }
    flights_[number] = std::move(flight);
  }

  bool is_wanted(const summary::Topic& topic, std::size_t cluster) const {
    const auto found = wanted_.find(topic);
    return found != wanted_.end() &&
           std::ranges::any_of(found->second, [&](const Site* site) { return site->cluster == cluster; });
  }

  void arrive(std::size_t number, std::size_t cluster) {
    Flight& flight = *flights_[number];
    const auto give = [&](Site& site) {
      if (is_lost()) return false;
      result_.received_octets += static_cast<double>(flight.octets);
      if (flight.message.kind == summary::Kind::question) site.offerings.hear(flight.message, now_, random_);
      site.horizon.hear(flight.message, now_, random_);
      return true;
    };
    if (flight.message.kind == summary::Kind::question) {
      for (std::size_t i = cluster; i < sites_.size(); i += conditions_.clusters) {
        if (i == flight.sender) continue;
        if (give(*sites_[i])) settle(i, now_);
      }
    } else if (const auto wanted = wanted_.find(flight.message.topic); wanted != wanted_.end()) {
      for (Site* site : wanted->second) {
        if (site->cluster != cluster || site == sites_[flight.sender].get()) continue;
        if (give(*site)) note(*site, flight);
      }
    }
    if (--flight.left > 0) return;
    flights_[number].reset();
    free_.push_back(number);
  }

  bool is_lost() { return conditions_.loss > 0 && air_.chance(conditions_.loss); }

  /// Asks those that offer enough of an interest; where nobody is known, again when it was asked again.
  void expand(std::size_t index, std::size_t number) {
    const std::string iri = iri_of(number);
    const auto chosen = sites_[index]->horizon.enough(iri, conditions_.expanded, now_);
    if (chosen.empty()) {
      agenda_.add(now_ + summary::ask_again, {.kind = Due::Kind::expansion, .site = index, .number = number});
    }
    for (const summary::Offerer& one : chosen) {
      expansions_.push_back({.asker = index,
                             .offerer = static_cast<std::size_t>(std::to_underlying(one.site)) - 1,
                             .topic = {.digest = 0, .rank = 0, .iri = iri},
                             .began = now_});
      ++result_.expansions;
      request(expansions_.size() - 1);
    }
  }

  /// Says an expansion, which the offerer answers by a listing unless either is lost.
  void request(std::size_t number) {
    Expansion& one = expansions_[number];
    if (one.is_listed) return;
    Site& asker = *sites_[one.asker];
    if (one.requests++ == most_requests) {
      ++result_.unanswered;
      return asker.horizon.forget(summary::SiteId{one.offerer + 1});
    }
    agenda_.add(now_ + asks_again_after, {.kind = Due::Kind::request, .number = number});
    const summary::Message expansion{.kind = summary::Kind::expansion,
                                     .site = summary::SiteId{one.asker + 1},
                                     .topic = one.topic,
                                     .digest = asker.vocabulary.digest()};
    if (count_and_lose(expansion)) return;
    const Site& offerer = *sites_[one.offerer];
    const std::uint32_t services = offerer.offerings.count(one.topic);
    const std::vector<std::string> states((services + services_of_participant - 1) / services_of_participant,
                                          std::string(state_octets, 'x'));
    for (const summary::Message& page :
         summary::listings(summary::SiteId{one.offerer + 1}, one.topic, offerer.vocabulary.digest(), states)) {
      if (count_and_lose(page)) return;
    }
    const base::Duration trip =
        2 * conditions_.leaf_delay + (asker.cluster == offerer.cluster ? base::Duration(0) : conditions_.gateway_delay);
    agenda_.add(now_ + 2 * trip, {.kind = Due::Kind::listing, .number = number});
  }

  /// Whether a message to one site is lost on its way, after it was counted and read as its receiver would.
  bool count_and_lose(const summary::Message& message) {
    const std::string octets = summary::encode(message);
    GEMINGA_ASSERT(summary::decode(octets) == message);
    result_.listing_octets += static_cast<double>(octets.size() + direct_subject_octets + protocol_octets);
    return is_lost();
  }

  /// Measures how late an answer was.
  void note(Site& site, const Flight& flight) {
    const std::string iri = flight.message.topic.digest == 0
                                ? flight.message.topic.iri
                                : std::string(site.vocabulary.iri(vocabulary::ClassNumber{flight.message.topic.rank}));
    const auto began = site.interests.find(iri);
    if (began == site.interests.end()) return;
    if (site.known.emplace(iri, flight.message.site).second) {
      // An answer to another site's question comes in without one of ours.
      if (now_ - began->second < std::chrono::seconds(10)) result_.told.push_back(now_ - began->second);
    } else if (flight.caused + std::chrono::seconds(1) > now_) {
      result_.changed.push_back(now_ - flight.caused);
    }
  }

  void finish() {
    const double duration = std::chrono::duration<double>(conditions_.time).count();
    const auto count = static_cast<double>(sites_.size());
    for (const auto& site : sites_) {
      result_.remembered += static_cast<double>(site->horizon.remembered()) / count;
      for (const auto& [iri, began] : site->interests) judge(*site, iri);
    }
    result_.received_octets /= count * duration;
    result_.sent_octets /= count * duration;
    result_.listing_octets /= count * duration;
    result_.gateway_octets /= duration;
    const SiteExpectation expected = expectation(conditions_);
    result_.expected_remembered = expected.remembered;
    result_.expected_received = expected.received_octets;
  }

  void judge(const Site& site, const std::string& iri) {
    std::set<summary::SiteId> known;
    for (const summary::Offerer& one : site.horizon.offerers(iri, now_)) known.insert(one.site);
    for (std::size_t i = 0; i < sites_.size(); ++i) {
      if (sites_[i].get() == &site) continue;
      const bool offers = sites_[i]->offerings.count({.digest = 0, .rank = 0, .iri = iri}) > 0;
      const bool is_known = known.contains(summary::SiteId{i + 1});
      result_.pairs += offers ? 1 : 0;
      result_.missing += offers && !is_known ? 1 : 0;
      result_.surplus += !offers && is_known ? 1 : 0;
    }
  }

  const SiteConditions conditions_;
  base::Random random_;
  base::Random air_;  ///< decides what is lost
  base::Instant now_{};
  sim::Agenda<Due> agenda_;
  std::vector<std::unique_ptr<Site>> sites_;
  std::map<summary::Topic, std::vector<Site*>> wanted_;  ///< the subscriptions
  std::vector<std::unique_ptr<Flight>> flights_;
  std::vector<std::size_t> free_;
  std::vector<Expansion> expansions_;
  SiteResult result_;
};

}  // namespace

SiteResult simulate_sites(const SiteConditions& conditions, const OnProgress& progress) {
  return Sites(conditions).run(progress);
}

}  // namespace geminga::scenarios
