// Walks the worked examples and tables of src/discovery/gcnp/GCNP.md.
#include "discovery/gcnp/specification.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <utility>

#include "base/text.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/gcnp/request.hpp"
#include "discovery/gcnp/reserved.hpp"
#include "discovery/gcnp/statement.hpp"

namespace geminga::gcnp {
namespace {

TEST(GcnpSpecification, HasRequestsThatAreReadAndWrittenAgain) {
  const auto found = examples("requests");
  ASSERT_GE(found.size(), 30U);
  for (const auto& [line, expected] : found) {
    const auto statement = parse(line);
    ASSERT_TRUE(statement) << line << ": " << statement.error().error.text;
    const auto request = read_request(*statement);
    ASSERT_TRUE(request) << line << ": " << request.error().text;
    EXPECT_EQ(to_line(to_statement(statement->id, *request)), expected + "\r\n");
    const auto again = read_request(*parse(expected));
    ASSERT_TRUE(again) << expected;
    EXPECT_TRUE(*again == *request) << expected;
  }
}

TEST(GcnpSpecification, HasLinesThatAreRefusedWithTheirIdAndCode) {
  const auto found = examples("refused");
  ASSERT_GE(found.size(), 40U);
  for (const auto& [line, expected] : found) {
    std::uint32_t id = 0;
    Error error;
    if (const auto statement = parse(line); !statement) {
      id = statement.error().id;
      error = statement.error().error;
    } else {
      const auto request = read_request(*statement);
      ASSERT_FALSE(request) << line;
      id = statement->id;
      error = request.error();
    }
    EXPECT_EQ(std::to_string(id) + ' ' + std::to_string(std::to_underlying(error.code)), expected) << line;
    EXPECT_FALSE(error.text.empty()) << line;
    EXPECT_FALSE(base::has_control_character(error.text)) << line;
  }
}

TEST(GcnpSpecification, HasEventsThatAClientReadsAndWritesAgain) {
  const auto found = examples("events");
  ASSERT_GE(found.size(), 8U);
  for (const auto& [line, expected] : found) {
    const auto reply = read_reply(line);
    ASSERT_TRUE(reply) << line << ": " << reply.error().text;
    const auto* event = std::get_if<Event>(&*reply);
    ASSERT_NE(event, nullptr) << line;
    const std::string written = std::visit(
        [&](const auto& what) {
          if constexpr (std::is_same_v<std::decay_t<decltype(what)>, Error>) {
            return to_line(event->request, what);
          } else {
            return to_line(to_statement(event->request, what));
          }
        },
        event->what);
    EXPECT_EQ(written, expected + "\r\n");
  }
}

TEST(GcnpSpecification, NamesTheReservedKeysInTheOrderOfTheCode) {
  std::vector<std::string> named;
  for (const auto& [line, expected] : examples("reserved")) {
    std::istringstream words(line);
    for (std::string word; words >> word;) named.push_back(word);
  }
  EXPECT_THAT(named, testing::ElementsAreArray(reserved_keys.begin(), reserved_keys.end()));
}

}  // namespace
}  // namespace geminga::gcnp
