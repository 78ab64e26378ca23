// The disjunctions that are open, and the choice of the one that is decided next.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_DISJUNCTIONS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_DISJUNCTIONS_HPP

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "reasoning/dl/hypertableau/choice_records.hpp"
#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/facts/choice.hpp"
#include "reasoning/dl/hypertableau/facts/choice_check.hpp"
#include "reasoning/dl/hypertableau/facts/effort.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// Keeps the disjunctions that were derived, and finds the one to be decided next. One without alternatives left is a
/// clash, and one with a single alternative left is a fact. Of the others, the one with the fewest alternatives for
/// each failure known of them is next.
class Disjunctions {
 public:
  Disjunctions(const Program& program, const Graph& graph, Effort& effort, Assertions& facts, ChoiceCheck& check,
               ChoiceRecords& records)
      : program_(program), graph_(graph), effort_(effort), facts_(facts), check_(check), records_(records) {}

  /// Adds a disjunction, and removes alternatives that cannot hold. A single one left is asserted at once.
  void add(std::vector<Choice>& alternatives, DependencySet dependency);

  /// Nothing is open.
  struct AllDecided {};
  /// A fact or a clash was asserted, because a disjunction had one way left or none.
  struct Asserted {};
  [[nodiscard]] std::variant<AllDecided, Asserted, Decision> find_next();

  /// Sizes of the stacks.
  struct Sizes {
    std::size_t disjunctions = 0;
    std::size_t next = 0;
    std::size_t choices = 0;
    std::size_t done = 0;
  };
  [[nodiscard]] Sizes sizes() const { return {disjunctions_.size(), next_, choices_.size(), done_.size()}; }
  void restore(const Sizes& sizes);

 private:
  /// A range of choices_.
  struct Disjunction {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    DependencySet dependency = no_dependency;
    std::uint32_t left = 0;  ///< alternatives at the last look
    std::uint64_t seen = 0;  ///< state_of() at the last look
    bool is_local = false;   ///< its alternatives are concepts that only the label of their node excludes
    bool is_done = false;    ///< in this branch an alternative holds, or its node is gone
  };
  /// The alternatives of a disjunction that are left.
  struct Open {
    bool is_done = false;  ///< an alternative holds, or its node is gone
    std::vector<Choice> alternatives;
    DependencySet dependency = no_dependency;  ///< of the disjunction and of the facts that exclude the others
  };
  /// Its weight against others: the number of alternatives, and of their failures as far as they are known.
  struct Promise {
    std::uint64_t alternatives = 0;
    std::uint64_t failures = 0;
    [[nodiscard]] bool is_before(const Promise& other) const;
  };

  void open(const Disjunction& disjunction, Open& result);
  /// Looks at the alternatives that are left. True if there is no choice: it is done, or a fact or a clash.
  bool settle(std::size_t disjunction);
  [[nodiscard]] bool is_local(std::span<const Choice> alternatives) const;
  /// The number of what its alternatives depend on; 0 if it has to be looked at anyway.
  [[nodiscard]] std::uint64_t state_of(const Disjunction& disjunction) const;
  void note_done(std::size_t disjunction);
  bool derive(const Choice& choice);

  const Program& program_;
  const Graph& graph_;
  Effort& effort_;
  Assertions& facts_;
  ChoiceCheck& check_;
  ChoiceRecords& records_;
  std::vector<Choice> choices_;
  std::vector<Disjunction> disjunctions_;
  std::size_t next_ = 0;             ///< all before are done
  std::vector<std::uint32_t> done_;  ///< disjunctions, in the order in which they were
  Open open_;                        ///< of the disjunction that was looked at last
};

}  // namespace geminga::hypertableau

#endif
