// Conversations of the Model Context Protocol with a daemon whose answers the test gives.
#include "query/mcp/conversation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/parse.hpp>
#include <boost/json/serialize.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "query/mcp/limits.hpp"

namespace geminga::query::mcp {
namespace {

namespace json = boost::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;

constexpr int cannot_be_parsed = -32700;
constexpr int is_no_request = -32600;
constexpr int unknown_method = -32601;
constexpr int wrong_parameters = -32602;

/// A conversation with what was asked of the daemon.
struct Rig {
  json::value say(const std::string& line) {
    const std::string answer = conversation.answer({line});
    EXPECT_EQ(std::ranges::count(answer, '\n'), 1) << line;
    EXPECT_TRUE(answer.ends_with('\n')) << line;
    return json::parse(answer);
  }
  std::int64_t error_of(const std::string& line) {
    const auto answer = say(line);
    return answer.as_object().contains("error") ? answer.at("error").at("code").as_int64() : 0;
  }
  /// The result of a tool: its text, with `error: ` before it where it is one.
  std::string call(const std::string& tool, const std::string& arguments) {
    const auto answer = say(R"({"jsonrpc":"2.0","id":1,"method":"tools/call","params":{"name":")" + tool +
                            R"(","arguments":)" + arguments + "}}");
    if (!answer.as_object().contains("result")) return json::serialize(answer);
    const auto& result = answer.at("result");
    const auto& content = result.at("content").as_array();
    EXPECT_THAT(content, SizeIs(1));
    EXPECT_EQ(content.at(0).at("type"), "text");
    return (result.at("isError").as_bool() ? "error: " : "") + std::string(content.at(0).at("text").as_string());
  }
  json::value initialize(const std::string& version) {
    return say(R"({"jsonrpc":"2.0","id":0,"method":"initialize","params":{"protocolVersion":")" + version +
               R"(","capabilities":{},"clientInfo":{"name":"test","version":"1"}}})");
  }

  std::vector<std::pair<std::string, answers::Parameters>> asked;
  Result<Answer, ClientError> outcome = Answer{};
  Conversation conversation{[this](const std::string& kind, const answers::Parameters& parameters) {
                              asked.emplace_back(kind, parameters);
                              return outcome;
                            },
                            "9.8.7"};
};

std::string ping(const std::string& id) { return R"({"jsonrpc":"2.0","id":)" + id + R"(,"method":"ping"})"; }

TEST(Conversation, AgreesOnTheVersionThatIsAskedForElseOffersTheLatest) {
  for (const std::string version : {"2025-11-25", "2025-06-18", "2025-03-26", "2024-11-05"}) {
    const auto answer = Rig().initialize(version);
    EXPECT_EQ(answer.at("result").at("protocolVersion"), json::value(version));
    EXPECT_EQ(answer.at("result").at("serverInfo").at("version"), "9.8.7");
    EXPECT_TRUE(answer.at("result").at("capabilities").as_object().contains("tools"));
  }
  EXPECT_EQ(Rig().initialize("1999-01-01").at("result").at("protocolVersion"), "2025-11-25");
  EXPECT_EQ(Rig().error_of(R"({"jsonrpc":"2.0","id":0,"method":"initialize"})"), wrong_parameters);
}

TEST(Conversation, HasAToolForEachQuestionThatSaysItChangesNothing) {
  const auto answer = Rig().say(R"({"jsonrpc":"2.0","id":"a","method":"tools/list"})");
  EXPECT_EQ(answer.at("id"), "a");
  std::vector<std::string> names;
  for (const auto& tool : answer.at("result").at("tools").as_array()) {
    names.emplace_back(tool.at("name").as_string());
    EXPECT_EQ(tool.at("inputSchema").at("type"), "object") << names.back();
    EXPECT_EQ(tool.at("inputSchema").at("additionalProperties"), false) << names.back();
    EXPECT_EQ(tool.at("annotations").at("readOnlyHint"), true) << names.back();
    EXPECT_FALSE(tool.at("description").as_string().empty()) << names.back();
    for (const auto& property : tool.at("inputSchema").at("properties").as_object()) {
      EXPECT_FALSE(property.value().at("description").as_string().empty()) << names.back() << ' ' << property.key();
    }
  }
  for (const char* word : {"participants", "services", "requests", "match", "why", "ontology"}) {
    EXPECT_THAT(names, testing::Contains(word));
  }
  EXPECT_EQ(Rig().error_of(R"({"jsonrpc":"2.0","id":1,"method":"tools/list","params":{"cursor":"x"}})"),
            wrong_parameters);
}

