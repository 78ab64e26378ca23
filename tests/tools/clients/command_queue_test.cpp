// The commands that programs run: variables, the queue and its limits.
#include "shell/command_queue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/object.hpp>
#include <csignal>
#include <cstdlib>

#include "geminga/event.hpp"
#include "shell/event_variables.hpp"
#include "shell/json.hpp"

namespace geminga::shell {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A command that runs until it is ended, so that all others wait.
const CommandOptions endless{.command = "exec sleep 1000", .time = std::nullopt, .connect = ""};

/// Adds events that wait behind one whose command runs.
void fill(CommandQueue& queue, std::size_t count) {
  for (std::size_t i = 0; i <= count; ++i) queue.add({{"event", "add"}});
}

TEST(CommandQueue, HasRoomForSoManyEvents) {
  CommandQueue queue("test", endless);
  EXPECT_TRUE(queue.is_idle());
  fill(queue, max_waiting_commands - 1);
  EXPECT_TRUE(queue.has_room());
  queue.add({{"event", "add"}});
  EXPECT_FALSE(queue.has_room());
  queue.add({{"event", "add"}});  // an event that was on its way is not lost
  EXPECT_FALSE(queue.has_room());
  testing::internal::CaptureStderr();
  queue.stop(SIGTERM);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr(std::to_string(max_waiting_commands + 1)));
  EXPECT_TRUE(queue.is_idle());
  EXPECT_TRUE(queue.has_room());
}

/// An event with so many octets more than one with an empty text.
boost::json::object event_with(std::size_t octets) {
  return {{"event", "add"}, {"attributes", {{"not-a-variable", std::string(octets, 'x')}}}};
}

TEST(CommandQueue, HasRoomForSoManyOctets) {
  CommandQueue queue("test", endless);
  fill(queue, 0);
  queue.add(event_with(0));
  const std::size_t empty = queue.waiting_octets();
  queue.add(event_with(max_waiting_octets - 1 - 2 * empty));
  EXPECT_EQ(queue.waiting_octets(), max_waiting_octets - 1);
  EXPECT_TRUE(queue.has_room());
  queue.stop(SIGTERM);
  fill(queue, 0);
  queue.add(event_with(max_waiting_octets - empty));
  EXPECT_EQ(queue.waiting_octets(), max_waiting_octets);
  EXPECT_FALSE(queue.has_room());
  queue.stop(SIGTERM);
}

TEST(CommandQueue, GivesACommandMoreThanAPipeHolds) {
  CommandQueue queue("test", {.command = "test $(wc -c) -gt 1000000", .time = std::nullopt, .connect = ""});
  testing::internal::CaptureStderr();
  queue.add(event_with(1'000'000));
  while (!queue.is_idle()) queue.process();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(CommandQueue, SaysWhereACommandCannotBeStarted) {
  CommandQueue queue("test", {.command = "true", .time = std::nullopt, .connect = ""});
  testing::internal::CaptureStderr();
  queue.add({{"event", "add"}, {"service", "a/1/1"}, {"text", std::string(1'000'000, 'x')}});
  EXPECT_TRUE(queue.is_idle());
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              StartsWith("test: --exec: could not be started: /bin/sh: Argument list too long (add a/1/1)"));
}

TEST(EventVariables, HoldNumbersTextsAndAttributes) {
  EXPECT_THAT(
      event_variables({{"event", "add"},
                       {"port", 5000},
                       {"former", {{"port", 4999}}},
                       {"attributes", {{"rate", "30"}, {"a.b", "1"}, {"x=y", "2"}, {"empty", ""}}}}),
      ElementsAre("GEMINGA_EVENT=add", "GEMINGA_PORT=5000", "GEMINGA_ATTRIBUTE_rate=30", "GEMINGA_ATTRIBUTE_empty="));
}

TEST(EventVariables, LeaveOutWhatAVariableCannotHold) {
  EXPECT_THAT(event_variables({{"text", std::string("a\0b", 3)}, {"name", "a\nb=c"}}),
              ElementsAre("GEMINGA_NAME=a\nb=c"));
}

TEST(EventVariables, AreNamedInTheHelp) {
  ServiceEvent service;
  service.publication.identity = ConceptNames{"soccer:BallInfo", "soccer:Pixels"};
  service.publication.address = "10.0.0.2";
  service.publication.port = 1;
  service.convert = "A>B";
  ConsumerEvent consumer;
  consumer.subscribed.identity = NumericIdentity{1};
  ServiceEvent text;
  text.publication.identity = TextIdentity{"camera"};
  ServiceEvent gone;
  gone.change = Change::del;
  for (const auto& event : {to_json(service), to_json(consumer), to_json(text), to_json(gone)}) {
    for (const std::string& variable : event_variables(stamped(event))) {
      const std::string name = variable.substr(0, variable.find('='));
      EXPECT_TRUE(exec_words.contains(name)) << name;
    }
  }
  EXPECT_THAT(std::string(exec_words), HasSubstr(std::to_string(max_waiting_commands) + " events may wait"));
  EXPECT_THAT(std::string(exec_words), HasSubstr(std::to_string(command_grace.count()) + " s later"));
}

TEST(EventVariables, AreTheOnlyOnesOfTheirKindInTheEnvironment) {
  ::setenv("GEMINGA_PORT", "4717", 1);
  ::setenv("GEMINGA_CONNECT", "here", 1);
  ::setenv("UNTOUCHED", "yes", 1);
  const auto own = environment_with({"GEMINGA_EVENT=add"}, "");
  EXPECT_THAT(own, Contains("GEMINGA_EVENT=add"));
  EXPECT_THAT(own, Contains("GEMINGA_CONNECT=here"));
  EXPECT_THAT(own, Contains("UNTOUCHED=yes"));
  EXPECT_THAT(own, Not(Contains("GEMINGA_PORT=4717")));
  const auto told = environment_with({}, "there");
  EXPECT_THAT(told, Contains("GEMINGA_CONNECT=there"));
  EXPECT_THAT(told, Not(Contains("GEMINGA_CONNECT=here")));
  for (const char* name : {"GEMINGA_PORT", "GEMINGA_CONNECT", "UNTOUCHED"}) ::unsetenv(name);
}

}  // namespace
}  // namespace geminga::shell
