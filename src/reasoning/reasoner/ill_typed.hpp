// Answers that take account of axioms with ill-typed literals: an answer is certain if every repair of these axioms
// gives it.
#ifndef GEMINGA_REASONING_REASONER_ILL_TYPED_HPP
#define GEMINGA_REASONING_REASONER_ILL_TYPED_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/reasoner/reasoner.hpp"

namespace geminga::reasoner {

/// The same as entails_each(), for a premise to which the ill-typed axioms with these numbers belong, too. A repair
/// has, in place of each ill-typed literal, some value of the datatype that it names. What follows without these axioms
/// follows. What follows in no repair does not. Everything else is unknown. The repairs are added to the source.
[[nodiscard]] std::vector<Answer> entails_each(owl::Ontology& source, std::span<const std::uint32_t> premise,
                                               std::span<const std::uint32_t> conclusion,
                                               std::span<const std::size_t> ill_typed, base::Budget* budget = nullptr);

/// Whether a source with all its ill-typed axioms has a model, where `answer` is that for its other axioms: yes if each
/// repair of them has one. The repairs are added to the source.
[[nodiscard]] Answer consistency_of_repairs(owl::Ontology& source, Answer answer, base::Budget* budget = nullptr);
/// The same as is_consistent(), for a source with all its ill-typed axioms: yes if each repair of them has a model.
[[nodiscard]] Answer is_consistent_repaired(owl::Ontology& source, base::Budget* budget = nullptr);

}  // namespace geminga::reasoner

#endif
