// One function for each kind of step.
#include "discovery/matching/random_team.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "discovery/matching/found_places.hpp"
#include "discovery/matching/model.hpp"
#include "discovery/matching/obstacle_model.hpp"
#include "discovery/matching/random_words.hpp"
#include "discovery/matching/team.hpp"
#include "support/shrink.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;
using registry::SubscriptionEntry;

/// A team in a matcher and in a model, and all that its local peers were told.
class RandomTeam {
 public:
  RandomTeam(std::uint64_t seed, std::vector<vocabulary::Vocabulary> ontologies, Sabotage sabotage)
      : words_(static_cast<Crowd>(seed % 4)),
        ontologies_(std::move(ontologies)),
        sabotage_(std::move(sabotage)),
        model_(places_.placing()),
        matcher_(ontologies_.front(), places_.placing()),
        replay_({}) {
    model_.ontology = ontologies_.front();
  }

  /// Takes a step, and gives the error after it; empty where there is none. The seed and the team decide the step.
  [[nodiscard]] std::string step(std::uint64_t seed) {
    words_.seed(seed);
    wrong_.clear();
    if (stage_ != Stage::none) change_a_little();
    const std::uint64_t dice = words_.random().below(100);
    if (dice < 4 && !words_.is(Crowd::packed)) {
      put_description();
    } else if (dice < (words_.is(Crowd::packed) ? 60 : 40)) {
      put_publication();
    } else if (dice < 70) {
      put_subscription();
    } else if (dice < 80) {
      remove_one();
    } else if (dice < 86) {
      if (!words_.is(Crowd::packed) || words_.random().chance(0.1)) remove_many();
    } else if (dice < 94) {
      if (!words_.is(Crowd::packed) || words_.random().chance(0.05)) expire();
    } else if (dice < 96) {
      if (!words_.is(Crowd::packed) || words_.random().chance(0.2)) set_ontology();
    } else {
      put_everything_again();
    }
    compare();
    if (wrong_.empty() && seed % 8 == 0 && model_.former.empty()) compare_questions();
    return wrong_;
  }

 private:
  /// A key amid the others, so that ties are won by smaller and by greater keys.
  static bool is_local(const ServiceKey& of) { return of.participant == ParticipantId{3}; }

  void put_publication() {
    const ServiceKey one = words_.some_key(false);
    const auto known = model_.publications.find(one);
    PublicationEntry entry =
        known == model_.publications.end() ? offer(one, words_.wish(), 0, words_.mode()) : known->second;
    if (words_.random().chance(words_.is(Crowd::converting) ? 0.25 : 0.02))
      words_.state_conversion(entry.publication.attributes);
    switch (words_.random().below(10)) {
      case 6:
        if (!words_.is(Crowd::packed)) entry.publication.scope = words_.one_of<4>({"", "host", "!host", "robot4,,"});
        break;
      case 7:
        if (words_.is(Crowd::packed)) break;
        entry.publication.for_whom = words_.one_of<4>({"", "priority >= 1", "participant_name = *3", "peer"});
        break;
      case 0:
        entry.publication.identity = words_.wish();
        break;
      case 5:
        entry.publication.protocol = words_.one_of<2>({"udp", "tcp"});
        break;
      case 1:
        entry.publication.priority = static_cast<std::int32_t>(words_.random().below(3)) - 1;
        break;
      case 2:
        entry.publication.mode = words_.mode();
        break;
      case 3:
        entry.publication.attributes["rate"] = std::to_string(words_.random().below(4));
        break;
      case 8:
        words_.state_signature(entry.publication.attributes);
        break;
      case 4:
        entry.publication.port = static_cast<std::uint16_t>(5000 + words_.random().below(2));
        break;
      default:
        break;  // as it was
    }
    // In a packed team local ones rank last, so that they are needed only after many have gone at once.
    if (words_.is(Crowd::packed) && is_local(one)) entry.publication.priority = -2;
    put(std::move(entry));
  }

