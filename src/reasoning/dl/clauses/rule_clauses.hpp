// From rules to the rules of a clause set, and to the clauses that define what their atoms need.
#ifndef GEMINGA_REASONING_DL_CLAUSES_RULE_CLAUSES_HPP
#define GEMINGA_REASONING_DL_CLAUSES_RULE_CLAUSES_HPP

#include <map>
#include <string_view>

#include "reasoning/dl/clauses/allowed.hpp"
#include "reasoning/dl/clauses/ordered_axiom.hpp"
#include "reasoning/dl/clauses/translator.hpp"

namespace geminga::clauses {

class RuleClauses {
 public:
  RuleClauses(Vocabulary& vocabulary, const owl::RoleBox& roles, Allowed& allowed, Translator& translator,
              ClauseSet& set)
      : vocabulary_(vocabulary), roles_(roles), allowed_(allowed), translator_(translator), set_(set) {}

  /// Adds a rule. Returns why it is not used at all; empty: it is, and what is not known of it is in `open_rules`.
  std::string_view add(const OrderedAxiom& axiom);

 private:
  RuleTerm term(owl::TermId id, bool is_value);
  void add_to_body(owl::TermId id);
  void add_to_head(owl::TermId id);
  RuleAtom class_atom(const owl::Term& atom, bool is_head);
  RuleAtom property_atom(const owl::Term& atom, bool is_head);
  RuleAtom data_atom(const owl::Term& atom, bool is_head);
  RuleAtom built_in(const owl::Term& atom);
  RuleAtom unknown(std::string_view problem, const owl::Term& atom);
  std::uint32_t path(Role role);
  ConceptId has_value(owl::TermId property, owl::TermId literal);
  /// Finds values that nothing binds. An atom that needs one is unknown.
  void check_bound();

  Vocabulary& vocabulary_;
  const owl::RoleBox& roles_;
  Allowed& allowed_;
  Translator& translator_;
  ClauseSet& set_;
  Rule rule_;
  std::map<owl::TermId, std::uint32_t> variables_;
  bool is_mixed_ = false;  ///< a variable stands for an individual and for a value
  std::map<Role, std::uint32_t> paths_;
  std::map<std::pair<owl::TermId, owl::TermId>, ConceptId> has_values_;
};

}  // namespace geminga::clauses

#endif