TEST(Conversation, AsksTheDaemonAndAnswersWithTheDocumentOfJson) {
  Rig rig;
  rig.outcome =
      Answer{{{.kind = "services", .fields = {{"service", "1/2/3"}, {"priority", "4"}}, .attributes = {}}}, {}};
  EXPECT_EQ(rig.call("services", R"({"concept":"soccer:BallInfo","unused":true,"id":7})"),
            R"([{"service":"1/2/3","priority":4,"attributes":{}}])");
  ASSERT_THAT(rig.asked, SizeIs(1));
  EXPECT_EQ(rig.asked.front().first, "services");
  EXPECT_THAT(rig.asked.front().second,
              ElementsAre(Pair("concept", "soccer:BallInfo"), Pair("unused", "1"), Pair("id", "7")));
  EXPECT_EQ(rig.call("services", R"({"unused":false})").substr(0, 1), "[");
  EXPECT_THAT(rig.asked.back().second, IsEmpty());
  EXPECT_THAT(rig.call("why", R"({"subscription":"1/2/3","attr.rate":"30"})"), HasSubstr("\"subscription\":\"1/2/3\""));
}

TEST(Conversation, TellsAnAssistantWhatIsWrongWithItsQuestion) {
  Rig rig;
  EXPECT_THAT(rig.call("services", R"({"concpet":"soccer:BallInfo"})"),
              HasSubstr("error: no key 'concpet' goes with services"));
  EXPECT_THAT(rig.call("services", R"({"concept":""})"), HasSubstr("error: concept= has nothing behind it"));
  EXPECT_THAT(rig.call("services", R"({"concept":["a"]})"), HasSubstr("error: concept is no text"));
  EXPECT_THAT(rig.call("services", R"({"limit":1.5})"), HasSubstr("error: limit is no text, whole number or flag"));
  EXPECT_THAT(rig.call("services", R"({"concept":"a\u0000b"})"), HasSubstr("error: concept has a control character"));
  EXPECT_THAT(rig.call("services", R"({"concept":"a\r\n1 pub create"})"),
              HasSubstr("error: concept has a control character"));
  EXPECT_THAT(rig.call("why", R"({"attr.a b":"1"})"), HasSubstr("error: no key 'attr.a b' goes with why"));
  EXPECT_THAT(rig.asked, IsEmpty());
  rig.outcome = std::unexpected(ClientError{ClientError::Kind::unreachable, "no daemon there: start gemingad"});
  EXPECT_EQ(rig.call("participants", "{}"), "error: no daemon there: start gemingad");
}

/// A limit, one below it and one above.
std::vector<std::size_t> around(std::size_t limit) { return {limit - 1, limit, limit + 1}; }

TEST(Conversation, KeepsTheLimitsOfArguments) {
  Rig rig;
  const std::string key = "filter";
  for (const std::size_t octets : around(max_argument_octets)) {
    const std::string text = rig.call("services", R"({"filter":")" + std::string(octets - key.size(), 'x') + "\"}");
    EXPECT_EQ(text.starts_with("error: "), octets > max_argument_octets) << octets;
  }
  for (const std::size_t count : around(max_arguments)) {
    std::string arguments;
    for (std::size_t at = 0; at < count; ++at) {
      arguments += (arguments.empty() ? "\"attr.a" : ",\"attr.a") + std::to_string(at) + R"(":"1")";
    }
    EXPECT_EQ(rig.call("why", "{" + arguments + "}").starts_with("error: "), count > max_arguments) << count;
  }
}

TEST(Conversation, ReplacesADocumentOverTheLimitByAdvice) {
  Rig rig;
  rig.outcome = Answer{{{.kind = "services", .fields = {{"name", ""}}, .attributes = {}}}, {}};
  const std::size_t frame = rig.call("services", "{}").size();
  for (const std::size_t octets : around(max_document_octets)) {
    rig.outcome->records.front().fields.front().second = std::string(octets - frame, 'x');
    const std::string text = rig.call("services", "{}");
    if (octets > max_document_octets) {
      EXPECT_THAT(text, HasSubstr("error: the answer has"));
    } else {
      EXPECT_EQ(text.size(), octets);
    }
  }
}

