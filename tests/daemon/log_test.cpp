#include "daemon/log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/parse.hpp>

namespace geminga::daemon {
namespace {

using base::LogLevel;
using testing::HasSubstr;
using testing::Not;

TEST(Log, WritesOneLineOfText) {
  testing::internal::CaptureStderr();
  Log log(LogLevel::info, LogFormat::text);
  log.write(LogLevel::warning, "robot2\nhas two lines {} %v");
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, testing::EndsWith(" warning robot2?has two lines {} %v\n"));
}

TEST(Log, WritesOneJsonObjectALine) {
  testing::internal::CaptureStderr();
  Log log(LogLevel::info, LogFormat::json);
  const std::string line = "a \"quoted\" \\ name, \xc3\xa4 and \xff, {} %v";
  log.write(LogLevel::error, line);
  const std::string said = testing::internal::GetCapturedStderr();
  const auto object = boost::json::parse(said).as_object();
  EXPECT_EQ(object.at("level"), "error");
  EXPECT_EQ(object.at("text"), "a \"quoted\" \\ name, \xc3\xa4 and \xef\xbf\xbd, {} %v");
  EXPECT_THAT(std::string(object.at("time").as_string()), testing::MatchesRegex(".*T.*[+-].*"));
}

TEST(Log, DropsWhatIsLessSevereThanItsLevel) {
  testing::internal::CaptureStderr();
  Log log(LogLevel::warning, LogFormat::text);
  log.write(LogLevel::info, "not this");
  log.write(LogLevel::warning, "but this");
  log.set(LogLevel::debug, LogFormat::text);
  log.write(LogLevel::debug, "and now this");
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, Not(HasSubstr("not this")));
  EXPECT_THAT(said, HasSubstr("but this"));
  EXPECT_THAT(said, HasSubstr("and now this"));
}

}  // namespace
}  // namespace geminga::daemon
