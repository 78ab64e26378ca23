// The matcher against the model over random lives of a team: every step, every event, every seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "base/random.hpp"
#include "discovery/matching/model.hpp"
#include "discovery/matching/taxonomy.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;
using registry::SubscriptionEntry;

/// One team, held by a matcher and by a model, and what its local peers were told.
class RandomTeam {
 public:
  RandomTeam(std::uint64_t seed, std::vector<vocabulary::Vocabulary> ontologies)
      : random_(seed),
        crowd_(static_cast<Crowd>(seed % 4)),
        ontologies_(std::move(ontologies)),
        matcher_(ontologies_.front()),
        replay_({}) {
    model_.ontology = ontologies_.front();
  }

  void step(int number) {
    if (stage_ != Stage::none) change_a_little();
    const std::uint64_t dice = random_.below(100);
    if (dice < (crowd_ == Crowd::packed ? 60 : 40)) {
      put_publication();
    } else if (dice < 70) {
      put_subscription();
    } else if (dice < 80) {
      remove_one();
    } else if (dice < 86) {
      if (crowd_ != Crowd::packed || random_.chance(0.1)) remove_many();
    } else if (dice < 94) {
      if (crowd_ != Crowd::packed || random_.chance(0.05)) expire();
    } else if (dice < 96) {
      if (crowd_ != Crowd::packed || random_.chance(0.2)) set_ontology();
    } else {
      put_everything_again();
    }
    compare(number);
  }

 private:
  /// A crowded team wants much the same thing, so that arbitration has much to do; a packed one has so many that offer
  /// it that not all of them are remembered.
  /// One that converts has many converters, and asks for all that they turn into each other.
  enum class Crowd { mixed, crowded, packed, converting };

  template <std::size_t size>
  const char* one_of(const std::array<const char*, size>& names) {
    return names[random_.below(size)];
  }

  Identity identity() {
    if (crowd_ == Crowd::packed) return semantic(one_of<2>({"Ball", "Sphere"}));
    if (crowd_ == Crowd::crowded) return semantic(one_of<3>({"Ball", "Sphere", "OwnBall"}));
    if (crowd_ == Crowd::converting) return semantic(one_of<2>({"Ball", "Tracked"}), frame());
    const std::uint64_t dice = random_.below(10);
    if (dice == 0) return NumericIdentity{0x9ddb3b5f};
    if (dice == 1) return TextIdentity{one_of<2>({"service-3352", "service-724358"})};
    const char* concept_name =
        one_of<10>({"Tracked", "Ball", "Sphere", "OwnBall", "Robot", "Ghost", "Round", "New", "Team", "OwnRobot"});
    return semantic(concept_name, one_of<7>({"", "", "Frame", "FieldFrame", "Pitch", "PolarFieldFrame", "NewFrame"}));
  }

  const char* frame() { return one_of<7>({"Frame", "Pitch", "PolarFieldFrame", "NewFrame", "F1", "F2", "F3"}); }

  void state_conversion(Attributes& attributes) {
    attributes.erase("converts");
    if (random_.chance(0.2)) return;
    attributes["converts"] = "<" + iri(frame()) + ">><" + iri(random_.chance(0.1) ? "Phantom" : frame()) + '>';
    attributes["cost"] = std::to_string(random_.below(5));  // 0 cannot be read
  }

  ChannelMode mode() {
    const bool is_alike = crowd_ == Crowd::crowded || crowd_ == Crowd::converting;
    if (crowd_ == Crowd::packed || (is_alike && random_.chance(0.8))) return ChannelMode::one_to_one;
    return std::array{ChannelMode::one_to_one, ChannelMode::one_to_many_pubsub,
                      ChannelMode::one_to_many_stream}[std::min<std::uint64_t>(random_.below(5) / 2, 2)];
  }

  /// Numbers of publications and subscriptions of one peer differ, as in GCNP.
  ServiceKey some_key(bool is_subscription) {
    return key(static_cast<std::uint32_t>(1 + random_.below(4)), static_cast<std::uint32_t>(1 + random_.below(2)),
               static_cast<std::uint32_t>(2 * random_.below(crowd_ == Crowd::packed && !is_subscription ? 9 : 3) +
                                          (is_subscription ? 1 : 0)));
  }

