// Contexts, found by their keys, and the messages that they get.
#include "reasoning/dl/consequence/context_table.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "reasoning/dl/consequence/outbox.hpp"

namespace geminga::consequence {
namespace {

[[nodiscard]] ContextKey key_of(std::uint32_t predicate) {
  ContextKey key;
  key.core.push_back(unary(predicate, x_term));
  return key;
}

[[nodiscard]] Rules rules_of(std::uint32_t predicates) {
  RuleSet set;
  set.predicate_count = set.query_count = predicates;
  set.is_open.assign(predicates, false);
  return Rules(std::move(set));
}

class TableOfContexts : public testing::Test {
 private:
  base::Arena arena_;
  ArenaUse use_{arena_};
};

TEST_F(TableOfContexts, HasOneContextForEachKey) {
  const Rules rules = rules_of(2000);
  ContextTable table(rules, {});
  std::set<const Context*> contexts;
  for (std::uint32_t predicate = 0; predicate < 2000; ++predicate) {
    const auto made = table.find_or_make(key_of(predicate));
    EXPECT_TRUE(made.is_new);
    EXPECT_TRUE(contexts.insert(&made.context).second) << predicate;
  }
  for (std::uint32_t predicate = 0; predicate < 2000; ++predicate) {
    const auto found = table.find_or_make(key_of(predicate));
    EXPECT_FALSE(found.is_new);
    EXPECT_EQ(&found.context, table.find(key_of(predicate))) << predicate;
  }
  EXPECT_EQ(table.size(), 2000U);
  EXPECT_EQ(table.find({}), nullptr);
}

TEST_F(TableOfContexts, AnswersQueriesAboutTheWantedPredicatesAndEverything) {
  const Rules rules = rules_of(3);
  const std::vector<std::uint32_t> wanted{1};
  ContextTable table(rules, wanted);
  EXPECT_TRUE(table.find_or_make({}).context.answers_queries);
  EXPECT_TRUE(table.find_or_make(key_of(1)).context.answers_queries);
  EXPECT_FALSE(table.find_or_make(key_of(2)).context.answers_queries);
  ContextKey of_function;
  of_function.function = 0;
  EXPECT_FALSE(table.find_or_make(std::move(of_function)).context.answers_queries);
}

TEST_F(TableOfContexts, GivesANewContextItsFirstMessageAndKeepsTheOrder) {
  const Rules rules = rules_of(3);
  ContextTable table(rules, {});
  Schedule schedule;
  SharedEffort effort({.clauses = 10, .alternatives = 0});
  Outbox outbox(table, schedule, effort, 0);
  Context& to = outbox.context_for(key_of(1));
  EXPECT_EQ(&outbox.context_for(key_of(1)), &to);
  const Literal body = unary(1, x_term);
  outbox.send(to, MessageKind::edge, nullptr, successor(4), std::span(&body, 1));
  Pooled<Message> messages;
  Pooled<Literal> literals;
  ASSERT_TRUE(to.mailbox.take(messages, literals, false));
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].kind, MessageKind::start);
  EXPECT_EQ(messages[1].kind, MessageKind::edge);
  EXPECT_EQ(messages[1].f, successor(4));
  EXPECT_EQ(std::vector(literals.begin(), literals.end()), std::vector{body});
  EXPECT_FALSE(to.mailbox.take(messages, literals, false));
}

TEST_F(TableOfContexts, SchedulesAContextOnceUntilItsMailboxWasFoundEmpty) {
  Mailbox mailbox;
  Pooled<Message> messages;
  Pooled<Literal> literals;
  EXPECT_TRUE(mailbox.put(MessageKind::start, nullptr, x_term, {}, {}));
  EXPECT_FALSE(mailbox.put(MessageKind::exists, nullptr, x_term, {}, {}));
  EXPECT_TRUE(mailbox.take(messages, literals, false));
  EXPECT_FALSE(mailbox.put(MessageKind::exists, nullptr, x_term, {}, {}));
  EXPECT_TRUE(mailbox.take(messages, literals, false));
  EXPECT_FALSE(mailbox.take(messages, literals, false));
  EXPECT_TRUE(mailbox.put(MessageKind::exists, nullptr, x_term, {}, {}));
  EXPECT_FALSE(mailbox.take(messages, literals, true));
  EXPECT_TRUE(mailbox.put(MessageKind::exists, nullptr, x_term, {}, {}));
}

}  // namespace
}  // namespace geminga::consequence
