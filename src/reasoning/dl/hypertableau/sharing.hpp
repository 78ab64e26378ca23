// Neighbours that are there and satisfy a part of an at-least of several.
//
//   >= n R.B(x), R(x,y1), B(y1), ..., R(x,yk), B(yk), the y known to differ:  n - k new ones (lemma 4 of README.md).
//   The same where it is not known that the y differ, or that some are R-neighbours in B: a guess that they are. If it
//   fails, n - k new ones are made for the known ones only, which is complete without the guess.
//
// Three children who are not told to differ satisfy "at least three children" by the guess. Without it three more are
// made, and then a bound merges children pair after pair. The guess is a reuse of individuals as by Motik and Horrocks
// (Individual reuse in description logic reasoning, 2008), of neighbours only.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_SHARING_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_SHARING_HPP

#include <cstddef>
#include <span>
#include <vector>

#include "reasoning/dl/hypertableau/choice_records.hpp"
#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/facts/neighbours.hpp"
#include "reasoning/dl/hypertableau/facts/numbers.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

class Sharing {
 public:
  Sharing(const Program& program, const Graph& graph, Assertions& facts, Neighbours& neighbours, const Numbers& numbers,
          const ChoiceRecords& records)
      : program_(program),
        graph_(graph),
        facts_(facts),
        neighbours_(neighbours),
        numbers_(numbers),
        records_(records) {}

  /// The neighbours that are known to be among those that the at-least asks for, and to differ, but for one at most.
  /// Unites the reasons into `dependency`.
  [[nodiscard]] std::vector<NodeId> find_different(const Fact& at_least, DependencySet& dependency);
  /// Whether a guess may save neighbours, and such guesses did not fail more often than not.
  [[nodiscard]] bool is_promising(const Fact& at_least);
  /// Guesses that neighbours are among those that the at-least asks for, and returns them.
  std::vector<NodeId> share(const Fact& at_least, DependencySet dependency);

 private:
  [[nodiscard]] std::vector<NodeId> find_sharable(const Fact& at_least);
  void add_members(const Fact& at_least, std::vector<NodeId>& found) const;
  void add_counted(const Fact& at_least, std::uint32_t bound, std::size_t missing, std::vector<NodeId>& found);

  const Program& program_;
  const Graph& graph_;
  Assertions& facts_;
  Neighbours& neighbours_;
  const Numbers& numbers_;
  const ChoiceRecords& records_;
};

}  // namespace geminga::hypertableau

#endif