  /// In the midst of the others, so that ties are won by smaller and by greater keys.
  static bool is_local(const ServiceKey& of) { return of.participant == ParticipantId{3}; }

  void state_signature(Attributes& attributes) {
    const char* side = one_of<2>({"inputs", "outputs"});
    const std::string name = one_of<6>({"", "Tracked", "Ball", "OwnBall", "New", "Robot"});
    attributes.erase(side);
    if (!name.empty()) attributes[side] = "<http://example.org/" + name + '>';
  }

  void put_publication() {
    const ServiceKey one = some_key(false);
    const auto known = model_.publications.find(one);
    PublicationEntry entry = known == model_.publications.end() ? offer(one, identity(), 0, mode()) : known->second;
    if (random_.chance(crowd_ == Crowd::converting ? 0.25 : 0.02)) state_conversion(entry.publication.attributes);
    switch (random_.below(10)) {
      case 6:
        if (crowd_ != Crowd::packed) entry.publication.scope = one_of<4>({"", "host", "!host", "robot4,,"});
        break;
      case 7:
        if (crowd_ == Crowd::packed) break;
        entry.publication.for_whom = one_of<4>({"", "priority >= 1", "participant_name = *3", "peer"});
        break;
      case 0:
        entry.publication.identity = identity();
        break;
      case 5:
        entry.publication.protocol = one_of<2>({"udp", "tcp"});
        break;
      case 1:
        entry.publication.priority = static_cast<std::int32_t>(random_.below(3)) - 1;
        break;
      case 2:
        entry.publication.mode = mode();
        break;
      case 3:
        entry.publication.attributes["rate"] = std::to_string(random_.below(4));
        break;
      case 8:
        state_signature(entry.publication.attributes);
        break;
      case 4:
        entry.publication.port = static_cast<std::uint16_t>(5000 + random_.below(2));
        break;
      default:
        break;  // as it was
    }
    entry.is_local = is_local(one);
    // In a packed team the local ones come last, so that they are needed only after many have gone at once.
    if (crowd_ == Crowd::packed && entry.is_local) entry.publication.priority = -2;
    entry.updated = now_;
    model_.publications[one] = entry;
    matcher_.put(entry);
  }

  void put_subscription() {
    const ServiceKey one = some_key(true);
    const auto known = model_.subscriptions.find(one);
    SubscriptionEntry entry =
        known == model_.subscriptions.end()
            ? request(one, identity(), static_cast<std::uint32_t>(random_.below(3)), Degree::narrower, mode())
            : known->second;
    Subscription& asked = entry.subscription;
    if (crowd_ == Crowd::converting && known == model_.subscriptions.end()) asked.convert = any_cost;
    switch (random_.below(17)) {
      case 11:
        asked.chosen.clear();
        if (is_local(one) || random_.chance(0.4)) break;
        for (int i = 0; i < 3; ++i) asked.chosen.push_back(some_key(false));
        std::ranges::sort(asked.chosen);
        asked.chosen.erase(std::ranges::unique(asked.chosen).begin(), asked.chosen.end());
        break;
      case 0:
        asked.identity = identity();
        break;
      case 8:
        asked.prefer = one_of<2>({"", "rate desc"});
        asked.rank = one_of<2>({"", "prefer"});
        break;
      case 10:
        if (crowd_ != Crowd::packed) asked.scope = one_of<4>({"", "host", "!robot1", "robot*/module1, !host"});
        break;
      case 13:
        asked.convert = std::array{0U, 1U, 3U, any_cost}[random_.below(4)];
        break;
      case 9:
        asked.favoured.clear();
        if (random_.chance(0.5)) asked.favoured.push_back({"robot3", ""});
        break;
      case 7:
        asked.protocols.clear();
        if (crowd_ != Crowd::packed && random_.chance(0.5)) asked.protocols.push_back(one_of<2>({"udp", "tcp"}));
        break;
      case 12:
        if (crowd_ != Crowd::packed) state_signature(asked.attributes);
        break;
      case 1:
        asked.priority = static_cast<std::int32_t>(random_.below(2));
        break;
      case 2:
        asked.mode = mode();
        break;
      case 3:
        if (crowd_ == Crowd::packed) break;
        asked.where = one_of<4>({"", "rate >= 2", "not has rate", "rate ="});
        break;
      case 4:
        asked.limit = static_cast<std::uint32_t>(random_.chance(0.8) ? random_.below(4) : 15 + random_.below(3));
        break;
      case 5:
        asked.weakest = random_.chance(0.3) ? Degree::overlapping : static_cast<Degree>(random_.below(4));
        break;
      case 6:
        asked.providers.clear();
        if (crowd_ == Crowd::packed) break;
        if (random_.chance(0.5)) asked.providers.push_back({one_of<3>({"00000002", "robot1", "robot3"}), ""});
        if (random_.chance(0.3)) asked.providers.push_back({"robot1", one_of<2>({"2", "module1"})});
        break;
      default:
        break;  // as it was
    }
    entry.is_local = is_local(one);
    entry.updated = now_;
    // Whatever changes is judged by the ontology in force from then on.
    if (known == model_.subscriptions.end() || !known->second.same_as(entry)) model_.former.erase(one);
    model_.subscriptions[one] = entry;
    matcher_.put(entry);
  }