  void put(PublicationEntry entry) {
    entry.is_local = is_local(entry.key);
    entry.updated = now_;
    matcher_.put(model_.publications[entry.key] = entry);
  }

  void put_description() {
    const ServiceKey one = description_key(words_.some_key(false).participant);
    if (model_.publications.contains(one) && words_.random().chance(0.3)) return remove(one, false);
    put(offer(one, words_.described(), 0, ChannelMode::participant));
  }

  void put_subscription() {
    const ServiceKey one = words_.some_key(true);
    const auto known = model_.subscriptions.find(one);
    SubscriptionEntry entry = known == model_.subscriptions.end()
                                  ? request(one, words_.wish(), static_cast<std::uint32_t>(words_.random().below(3)),
                                            Degree::narrower, words_.mode())
                                  : known->second;
    Subscription& asked = entry.subscription;
    if (words_.is(Crowd::converting) && known == model_.subscriptions.end()) asked.convert = any_cost;
    switch (words_.random().below(17)) {
      case 11:
        asked.chosen.clear();
        if (is_local(one) || words_.random().chance(0.4)) break;
        for (int i = 0; i < 3; ++i) asked.chosen.push_back(words_.some_key(false));
        std::ranges::sort(asked.chosen);
        asked.chosen.erase(std::ranges::unique(asked.chosen).begin(), asked.chosen.end());
        break;
      case 0:
        asked.identity = words_.wish();
        break;
      case 8:
        asked.prefer = words_.one_of<2>({"", "rate desc"});
        asked.rank = words_.one_of<2>({"", "prefer"});
        break;
      case 10:
        if (!words_.is(Crowd::packed)) asked.scope = words_.one_of<4>({"", "host", "!robot1", "robot*/module1, !host"});
        break;
      case 13:
        asked.convert = std::array{0U, 1U, 3U, any_cost}[words_.random().below(4)];
        break;
      case 9:
        asked.favoured.clear();
        if (words_.random().chance(0.5)) asked.favoured.push_back({"robot3", ""});
        break;
      case 7:
        asked.protocols.clear();
        if (!words_.is(Crowd::packed) && words_.random().chance(0.5))
          asked.protocols.push_back(words_.one_of<2>({"udp", "tcp"}));
        break;
      case 12:
        if (!words_.is(Crowd::packed)) words_.state_signature(asked.attributes);
        break;
      case 14:
        if (!words_.is(Crowd::packed)) asked.on = words_.random().chance(0.3) ? "" : words_.on();
        break;
      case 1:
        asked.priority = static_cast<std::int32_t>(words_.random().below(2));
        break;
      case 2:
        asked.mode = words_.mode();
        break;
      case 3:
        if (words_.is(Crowd::packed)) break;
        asked.where = words_.one_of<4>({"", "rate >= 2", "not has rate", "rate ="});
        break;
      case 4:
        asked.limit = static_cast<std::uint32_t>(words_.random().chance(0.8) ? words_.random().below(4)
                                                                             : 15 + words_.random().below(3));
        break;
      case 5:
        asked.weakest =
            words_.random().chance(0.3) ? Degree::overlapping : static_cast<Degree>(words_.random().below(4));
        break;
      case 6:
        asked.providers.clear();
        if (words_.is(Crowd::packed)) break;
        if (words_.random().chance(0.5))
          asked.providers.push_back({words_.one_of<3>({"00000002", "robot1", "robot3"}), ""});
        if (words_.random().chance(0.3)) asked.providers.push_back({"robot1", words_.one_of<2>({"2", "module1"})});
        break;
      default:
        break;  // as it was
    }
    entry.is_local = is_local(one);
    entry.updated = now_;
    // An entry that changes is judged by the ontology in force from then on.
    if (known == model_.subscriptions.end() || !known->second.same_as(entry)) model_.former.erase(one);
    model_.subscriptions[one] = entry;
    matcher_.put(entry);
  }

