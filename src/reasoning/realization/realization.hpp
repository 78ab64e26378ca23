// The consequences for the individuals of an ontology: types, who is the same, facts, and the instances of an
// expression.
//
// One model of all facts says what is certain and what is possible; only what lies between is asked (Glimm, Horrocks,
// Motik, Shearer, Stoilos: A novel approach to ontology classification, 2012, sections 4 and 6). On Horn axioms the
// model is derived without a choice, and nothing is asked.
#ifndef GEMINGA_REASONING_REALIZATION_REALIZATION_HPP
#define GEMINGA_REASONING_REALIZATION_REALIZATION_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "base/budget.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/taxonomy/classification.hpp"

namespace geminga::realization {

/// The octets of a fact that is kept and written, without its texts.
inline constexpr std::size_t fact_octets = 200;

struct Options {
  /// Pays for the work. When it is spent, the result is what is certain by then. Null: only the limits of each question
  /// hold. Borrowed.
  base::Budget* budget = nullptr;
  /// Whether the facts are wanted, too.
  bool with_facts = false;
  /// The most octets of facts: fact_octets and the texts for each. A thing with n names has n * n facts for a link to
  /// itself.
  std::size_t most_fact_octets = std::numeric_limits<std::size_t>::max();
  /// Called from time to time with what is being done and how far it is, in [0, 1].
  std::function<void(std::string_view phase, double done)> progress{};
};

/// A fact that follows: a property, and the object of an object property or the literal of a data property.
struct Fact {
  owl::TermId subject{};
  owl::TermId property{};
  owl::TermId object{};
  friend auto operator<=>(const Fact&, const Fact&) = default;
};

/// Everything in it follows, whatever is left open. What is anonymous is in none of the lists.
struct Realization {
  bool is_consistent = true;  ///< false: everything follows, and the lists are empty
  /// The named individuals, ascending by IRI (octet by octet). The lists below have an entry for each.
  std::vector<owl::TermId> individuals;
  /// The first individual that is certainly the same; itself for most.
  std::vector<std::uint32_t> representative;
  /// The types of each, as a number of a set.
  std::vector<std::uint32_t> types;
  /// Representatives of the classification, ascending, without owl:Thing's; with a class all classes above it.
  std::vector<std::vector<taxonomy::ClassNumber>> type_sets;
  std::vector<Fact> facts;  ///< ascending by terms, each once; where they are wanted
  /// There are more facts than the limit of octets allows, and `facts` is empty.
  bool has_too_many_facts = false;
  /// Why something may be missing, one line each: sorted, each once. Empty: nothing is.
  std::vector<std::string> gaps;
  /// Individuals that may have more types or be the same as others, ascending. Empty if there is no gap.
  std::vector<std::uint32_t> undecided;
  /// No model was built within the limits, or an axiom was not used.
  bool is_consistency_open = false;
};

/// Realises the ontology. The classification must be that of the source. Adds the literals of facts whose values rules
/// or ranges have made.
[[nodiscard]] Realization realize(owl::Ontology& source, const taxonomy::Classification& classification,
                                  const Options& options = {});

/// The most specific ones of a set of types.
[[nodiscard]] std::vector<taxonomy::ClassNumber> most_specific(const taxonomy::Classification& classification,
                                                               const std::vector<taxonomy::ClassNumber>& types);

/// The named individuals that are certainly in a class expression, and those of which it is not decided. Both ascend by
/// IRI.
struct Instances {
  bool is_consistent = true;
  std::vector<owl::TermId> found;
  std::vector<owl::TermId> undecided;
  std::vector<std::string> gaps;  ///< as Realization::gaps
  /// No model was built within the limits, or an axiom was not used.
  bool is_consistency_open = false;
};

/// Finds the instances of a class expression of the source. Adds a class above it, with a name that nothing else has.
[[nodiscard]] Instances find_instances(owl::Ontology& source, owl::TermId expression, const Options& options = {});

}  // namespace geminga::realization

#endif