  Reason some_reason() {
    return reason_ = std::array{Reason::withdrawn, Reason::left, Reason::renamed}[random_.below(3)];
  }

  void remove_one() {
    const bool is_subscription = random_.chance(0.4);
    const ServiceKey one = some_key(is_subscription);
    if (is_subscription) {
      const bool was_there = model_.subscriptions.erase(one) == 1;
      EXPECT_EQ(matcher_.remove_subscription(one, some_reason()), was_there);
    } else {
      const bool was_there = model_.publications.erase(one) == 1;
      EXPECT_EQ(matcher_.remove_publication(one, some_reason()), was_there);
    }
    replay_.forget(one);
  }

  template <typename Gone>
  void erase_from_model(const Gone& is_gone) {
    std::erase_if(model_.publications,
                  [&](const auto& row) { return is_gone(row.second) && (forget(row.first), true); });
    std::erase_if(model_.subscriptions,
                  [&](const auto& row) { return is_gone(row.second) && (forget(row.first), true); });
  }

  void forget(const ServiceKey& one) { replay_.forget(one); }

  void remove_many() {
    const ServiceKey one = some_key(false);
    const bool is_whole_participant = random_.chance(0.5);
    erase_from_model([&](const auto& entry) {
      return entry.key.participant == one.participant && (is_whole_participant || entry.key.peer == one.peer);
    });
    if (is_whole_participant) {
      remove_participant(matcher_, one.participant, some_reason());
    } else {
      matcher_.remove_peer(one.participant, one.peer, some_reason());
    }
  }

  /// Time goes by, and participants that were not heard of are given up, as the neighbour table does it.
  void expire() {
    reason_ = Reason::expired;
    now_ += lifetime;
    for (const std::uint32_t number : {1U, 2U, 4U}) {
      if (crowd_ != Crowd::packed && random_.chance(0.7)) continue;
      const ParticipantId silent{number};
      erase_from_model([&](const auto& entry) { return entry.key.participant == silent; });
      remove_participant(matcher_, silent, Reason::expired);
      compare(-1);
    }
  }

  /// Begins a change, which goes on beside the next steps or is done at once.
  void set_ontology() {
    if (stage_ == Stage::none) {
      next_ontology_ = ontologies_[random_.below(ontologies_.size())];
      matcher_.begin_vocabulary(next_ontology_);
      stage_ = Stage::filing;
    }
    if (random_.chance(0.5)) return;
    while (stage_ != Stage::none) change_one_step();
  }

