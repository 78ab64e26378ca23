// The vocabularies at work: the one in force, and another one while the two change places.
#ifndef GEMINGA_DISCOVERY_MATCHING_EDITIONS_HPP
#define GEMINGA_DISCOVERY_MATCHING_EDITIONS_HPP

#include <cstdint>
#include <memory>

#include "discovery/matching/conversions/converters.hpp"
#include "discovery/registry/stored.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// A vocabulary at work, with the converters that it knows and the generation of the registry's index filed by it.
struct Edition {
  vocabulary::Vocabulary vocabulary;
  registry::Generation generation = registry::Generation::even;
  std::shared_ptr<Converters> converters{};  ///< null where there is no vocabulary
};

/// How far the change to another vocabulary is. A subscription is judged by one edition at any time and filed in the
/// index of that one alone. Publications are known by both from the beginning of `filing` to the end of `rematching`.
enum class ChangeStage : std::uint8_t {
  none,
  filing,      ///< publications are filed by the next edition, too; everything is judged by the one in force
  rematching,  ///< the next edition is in force; one subscription after the other is judged by it
  unfiling,    ///< publications are taken out of the index of the former edition
};

/// Resource: neither copied nor moved, since others refer to its editions.
class Editions {
 public:
  explicit Editions(const vocabulary::Vocabulary& vocabulary);
  Editions(const Editions&) = delete;
  Editions& operator=(const Editions&) = delete;

  [[nodiscard]] const Edition& in_force() const { return in_force_; }
  [[nodiscard]] const vocabulary::Vocabulary& vocabulary() const { return in_force_.vocabulary; }
  /// The next edition while filing, then the former one. Without vocabulary and converters outside of a change.
  [[nodiscard]] const Edition& other() const { return other_; }
  [[nodiscard]] const Edition& by_generation(registry::Generation generation) const {
    return generation == in_force_.generation ? in_force_ : other_;
  }
  [[nodiscard]] ChangeStage stage() const { return stage_; }
  /// Whether publications are known by both editions.
  [[nodiscard]] bool are_both_filed() const {
    return stage_ == ChangeStage::filing || stage_ == ChangeStage::rematching;
  }

  /// Each of these takes a change to its next stage, in this order, and asserts that it is in the one before.
  void begin_filing(const vocabulary::Vocabulary& next);
  void begin_rematching();
  void begin_unfiling();
  void end_change();

  /// Takes the vocabulary in force prepared for expressions. False where this is of another ontology, or the one in
  /// force is prepared already.
  bool take_prepared(vocabulary::Vocabulary prepared);

 private:
  Edition in_force_;
  Edition other_;
  ChangeStage stage_ = ChangeStage::none;
};

}  // namespace geminga::matching

#endif
