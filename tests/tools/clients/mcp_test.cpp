// geminga-query mcp on standard input and output, with a real daemon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tools/clients/query.hpp"

namespace geminga::tools {
namespace {

TEST_F(Query, AnswersAnAssistantWithTheDocumentsOfJson) {
  const std::string call = R"({"jsonrpc":"2.0","id":%s,"method":"tools/call","params":{"name":"%s","arguments":%s}}\n)";
  const auto talk = bench_.run(
      "/bin/bash", {"-c", "{ printf '" + call +
                              "' 1 explain '{\"sub\":\"soccer:SharedBallInfo\",\"super\":\"soccer:TrackedObject\"}'; "
                              "echo rubbish; printf '" +
                              call + "' 2 match '{\"concept\":\"soccer:Nothing\"}'; printf '" + call +
                              "' 3 status '{}'; } | " + system::program("geminga-query") + " mcp"});
  EXPECT_EQ(talk.status, 0) << talk.errors;
  std::istringstream lines(talk.out);
  std::vector<boost::json::value> answers;
  for (std::string line; std::getline(lines, line);) answers.push_back(parsed(line));
  ASSERT_THAT(answers, testing::SizeIs(4));
  const std::string explained(answers.at(0).at("result").at("content").at(0).at("text").as_string());
  EXPECT_EQ(parsed(explained), bench_.json({"explain", "soccer:SharedBallInfo", "soccer:TrackedObject"}));
  EXPECT_EQ(answers.at(1).at("error").at("code"), -32700);
  EXPECT_EQ(answers.at(2).at("result").at("isError"), true);
  EXPECT_EQ(answers.at(3).at("id"), 3);
}

}  // namespace
}  // namespace geminga::tools
