// Reloads: settings that change at once, settings that await the next start, and errors.
#include "daemon/configuration/configuration_in_force.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geminga::daemon {
namespace {

/// A configuration in force, beside the configuration that the next reload() reads.
class InForce {
 public:
  [[nodiscard]] ConfigurationChange reload() {
    const auto change = in_force_.reload();
    EXPECT_TRUE(change);
    return change.value_or(ConfigurationChange{});
  }
  [[nodiscard]] const Configuration& current() const { return in_force_.current(); }

  Configuration file = started();

 private:
  static Configuration started() {
    Configuration configuration;
    configuration.name = "robot2";
    configuration.gcnp = {{{"127.0.0.1", 4717}, false}};
    return configuration;
  }

  ConfigurationInForce in_force_{started(), [this] { return file; }};
};

TEST(ConfigurationInForce, AwaitsAStartUntilTheSettingIsBackAsItWas) {
  const std::vector<std::pair<const char*, void (*)(Configuration&)>> changes{
      {"name", [](Configuration& file) { file.name = "robot3"; }},
      {"group", [](Configuration& file) { file.group = "red"; }},
      {"gcnp", [](Configuration& file) { file.gcnp.push_back({{"127.0.0.1", 4718}, false}); }},
      {"gcnp-socket", [](Configuration& file) { file.gcnp_socket = "/run/geminga/gcnp"; }},
      {"interval", [](Configuration& file) { file.interval = std::chrono::seconds(3); }},
      {"cage", [](Configuration& file) { file.cage = CageWish::required; }},
      {"state-folder", [](Configuration& file) { file.state_folder = "/var/lib/geminga"; }},
  };
  for (const auto& [setting, change] : changes) {
    InForce in_force;
    const Configuration started = in_force.file;
    EXPECT_FALSE(in_force.reload().awaits_a_start) << setting;
    change(in_force.file);
    EXPECT_TRUE(in_force.reload().awaits_a_start) << setting;
    EXPECT_TRUE(in_force.reload().awaits_a_start) << setting << ": it still differs from what is in force";
    EXPECT_EQ(in_force.current(), started) << setting << ": what is in force stays";
    in_force.file = started;
    EXPECT_FALSE(in_force.reload().awaits_a_start) << setting << ": it is what is in force";
  }
}

TEST(ConfigurationInForce, ChangesAllOtherSettingsAtOnceAndTellsOfThemOnce) {
  InForce in_force;
  in_force.file.air.interfaces = {"wlan0"};
  in_force.file.sealing.mode = sealing::Mode::encrypted;
  in_force.file.ontologies = {"team.ttl"};
  in_force.file.prefixes = {{"ours", "https://team.example/#"}};
  in_force.file.log_level = base::LogLevel::debug;
  in_force.file.log_format = LogFormat::json;
  const ConfigurationChange change = in_force.reload();
  EXPECT_TRUE(change.air);
  EXPECT_TRUE(change.sealing);
  EXPECT_FALSE(change.awaits_a_start);
  EXPECT_EQ(in_force.current(), in_force.file);
  const ConfigurationChange again = in_force.reload();
  EXPECT_FALSE(again.air || again.sealing || again.awaits_a_start);
}

TEST(ConfigurationInForce, IsNotPlainOnlyBecauseNoKeyIsNamedAnyMore) {
  Configuration sealed;
  sealed.key_files = {"team.key"};
  sealed.sealing.mode = sealing::Mode::encrypted;
  Configuration file;
  ConfigurationInForce in_force(sealed, [&] { return file; });
  const auto refused = in_force.reload();
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error(), testing::ElementsAre(testing::HasSubstr("say sealing = \"plain\"")));
  EXPECT_EQ(in_force.failure(), refused.error().front());
  EXPECT_EQ(in_force.current(), sealed);
  file.says_plain = true;
  const auto change = in_force.reload();
  ASSERT_TRUE(change);
  EXPECT_TRUE(change->sealing);
  EXPECT_EQ(in_force.failure(), "");
  file.says_plain = false;
  EXPECT_TRUE(in_force.reload()) << "it is plain already";
}

TEST(ConfigurationInForce, StaysWhereTheNewOneHasErrorsAndNamesTheFirst) {
  std::vector<std::string> errors{"geminga.toml:1: unknown key", "geminga.toml:2: no level"};
  Configuration started;
  started.name = "robot2";
  ConfigurationInForce in_force(started, [&]() -> std::expected<Configuration, std::vector<std::string>> {
    if (errors.empty()) return started;
    return std::unexpected(errors);
  });
  EXPECT_EQ(in_force.failure(), "");
  const auto failed = in_force.reload();
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error(), errors);
  EXPECT_EQ(in_force.failure(), errors.front());
  EXPECT_EQ(in_force.current(), started);
  errors.clear();
  EXPECT_TRUE(in_force.reload());
  EXPECT_EQ(in_force.failure(), "");
}

}  // namespace
}  // namespace geminga::daemon