TEST(Conversation, AnswersWhatIsNoMessageByAnErrorOfJsonRpcAndGoesOn) {
  Rig rig;
  for (const std::string line : {"{", "GET / HTTP/1.1", "\"\xff\"", "{}{}", "\x01", "{\"a\":}"}) {
    EXPECT_EQ(rig.error_of(line), cannot_be_parsed) << line;
  }
  EXPECT_EQ(rig.error_of(std::string(100'000, '[')), cannot_be_parsed) << "deep";
  for (const std::string line :
       {"1", "null", "\"text\"", "[]", "[1]", "{}", R"({"jsonrpc":"2.0"})",
        R"({"jsonrpc":"1.0","id":1,"method":"ping"})", R"({"jsonrpc":"2.0","id":1,"method":7})",
        R"({"jsonrpc":"2.0","id":null,"method":"ping"})", R"({"jsonrpc":"2.0","id":[],"method":"ping"})",
        R"({"jsonrpc":"2.0","id":1.5,"method":"ping"})"}) {
    EXPECT_EQ(rig.error_of(line), is_no_request) << line;
  }
  EXPECT_EQ(rig.error_of(R"({"jsonrpc":"2.0","id":1,"method":"resources/list"})"), unknown_method);
  EXPECT_EQ(rig.error_of(R"({"jsonrpc":"2.0","id":1,"method":"tools/call","params":[1]})"), wrong_parameters);
  EXPECT_EQ(rig.error_of(R"({"jsonrpc":"2.0","id":1,"method":"tools/call"})"), wrong_parameters);
  EXPECT_EQ(rig.error_of(R"({"jsonrpc":"2.0","id":1,"method":"tools/call","params":{"name":"publish"}})"),
            wrong_parameters);
  EXPECT_EQ(rig.error_of(R"({"jsonrpc":"2.0","id":1,"method":"tools/call","params":{"name":"status","arguments":1}})"),
            wrong_parameters);
  EXPECT_EQ(rig.error_of(ping("1")), 0);
  EXPECT_THAT(rig.asked, IsEmpty());
}

TEST(Conversation, AnswersNoNotificationAndNoAnswer) {
  Rig rig;
  for (const std::string line :
       {R"({"jsonrpc":"2.0","method":"notifications/initialized"})", R"({"jsonrpc":"2.0","method":"tools/call"})",
        R"({"jsonrpc":"2.0","id":4,"result":{}})", R"({"jsonrpc":"2.0","id":4,"error":{"code":1,"message":""}})", "",
        " \r"}) {
    EXPECT_EQ(rig.conversation.answer({line}), "") << line;
  }
  EXPECT_THAT(rig.asked, IsEmpty());
}

TEST(Conversation, TakesBatchesInTheVersionThatHasThem) {
  Rig rig;
  const std::string batch =
      "[" + ping("1") + R"(,{"jsonrpc":"2.0","method":"notifications/initialized"},7,)" + ping("2") + "]";
  EXPECT_EQ(rig.error_of(batch), is_no_request);
  rig.initialize("2025-03-26");
  const auto answers = rig.say(batch).as_array();
  ASSERT_THAT(answers, SizeIs(3));
  EXPECT_EQ(answers.at(0).at("id"), 1);
  EXPECT_EQ(answers.at(1).at("error").at("code"), is_no_request);
  EXPECT_EQ(answers.at(2).at("id"), 2);
  EXPECT_EQ(rig.conversation.answer({R"([{"jsonrpc":"2.0","method":"notifications/initialized"}])"}), "");
  for (const std::size_t size : {max_batch_messages - 1, max_batch_messages, max_batch_messages + 1}) {
    std::string many;
    for (std::size_t at = 0; at < size; ++at) many += (many.empty() ? "" : ",") + ping("3");
    EXPECT_EQ(rig.say("[" + many + "]").is_array(), size <= max_batch_messages) << size;
  }
}

TEST(ReadLine, KeepsNoMoreOfALineThanIsAllowedAndFindsTheNext) {
  for (const std::size_t size : {max_message_octets - 1, max_message_octets, max_message_octets + 1}) {
    std::istringstream in(std::string(size, 'x') + "\nshort\nlast");
    const auto line = read_line(in);
    ASSERT_TRUE(line);
    EXPECT_EQ(line->is_cut, size > max_message_octets) << size;
    EXPECT_EQ(line->text.size(), std::min(size, max_message_octets));
    EXPECT_EQ(read_line(in)->text, "short");
    EXPECT_EQ(read_line(in)->text, "last");
    EXPECT_FALSE(read_line(in));
  }
  Rig rig;
  const std::string refusal = rig.conversation.answer({.text = "{", .is_cut = true});
  EXPECT_EQ(json::parse(refusal).at("error").at("code"), is_no_request);
}

}  // namespace
}  // namespace geminga::query::mcp
