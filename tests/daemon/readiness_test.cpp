#include "daemon/readiness.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "base/log.hpp"
#include "supervising.hpp"

namespace geminga::daemon {
namespace {

class KeptLines final : public base::LogSink {
 public:
  void write(base::LogLevel /*level*/, std::string_view line, const base::LogFields& /*fields*/) override {
    lines.emplace_back(line);
  }
  std::vector<std::string> lines;
};

class ReadinessTest : public testing::Test {
 protected:
  Listener systemd_;
  Supervisor supervisor_ = supervised_by({"NOTIFY_SOCKET=" + systemd_.path()});
  KeptLines log_;
  int asked_ = 0;
  Readiness readiness_{supervisor_, log_, [this] { return "ready: " + std::to_string(++asked_); }};
};

TEST_F(ReadinessTest, IsToldOnceAfterTheStart) {
  readiness_.update(false, false);
  EXPECT_EQ(systemd_.next(), "");
  readiness_.update(true, true);
  EXPECT_EQ(systemd_.next(), "READY=1\nSTATUS=ready: 1\n") << "without waiting for the ontology";
  readiness_.update(true, false);
  readiness_.update(false, false);
  readiness_.update(true, false);
  EXPECT_EQ(systemd_.next(), "");
  EXPECT_THAT(log_.lines, testing::ElementsAre("ready: 1"));
}

TEST_F(ReadinessTest, TellsTheSupervisorAndNotTheLogThatAReloadIsOver) {
  readiness_.update(true, false);
  ASSERT_NE(systemd_.next(), "");
  readiness_.begin_reload(base::Instant(std::chrono::microseconds(5)));
  EXPECT_EQ(systemd_.next(), "RELOADING=1\nMONOTONIC_USEC=5\n");
  readiness_.update(true, true);
  EXPECT_EQ(systemd_.next(), "") << "while the ontology is being loaded";
  readiness_.update(true, false);
  EXPECT_EQ(systemd_.next(), "READY=1\nSTATUS=ready: 2\n");
  readiness_.update(true, false);
  EXPECT_EQ(systemd_.next(), "");
  EXPECT_THAT(log_.lines, testing::ElementsAre("ready: 1"));
}

TEST_F(ReadinessTest, EndsAReloadOfTheStartWhenTheStartIsOver) {
  readiness_.begin_reload(base::Instant(std::chrono::microseconds(5)));
  ASSERT_NE(systemd_.next(), "");
  readiness_.update(false, false);
  EXPECT_EQ(systemd_.next(), "");
  readiness_.update(true, false);
  EXPECT_EQ(systemd_.next(), "READY=1\nSTATUS=ready: 1\n");
  EXPECT_EQ(systemd_.next(), "");
}

}  // namespace
}  // namespace geminga::daemon