  Reason some_reason() {
    return reason_ = std::array{Reason::withdrawn, Reason::left, Reason::renamed}[words_.random().below(3)];
  }

  void remove_one() {
    const bool is_subscription = words_.random().chance(0.4);
    remove(words_.some_key(is_subscription), is_subscription);
  }

  void remove(const ServiceKey& one, bool is_subscription) {
    const auto erased = is_subscription ? model_.subscriptions.erase(one) : model_.publications.erase(one);
    const Reason why = some_reason();
    const bool was_there =
        is_subscription ? matcher_.remove_subscription(one, why) : matcher_.remove_publication(one, why);
    expect(was_there == (erased == 1), name(one) + ": was it there?");
    replay_.forget(one);
  }

  template <typename Gone>
  void erase_from_model(const Gone& is_gone) {
    std::erase_if(model_.publications,
                  [&](const auto& row) { return is_gone(row.second) && (replay_.forget(row.first), true); });
    std::erase_if(model_.subscriptions,
                  [&](const auto& row) { return is_gone(row.second) && (replay_.forget(row.first), true); });
  }

  void remove_many() {
    const ServiceKey one = words_.some_key(false);
    const bool is_whole_participant = words_.random().chance(0.5);
    erase_from_model([&](const auto& entry) {
      return entry.key.participant == one.participant && (is_whole_participant || entry.key.peer == one.peer);
    });
    if (is_whole_participant) {
      remove_participant(matcher_, one.participant, some_reason());
    } else {
      matcher_.remove_peer(one.participant, one.peer, some_reason());
    }
  }

  /// Time goes by, and participants that were not heard are given up, as by the neighbour table.
  void expire() {
    reason_ = Reason::expired;
    now_ += lifetime;
    for (const std::uint32_t number : {1U, 2U, 4U}) {
      if (!words_.is(Crowd::packed) && words_.random().chance(0.7)) continue;
      const ParticipantId silent{number};
      erase_from_model([&](const auto& entry) { return entry.key.participant == silent; });
      remove_participant(matcher_, silent, Reason::expired);
      compare();
    }
  }

  /// Begins a change of the ontology, which goes on beside the next steps or is done at once.
  void set_ontology() {
    if (stage_ == Stage::none) {
      next_ontology_ = ontologies_[words_.random().below(ontologies_.size())];
      matcher_.vocabulary_change().begin(next_ontology_);
      stage_ = Stage::filing;
    }
    if (words_.random().chance(0.5)) return;
    while (stage_ != Stage::none) change_one_step();
  }

  void change_a_little() {
    for (std::uint64_t steps = words_.random().below(4); steps > 0 && stage_ != Stage::none; --steps) change_one_step();
  }

  void change_one_step() {
    if (stage_ == Stage::filing) {
      if (matcher_.vocabulary_change().file_next()) return;
      matcher_.vocabulary_change().put_in_force();
      model_.former_ontology = std::exchange(model_.ontology, next_ontology_);
      for (const auto& [one, entry] : model_.subscriptions) model_.former.insert(one);
      stage_ = Stage::rematching;
      at_.reset();
      compare();
      return;
    }
    if (!matcher_.vocabulary_change().rematch_next()) {
      expect(model_.former.empty(), "some are still judged by the former ontology");
      stage_ = Stage::none;
      return;
    }
    const auto next = at_ ? model_.subscriptions.upper_bound(*at_) : model_.subscriptions.begin();
    if (next == model_.subscriptions.end()) return;
    at_ = next->first;
    model_.former.erase(*at_);
    reason_ = Reason::changed;
    compare();
  }

  /// Puts every entry again, as announcements do every interval.
  void put_everything_again() {
    for (auto& [one, entry] : model_.publications) {
      entry.updated = now_;
      matcher_.put(entry);
    }
    for (auto& [one, entry] : model_.subscriptions) {
      entry.updated = now_;
      matcher_.put(entry);
    }
  }