  void change_a_little() {
    for (std::uint64_t steps = random_.below(4); steps > 0 && stage_ != Stage::none; --steps) change_one_step();
  }

  void change_one_step() {
    if (stage_ == Stage::filing) {
      if (matcher_.file_next()) return;
      matcher_.put_in_force();
      model_.former_ontology = std::exchange(model_.ontology, next_ontology_);
      for (const auto& [one, entry] : model_.subscriptions) model_.former.insert(one);
      stage_ = Stage::rematching;
      at_.reset();
      compare(-1);
      return;
    }
    if (!matcher_.rematch_next()) {
      EXPECT_TRUE(model_.former.empty());
      stage_ = Stage::none;
      return;
    }
    const auto next = at_ ? model_.subscriptions.upper_bound(*at_) : model_.subscriptions.begin();
    if (next == model_.subscriptions.end()) return;
    at_ = next->first;
    model_.former.erase(*at_);
    reason_ = Reason::changed;
    compare(-1);
  }

  /// As announcements do every interval.
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

  void compare(int number) {
    SCOPED_TRACE("step " + std::to_string(number));
    std::erase_if(model_.former, [&](const ServiceKey& one) { return !model_.subscriptions.contains(one); });
    model_.work_out();
    ASSERT_EQ(replay_.apply(matcher_.take_events(), reason_, model_), "");
    ASSERT_EQ(difference(replay_.view(), model_.view()), "");
    if (number % 8 == 0 && model_.former.empty()) compare_questions();
  }

  /// What can be asked at any time, and changes nothing.
  void compare_questions() {
    for (const auto& [one, entry] : model_.publications) {
      const bool is_used = std::ranges::any_of(
          model_.subscriptions, [&](const auto& row) { return model_.meets(row.second, entry).has_value(); });
      ASSERT_EQ(matcher_.is_used(entry), is_used) << name(one);
    }
    for (const auto& [one, entry] : model_.subscriptions) {
      std::vector<ServiceKey> meeting;
      for (const auto& [offer_key, publication] : model_.publications) {
        if (model_.meets(entry, publication)) meeting.push_back(offer_key);
      }
      ASSERT_EQ(matched(matcher_, entry), meeting) << name(one);
      ASSERT_EQ(matcher_.is_served(entry), !meeting.empty()) << name(one);
    }
  }

  static constexpr base::Duration lifetime = std::chrono::seconds(20);

  base::Random random_;
  Crowd crowd_;
  std::vector<vocabulary::Vocabulary> ontologies_;
  base::Instant now_;
  Reason reason_ = Reason::withdrawn;
  Model model_;
  Matcher matcher_;
  Replay replay_;
  /// The change of the ontology that is under way.
  enum class Stage { none, filing, rematching } stage_ = Stage::none;
  vocabulary::Vocabulary next_ontology_;
  std::optional<ServiceKey> at_;
};

TEST(RandomTeam, IsToldExactlyWhatWorkingEverythingOutSays) {
  const auto first = soccer([](Taxonomy& frames) {
    frames.sub("F1", "Frame")
        .sub("F2", "Frame")
        .sub("F3", "Frame")
        .sub("NewFrame", "Frame")
        .convert("PolarFieldFrame", "NewFrame")
        .convert("NewFrame", "PolarFieldFrame", 2);
  });
  Taxonomy taxonomy;
  taxonomy.sub("OwnBall", "Round").sub("Round", "Tracked").sub("OwnRobot", "Robot").sub("Robot", "Team");
  taxonomy.equivalent("Team", "Round").sub("New", "Ball").sub("Frame", "FieldFrame").unsatisfiable("Sphere");
  taxonomy.sub("F1", "Round")
      .sub("F2", "F1")
      .sub("F3", "Team")
      .convert("NewFrame", "Pitch", 2)
      .convert("FieldFrame", "PolarFieldFrame", 3);
  const auto second = taxonomy.classified();
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomTeam team(seed, {first, second, {}});
    for (int number = 0; number < 1500 && !testing::Test::HasFailure(); ++number) team.step(number);
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace geminga::matching
