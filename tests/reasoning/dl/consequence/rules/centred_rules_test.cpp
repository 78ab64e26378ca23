// The three ways in which a rule about a neighbour's concepts becomes rules about one centre.
#include "reasoning/dl/consequence/rules/centred_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geminga::consequence {
namespace {

using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

constexpr std::uint32_t a = 0;
constexpr std::uint32_t b = 1;
constexpr std::uint32_t h = 2;
constexpr std::uint32_t predicates = 3;
constexpr std::uint32_t r = 0;
constexpr std::uint32_t roles = 1;

[[nodiscard]] RuleAtom outgoing(std::uint32_t role, std::uint8_t variable) {
  return {LiteralKind::outgoing, variable, 0, role};
}
[[nodiscard]] RuleAtom incoming(std::uint32_t role, std::uint8_t variable) {
  return {LiteralKind::incoming, variable, 0, role};
}
[[nodiscard]] Rule rule(Atoms body, Atoms head, std::uint8_t neighbours) {
  return {std::move(body), std::move(head), neighbours, false};
}
[[nodiscard]] RuleSet centred(const Atoms& body, const Atoms& head) {
  CentredRules rules(predicates, roles);
  rules.add(body, head);
  RuleSet set;
  rules.move_to(set);
  return set;
}

TEST(CentredRules, LeaveARuleAboutTheCentreAsItIs) {
  const RuleSet set = centred({unary_atom(a), outgoing(r, 1)}, {unary_atom(h, 1)});
  EXPECT_THAT(set.rules, UnorderedElementsAre(rule({unary_atom(a), outgoing(r, 1)}, {unary_atom(h, 1)}, 1)));
}

TEST(CentredRules, MakeTheNeighbourTheCentreIfNothingIsSaidOfTheCentre) {
  // B(y), R(x,y) -> H(x)  becomes  B(x), R(y,x) -> H(y)
  const RuleSet set = centred({unary_atom(b, 1), outgoing(r, 1)}, {unary_atom(h)});
  EXPECT_THAT(set.rules, UnorderedElementsAre(rule({unary_atom(b), incoming(r, 1)}, {unary_atom(h, 1)}, 1)));
}

TEST(CentredRules, NameTheConceptOfHavingSuchANeighbour) {
  // A(x), B(y), R(x,y) -> H(x)  becomes  B(x), R(y,x) -> P(y)  and  A(x), P(x) -> H(x)
  const RuleSet set = centred({unary_atom(a), unary_atom(b, 1), outgoing(r, 1)}, {unary_atom(h)});
  EXPECT_EQ(set.predicate_count, predicates + 1);
  EXPECT_THAT(set.rules, UnorderedElementsAre(rule({unary_atom(b), incoming(r, 1)}, {unary_atom(predicates, 1)}, 1),
                                              rule({unary_atom(a), unary_atom(predicates)}, {unary_atom(h)}, 0)));
}

TEST(CentredRules, NameTheRoleIfTheHeadSpeaksOfTheNeighbour) {
  // A(x), B(y), R(x,y) -> H(y)  becomes  B(x), R(y,x) -> R'(y,x)  and  A(x), R'(x,y) -> H(y)
  const RuleSet set = centred({unary_atom(a), unary_atom(b, 1), outgoing(r, 1)}, {unary_atom(h, 1)});
  EXPECT_EQ(set.role_count, roles + 1);
  EXPECT_THAT(set.rules, UnorderedElementsAre(rule({unary_atom(b), incoming(r, 1)}, {incoming(roles, 1)}, 1),
                                              rule({unary_atom(a), outgoing(roles, 1)}, {unary_atom(h, 1)}, 1)));
}

TEST(CentredRules, AreAGapWhereAVariableIsNoNeighbour) {
  const RuleSet set = centred({unary_atom(a), unary_atom(b, 1)}, {unary_atom(h)});
  EXPECT_THAT(set.rules, IsEmpty());
  EXPECT_THAT(set.gaps, SizeIs(1));
}

}  // namespace
}  // namespace geminga::consequence
