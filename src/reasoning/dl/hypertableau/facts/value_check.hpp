// Whether the values of a model under construction exist: constants, ranges, and which must differ.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_VALUE_CHECK_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_VALUE_CHECK_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/values/value_ranges.hpp"

namespace geminga::hypertableau {

/// As many attempts are made to give values that must differ to the nodes of one group; beyond, it is not known
/// whether there are enough.
inline constexpr std::size_t max_value_attempts = 100'000;

/// As many values may rules make that no literal names.
inline constexpr std::size_t max_made_values = 100'000;
/// The number of the first of them; sources hold fewer terms.
inline constexpr std::uint32_t first_made_value = 0x80000000U;
static_assert(owl::SourceLimits{}.terms < first_made_value);
/// The most pairs of values that must differ because one is in an opaque set and the other is not.
inline constexpr std::size_t max_opaque_pairs = 100'000;

/// Knows the value spaces of one ClauseSet.
class ValueCheck {
 public:
  ValueCheck(const owl::Ontology& source, const clauses::ClauseSet& set) : ranges_(source, set) {}

  /// The literal of a range of its one value; nothing of other ranges.
  [[nodiscard]] std::optional<owl::TermId> literal_of(std::uint32_t range) const { return ranges_.literal_of(range); }
  /// Whether a literal is in a data range; nothing where it cannot be known.
  [[nodiscard]] std::optional<bool> is_in(owl::TermId literal, std::uint32_t range);
  /// Whether two literals certainly have different values.
  [[nodiscard]] bool are_different(owl::TermId first, owl::TermId second);
  /// The first literal that was asked about with the same value.
  [[nodiscard]] owl::TermId representative(owl::TermId literal);
  [[nodiscard]] const std::optional<Value>& value(owl::TermId literal) { return ranges_.value(literal); }
  /// A literal with this value, which may stand in no ontology; nothing if max_made_values are made.
  [[nodiscard]] std::optional<owl::TermId> made(const Value& value);
  /// The only value that the ranges of a node allow, and the facts that say so. `is_free`: they allow infinitely many.
  [[nodiscard]] std::optional<owl::TermId> only_value(const Graph& graph, NodeId node, DependencySet& dependency,
                                                      bool& is_free);
  /// The facts because of which the values that are active cannot all exist; nothing where they can. `unknown` is set
  /// to a reason where that could not be found out. Where the facts of individuals are not in the graph, they may say
  /// of some of few values that they are in an opaque set, or not.
  [[nodiscard]] std::optional<DependencySet> clash(Graph& graph, std::string& unknown, bool has_all_facts);
  /// Whether it is known of each value whether it is in each range of the set. Costs a look at each range, once.
  [[nodiscard]] bool knows_all_ranges();
  /// clash() looks at no more values before this node that are no constants: nothing about them changes any more.
  void settle(const Graph& graph, NodeId first);
  /// The values that clash() looked at since the last call: all but those that are free and have not changed.
  [[nodiscard]] std::size_t take_looked() { return std::exchange(looked_, 0); }

 private:
  /// A node that has ranges or must differ from others.
  struct Variable {
    NodeId node = 0;
    DependencySet dependency = no_dependency;  ///< of its ranges
    std::uint32_t known = 0;                   ///< its set, in sets_
    std::vector<std::uint32_t> differs;        ///< other variables
    std::vector<DependencySet> because;        ///< of each of them
  };
  struct Counted {
    KnownSet set;
    std::uint64_t least = 0;
    std::uint64_t most = 0;
  };

  static constexpr std::uint32_t no_set = 0xffffffff;
  /// The findings of the last look at a value; they hold while its versions are the same.
  struct Look {
    std::uint64_t version = 0;
    std::uint64_t surroundings = 0;
    std::uint32_t known = no_set;  ///< its set, in sets_
    bool is_free = false;          ///< it has a value, and need not differ from any other
  };

  /// Whether a value that need not differ from a named one always exists, whatever the others are.
  [[nodiscard]] bool can_be_alone(const Counted& counted) const;
  /// Whether the findings of the last look at the value hold.
  [[nodiscard]] bool is_unchanged(const Graph& graph, NodeId node) const;
  /// Whether the node is a value that is not known to be free. The node may be gone.
  [[nodiscard]] bool needs_look(const Graph& graph, NodeId node) const;
  [[nodiscard]] std::vector<Variable> variables_of(Graph& graph);
  /// Lets the values in an opaque set differ from those outside of it. Returns why that is not all that opaque sets
  /// say; empty: it is.
  std::string separate_opaque(std::vector<Variable>& variables, bool has_all_facts) const;
  std::uint32_t known_set(const std::vector<std::uint32_t>& ranges, std::uint32_t literal);
  /// Whether different values can be given; nothing after too many attempts.
  [[nodiscard]] std::optional<bool> can_differ(const std::vector<Variable>& variables,
                                               const std::vector<std::uint32_t>& group, bool uses_most);

  ValueRanges ranges_;
  std::map<std::pair<std::vector<std::uint32_t>, std::uint32_t>, std::uint32_t> set_of_ranges_;
  std::vector<Counted> sets_;
  std::vector<Look> last_looks_;          ///< by node
  std::set<NodeId> looked_at_;            ///< values that were not free at the last look, or have changed since
  std::vector<std::uint32_t> number_of_;  ///< by node: of its variable, while variables_of() runs; else none
  std::size_t looked_ = 0;
  NodeId settled_ = 0;  ///< values before it that are no constants are not looked at
  std::optional<bool> knows_all_ranges_;
  std::map<Value, owl::TermId> representative_;
  std::uint32_t made_ = 0;  ///< values that no literal names
};

}  // namespace geminga::hypertableau

#endif
