// Random offers and requests of a team.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_RANDOM_WORDS_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_RANDOM_WORDS_HPP

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "base/random.hpp"
#include "discovery/matching/taxonomy.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {

/// The kind of a team. A crowded one asks for much the same, so that arbitration has much to do. A packed one has so
/// many providers of it that not all of them are remembered. One that converts has many converters, and asks for
/// everything that they turn into each other.
enum class Crowd { mixed, crowded, packed, converting };

/// Draws from names that often mean the same.
class RandomWords {
 public:
  explicit RandomWords(Crowd crowd) : crowd_(crowd) {}
  void seed(std::uint64_t seed) { random_ = base::Random(seed); }
  [[nodiscard]] base::Random& random() { return random_; }
  [[nodiscard]] bool is(Crowd crowd) const { return crowd_ == crowd; }

  template <std::size_t size>
  const char* one_of(const std::array<const char*, size>& names) {
    return names[random_.below(size)];
  }

  Identity identity() {
    if (crowd_ == Crowd::packed) return semantic(one_of<2>({"Ball", "Sphere"}));
    if (crowd_ == Crowd::crowded) return semantic(one_of<3>({"Ball", "Sphere", "OwnBall"}));
    if (crowd_ == Crowd::converting) return semantic(one_of<2>({"Ball", "Tracked"}), frame());
    const std::uint64_t dice = random_.below(12);
    if (dice == 0) return NumericIdentity{0x9ddb3b5f};
    if (dice == 1) return TextIdentity{one_of<2>({"service-3352", "service-724358"})};
    if (dice == 2 || dice == 4) return NumericIdentity{id32(semantic(one_of<3>({"Ball", "OwnBall", "Twin5106"})))};
    if (dice == 3) return semantic(one_of<2>({"Twin5106", "Twin101771"}));  // two concepts with one number
    const char* concept_name =
        one_of<10>({"Tracked", "Ball", "Sphere", "OwnBall", "Robot", "Ghost", "Round", "New", "Team", "OwnRobot"});
    return semantic(concept_name, one_of<7>({"", "", "Frame", "FieldFrame", "Pitch", "PolarFieldFrame", "NewFrame"}));
  }

  /// The identity of a request or an offer, which may also be a class expression.
  Identity wish() {
    if (crowd_ == Crowd::packed || random_.chance(0.7)) return identity();
    const char* text = one_of<6>({"<Ball> or <Robot>", "<Round> and <Tracked>", "<has> some <Ball>", "not <Ball>",
                                  "<Ball> and <Robot>", "<OwnBall> or <Team>"});
    std::string expression;
    for (const char letter : std::string_view(text)) {
      expression += letter;
      if (letter == '<') expression += "http://example.org/";
    }
    return SemanticIdentity{expression, random_.chance(0.5) ? "" : iri(frame())};
  }

  /// The identity by which a participant describes itself.
  Identity described() {
    const SemanticIdentity named =
        std::get<SemanticIdentity>(semantic(one_of<6>({"Robot", "OwnRobot", "Tracked", "Ball", "New", "Ghost"})));
    const Identity wished = random_.chance(0.5) ? wish() : named;
    const auto* said = std::get_if<SemanticIdentity>(&wished);
    return said == nullptr ? named : SemanticIdentity{said->concept_iri, ""};
  }

  /// The text by which a request says what the provider's participant has to be.
  std::string on() {
    const std::string text = std::get<SemanticIdentity>(described()).concept_iri;
    return has_expression(SemanticIdentity{text, ""}) ? text : '<' + text + '>';
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

  /// The key of a service. Numbers of publications and subscriptions of one peer differ, as in GCNP.
  ServiceKey some_key(bool is_subscription) {
    return key(static_cast<std::uint32_t>(1 + random_.below(4)), static_cast<std::uint32_t>(1 + random_.below(2)),
               static_cast<std::uint32_t>(2 * random_.below(crowd_ == Crowd::packed && !is_subscription ? 9 : 3) +
                                          (is_subscription ? 1 : 0)));
  }

  void state_signature(Attributes& attributes) {
    const char* side = one_of<2>({"inputs", "outputs"});
    const std::string name = one_of<6>({"", "Tracked", "Ball", "OwnBall", "New", "Robot"});
    attributes.erase(side);
    if (!name.empty()) attributes[side] = "<http://example.org/" + name + '>';
  }

 private:
  base::Random random_{0};
  Crowd crowd_;
};

}  // namespace geminga::matching

#endif
