// Keys, which OWL 2 gives to named individuals only, as nominals.
#ifndef GEMINGA_REASONING_EL_NORMALISER_KEY_NORMALISER_HPP
#define GEMINGA_REASONING_EL_NORMALISER_KEY_NORMALISER_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/el/normaliser/expression_normaliser.hpp"
#include "reasoning/el/normaliser/pending_uses.hpp"
#include "reasoning/el/normaliser/property_roles.hpp"
#include "reasoning/el/normaliser/term_expressions.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::el {

/// The limit of combinations of values that one key is written out for. Beyond it the key is left out and named.
inline constexpr std::size_t max_key_tuples = std::size_t{1} << 16;

/// Collects keys, and writes out each for all values when these are known.
class KeyNormaliser {
 public:
  KeyNormaliser(const owl::Ontology& source, IndexBuilder& index, TermExpressions& terms,
                ExpressionNormaliser& expressions, PendingUses& pending)
      : source_(source), index_(index), terms_(terms), expressions_(expressions), pending_(pending) {}

  /// Adds the key that is the current axiom. Returns the first construct of it that is not used.
  owl::Construct add(const owl::Axiom& axiom);
  /// Writes out the keys, and adds those that are too large to `unused`. To be called once, after the last axiom.
  void finish(UnusedAxioms& unused);

 private:
  struct Key {
    std::uint32_t axiom = 0;
    ExprId of{};
    std::vector<Property> properties;
  };
  /// The values to which the properties of keys may lead.
  struct Values {
    std::vector<ExprId> individuals;
    std::vector<owl::TermId> literals;
    [[nodiscard]] std::size_t count(const Property& property) const {
      return property.is_data ? literals.size() : individuals.size();
    }
  };

  [[nodiscard]] Values find_values();
  [[nodiscard]] static std::size_t count_tuples(const Key& key, const Values& values);
  void write_out(const Key& key, ExprId is_named, std::size_t tuples, const Values& values);
  void make_rule(const Key& key, ExprId is_named, std::size_t tuple, const std::vector<ExprId>& individuals,
                 const std::vector<ExprId>& literals);

  const owl::Ontology& source_;
  IndexBuilder& index_;
  TermExpressions& terms_;
  ExpressionNormaliser& expressions_;
  PendingUses& pending_;
  std::vector<Key> keys_;
};

}  // namespace geminga::el

#endif