  void expect(bool is_right, const std::string& what) {
    if (!is_right && wrong_.empty()) wrong_ = what;
  }

  void compare() {
    std::erase_if(model_.former, [&](const ServiceKey& one) { return !model_.subscriptions.contains(one); });
    model_.work_out();
    std::vector<Event> events = matcher_.take_events();
    if (sabotage_) sabotage_(events);
    const std::string told = replay_.apply(events, reason_, model_);
    expect(told.empty(), told);
    const std::string different = difference(replay_.view(), model_.view());
    expect(different.empty(), different);
  }

  /// Compares the answers to questions that change nothing.
  void compare_questions() {
    for (const auto& [one, entry] : model_.publications) {
      const bool is_used = std::ranges::any_of(
          model_.subscriptions, [&](const auto& row) { return model_.meets(row.second, entry).has_value(); });
      expect(matcher_.search().is_used(entry) == is_used, name(one) + ": is it used?");
    }
    for (const auto& [one, entry] : model_.subscriptions) {
      std::vector<ServiceKey> meeting;
      for (const auto& [offer_key, publication] : model_.publications) {
        if (model_.meets(entry, publication)) meeting.push_back(offer_key);
      }
      expect(matched(matcher_, entry) == meeting, name(one) + ": what meets it?");
      expect(matcher_.search().is_served(entry) == !meeting.empty(), name(one) + ": is it served?");
    }
    const bool has_pairs = !model_.publications.empty() && !model_.subscriptions.empty();
    for (int i = 0; i < 8 && has_pairs; ++i) {
      const auto draw = [this](const auto& all) {
        return std::next(all.begin(), static_cast<std::ptrdiff_t>(words_.random().below(all.size())));
      };
      const auto& asked = draw(model_.subscriptions)->second;
      const auto& offered = draw(model_.publications)->second;
      const std::string wrong = complaint(matcher_, model_, asked, offered);
      expect(wrong.empty(), name(asked.key) + " about " + name(offered.key) + ": " + wrong);
    }
  }

  static constexpr base::Duration lifetime = std::chrono::seconds(20);

  RandomWords words_;
  std::vector<vocabulary::Vocabulary> ontologies_;
  Sabotage sabotage_;
  std::string wrong_;
  base::Instant now_;
  Reason reason_ = Reason::withdrawn;
  FoundPlaces places_;
  Model model_;
  Matcher matcher_;
  Replay replay_;
  /// The state of a change of the ontology.
  enum class Stage { none, filing, rematching } stage_ = Stage::none;
  vocabulary::Vocabulary next_ontology_;
  std::optional<ServiceKey> at_;
};

}  // namespace

Life random_life(std::uint64_t seed, std::size_t steps) {
  base::Random random(seed);
  Life life{seed, {}};
  for (std::size_t step = 0; step < steps; ++step) life.steps.push_back(random.next());
  return life;
}

Outcome live(const Life& life, const std::vector<vocabulary::Vocabulary>& ontologies, const Sabotage& sabotage) {
  RandomTeam team(life.team, ontologies, sabotage);
  Outcome outcome;
  for (const std::uint64_t seed : life.steps) {
    ++outcome.steps;
    outcome.wrong = team.step(seed);
    if (!outcome.wrong.empty()) break;
  }
  return outcome;
}

Life shortest(const Life& life, const std::vector<vocabulary::Vocabulary>& ontologies, const Sabotage& sabotage) {
  Life lived = life;
  lived.steps.resize(live(life, ontologies, sabotage).steps);
  const auto fails = [&](const std::vector<std::uint64_t>& steps) {
    return !live({life.team, steps}, ontologies, sabotage).wrong.empty();
  };
  lived.steps = test::shrunk(std::move(lived.steps), fails);
  return lived;
}

}  // namespace geminga::matching
