#include "daemon/configuration/configuration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "daemon/configuration/configuration_file.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::daemon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Layer layer_of(const std::vector<std::pair<std::string, std::string>>& values, const std::string& origin = "--") {
  Layer layer;
  for (const auto& [key, text] : values) layer.values[key].push_back({text, origin == "--" ? "--" + key : origin});
  return layer;
}

std::expected<Configuration, std::vector<std::string>> resolved(const Layer& layer, const std::string& host = "host") {
  return resolve({&layer}, host);
}

TEST(Configuration, HasTheDefaultsOfTheContract) {
  const auto result = resolved({});
  ASSERT_TRUE(result);
  EXPECT_THAT(result->ontologies, IsEmpty());
  EXPECT_EQ(result->group, "default");
  EXPECT_EQ(result->name, "host");
  EXPECT_THAT(result->gcnp, ElementsAre(GcnpAddress{{"127.0.0.1", 4717}, false}, GcnpAddress{{"::1", 4717}, true}));
  EXPECT_EQ(result->air.port, 4717);
  EXPECT_THAT(result->air.groups, ElementsAre("239.192.47.17", "ff02::4717"));
  EXPECT_THAT(result->air.interfaces, IsEmpty());
  EXPECT_EQ(result->interval, std::chrono::seconds(2));
  EXPECT_EQ(result->log_level, base::LogLevel::info);
}

TEST(Configuration, ListensOnAPathBesideTcpOrInsteadOfIt) {
  const auto both = resolved(layer_of({{"gcnp-socket", "/run/geminga/gcnp"}}));
  ASSERT_TRUE(both);
  EXPECT_EQ(both->gcnp_socket, "/run/geminga/gcnp");
  EXPECT_EQ(both->gcnp.size(), 2U);
  const auto alone = resolved(layer_of({{"gcnp", "none"}, {"gcnp-socket", "/run/geminga/gcnp"}}));
  ASSERT_TRUE(alone);
  EXPECT_THAT(alone->gcnp, IsEmpty());
  EXPECT_THAT(to_toml(*alone), testing::AllOf(testing::HasSubstr("gcnp = [\"none\"]\n"),
                                              testing::HasSubstr("gcnp-socket = \"/run/geminga/gcnp\"\n")));
  EXPECT_FALSE(resolved(layer_of({{"gcnp", "none"}}))) << "nobody could reach it";
  EXPECT_FALSE(resolved(layer_of({{"gcnp", "none"}, {"gcnp", "127.0.0.1:1"}, {"gcnp-socket", "/a"}})));
}

TEST(Configuration, HasAPathOfASocketWithinItsLimit) {
  for (const auto& [length, is_good] : {std::pair(0U, false), {1U, true}, {106U, true}, {107U, true}, {108U, false}}) {
    EXPECT_EQ(resolved(layer_of({{"gcnp-socket", std::string(length, 'x')}})).has_value(), is_good) << length;
  }
}

TEST(Configuration, TakesTheStrongestLayerThatSaysAnything) {
  const Layer flags = layer_of({{"port", "1"}, {"interface", "a"}});
  const Layer environment = layer_of({{"port", "2"}, {"name", "b"}}, "GEMINGA");
  const Layer file =
      layer_of({{"port", "3"}, {"name", "c"}, {"interface", "d"}, {"interface", "e"}, {"group", "f"}}, "file");
  const auto result = resolve({&flags, &environment, &file}, "host");
  ASSERT_TRUE(result);
  EXPECT_EQ(result->air.port, 1);
  EXPECT_EQ(result->name, "b");
  EXPECT_EQ(result->group, "f");
  EXPECT_THAT(result->air.interfaces, ElementsAre("a")) << "a list replaces a list";
}

TEST(Configuration, GoesWithoutANameWhereTheHostHasNone) {
  for (const char* host : {"", "bad/name", "bad\xff"}) {
    const auto result = resolved({}, host);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->name, "");
  }
}

TEST(Configuration, RefusesAWrongValueWithItsPlace) {
  const std::vector<std::pair<std::pair<std::string, std::string>, std::string>> cases{
      {{"port", "0"}, "is no port"},
      {{"port", "65536"}, "is no port"},
      {{"port", "-1"}, "is no port"},
      {{"port", "4717x"}, "is no port"},
      {{"interval", "0.049"}, "is no interval"},
      {{"interval", "60.001"}, "is no interval"},
      {{"interval", "nan"}, "is no interval"},
      {{"interval", "1e1"}, "is no interval"},
      {{"interval", ""}, "is no interval"},
      {{"gcnp", "192.0.2.1:4717"}, "GCNP is local"},
      {{"gcnp", "4717"}, "is no ADDRESS:PORT"},
      {{"multicast", "192.0.2.1"}, "is no multicast group"},
      {{"multicast", "x"}, "is no IP address"},
      {{"peer", "239.1.1.1"}, "use --multicast"},
      {{"peer", "*"}, "whoever has the team's key"},
      {{"peer", "a b"}, "neither an IP address nor a host name"},
      {{"interface", ""}, "is no name of an interface"},
      {{"interface", "sixteen-octets-x"}, "is no name of an interface"},
      {{"name", ""}, "is no name"},
      {{"name", "a,b"}, "is no name"},
      {{"group", "a\nb"}, "is no name"},
      {{"ontology", ""}, "an empty path"},
      {{"log-level", "loud"}, "use debug, info, warning or error"},
      {{"log-format", "xml"}, "use text or json"},
      {{"key-file", ""}, "an empty path"},
      {{"sealing", "encrypted"}, "without a key: give --key-file"},
      {{"sealing", "secret"}, "'secret' is no mode"},
  };
  for (const auto& [value, words] : cases) {
    const auto result = resolved(layer_of({value}));
    ASSERT_FALSE(result) << value.first << " = " << value.second;
    EXPECT_THAT(result.error(),
                ElementsAre(testing::AllOf(testing::StartsWith("--" + value.first + ": "), HasSubstr(words))));
  }
}

TEST(Configuration, SealsWhereThereIsAKeyAndEncryptsUnlessTold) {
  EXPECT_EQ(resolved({})->sealing.mode, sealing::Mode::plain);
  EXPECT_EQ(resolved(layer_of({{"sealing", "plain"}}))->sealing.mode, sealing::Mode::plain);
  const auto encrypted = resolved(layer_of({{"key-file", "a"}, {"key-file", "b"}}));
  EXPECT_THAT(encrypted->key_files, ElementsAre("a", "b"));
  EXPECT_EQ(encrypted->sealing.mode, sealing::Mode::encrypted);
  const auto mixed = resolved(layer_of({{"key-file", "a"}, {"sealing", "mixed"}}));
  EXPECT_EQ(mixed->sealing.mode, sealing::Mode::mixed);
  EXPECT_THAT(to_toml(*mixed), testing::AllOf(HasSubstr("key-file = [\"a\"]\n"), HasSubstr("sealing = \"mixed\"\n")));
  EXPECT_THAT(resolved(layer_of({{"key-file", "a"}, {"sealing", "plain"}})).error(),
              ElementsAre(HasSubstr("plain with a key")));
}

TEST(Configuration, KnowsWhetherPlainIsSaidOrOnlyTheDefault) {
  EXPECT_FALSE(resolved(layer_of({}))->says_plain);
  EXPECT_THAT(to_toml(*resolved(layer_of({}))), HasSubstr("# sealing = \"plain\"\n"));
  const auto said = resolved(layer_of({{"sealing", "plain"}}));
  EXPECT_TRUE(said->says_plain);
  EXPECT_THAT(to_toml(*said), HasSubstr("\nsealing = \"plain\"\n"));
}

TEST(Configuration, WantsACageUnlessToldOtherwise) {
  EXPECT_EQ(resolved(layer_of({}))->cage, CageWish::wanted);
  for (const auto& [word, wish] : {std::pair("wanted", CageWish::wanted), std::pair("required", CageWish::required),
                                   std::pair("none", CageWish::none)}) {
    const auto configuration = resolved(layer_of({{"cage", word}}));
    EXPECT_EQ(configuration->cage, wish);
    EXPECT_THAT(to_toml(*configuration), HasSubstr("cage = \"" + std::string(word) + "\"\n"));
  }
  EXPECT_THAT(resolved(layer_of({{"cage", "gold"}})).error(), ElementsAre(HasSubstr("use wanted, required or none")));
}

TEST(Configuration, TakesIntervalsWithinTheRangeOfTheAnnouncement) {
  EXPECT_EQ(resolved(layer_of({{"interval", "0.05"}}))->interval, announcement::min_interval);
  EXPECT_EQ(resolved(layer_of({{"interval", "60"}}))->interval, announcement::max_interval);
  EXPECT_EQ(resolved(layer_of({{"interval", "0.125"}}))->interval, std::chrono::milliseconds(125));
}

TEST(Configuration, HasAMostOfEveryList) {
  const auto with = [](const std::string& key, std::size_t count, const std::function<std::string(std::size_t)>& text) {
    Layer layer;
    for (std::size_t number = 0; number < count; ++number) layer.values[key].push_back({text(number), "--" + key});
    return resolved(layer);
  };
  const auto gcnp = [](std::size_t number) { return "127.0.0.1:" + std::to_string(number + 1); };
  EXPECT_TRUE(with("gcnp", max_addresses - 1, gcnp));
  EXPECT_TRUE(with("gcnp", max_addresses, gcnp));
  EXPECT_FALSE(with("gcnp", max_addresses + 1, gcnp));
  const auto peer = [](std::size_t number) { return "robot" + std::to_string(number); };
  EXPECT_TRUE(with("peer", env::max_unicast_peers - 1, peer));
  EXPECT_TRUE(with("peer", env::max_unicast_peers, peer));
  EXPECT_FALSE(with("peer", env::max_unicast_peers + 1, peer));
  EXPECT_TRUE(with("ontology", max_values, peer));
  EXPECT_TRUE(with("key-file", sealing::max_keys - 1, peer));
  EXPECT_TRUE(with("key-file", sealing::max_keys, peer));
  EXPECT_FALSE(with("key-file", sealing::max_keys + 1, peer));
  EXPECT_FALSE(with("ontology", max_values + 1, peer));
}

TEST(Configuration, SaysEverythingThatIsWrongAtOnce) {
  EXPECT_THAT(resolved(layer_of({{"port", "x"}, {"interval", "y"}, {"log-level", "z"}})).error(), SizeIs(3));
}

TEST(Configuration, ReadsAddressesThatAreAnnounced) {
  const auto both = resolved(layer_of({{"announce-address", "192.0.2.7"}, {"announce-address", "eth0=2001:db8::7"}}));
  ASSERT_TRUE(both);
  const std::vector<env::AnnouncedAddress> wanted{{"", "192.0.2.7"}, {"eth0", "2001:db8::7"}};
  EXPECT_EQ(both->air.announced, wanted);
  EXPECT_THAT(to_toml(*both), testing::HasSubstr("announce-address = [\"192.0.2.7\", \"eth0=2001:db8::7\"]"));
  for (const char* wrong : {"", "robot2", "127.0.0.1", "::1", "0.0.0.0", "::", "239.1.2.3", "ff02::1", "=192.0.2.7",
                            "eth0=", "eth0=x", "an-interface-too-long=192.0.2.7", "192.0.2.7:80"})
    EXPECT_FALSE(resolved(layer_of({{"announce-address", wrong}}))) << wrong;
}

TEST(Configuration, TellsAndHearsOthersAloneOnlyWhereTheOwnerWishesIt) {
  EXPECT_FALSE(resolved({})->diagnoses);
  EXPECT_TRUE(resolved(layer_of({{"diagnose", "true"}}))->diagnoses);
  EXPECT_EQ(resolved({})->air.admission, env::Admission::nobody);
  EXPECT_EQ(resolved(layer_of({{"key-file", "/k"}}))->air.admission, env::Admission::sealed);
}

TEST(Configuration, AdmitsUnnamedPeersOnlyWhereAllIsSealedAndSomePeerIsNamed) {
  const auto admits = [](const std::vector<std::pair<std::string, std::string>>& values) {
    const auto result = resolved(layer_of(values));
    return result && result->air.admission == env::Admission::asked;
  };
  EXPECT_TRUE(admits({{"peer", "*"}, {"key-file", "/k"}}));
  EXPECT_TRUE(admits({{"peer", "robot2"}, {"key-file", "/k"}}));
  EXPECT_TRUE(admits({{"peer", "robot2"}, {"key-file", "/k"}, {"sealing", "authenticated"}}));
  EXPECT_FALSE(admits({{"peer", "robot2"}, {"key-file", "/k"}, {"sealing", "mixed"}}));
  EXPECT_FALSE(admits({{"peer", "robot2"}}));
  EXPECT_FALSE(admits({{"key-file", "/k"}}));
  EXPECT_FALSE(resolved(layer_of({{"peer", "*"}, {"key-file", "/k"}, {"sealing", "mixed"}})));
  EXPECT_THAT(to_toml(*resolved(layer_of({{"peer", "*"}, {"key-file", "/k"}}))), testing::HasSubstr("peer = [\"*\"]"));
}

TEST(Configuration, PrintedAsTomlConfiguresTheSame) {
  const Layer layer = layer_of({{"port", "4000"},
                                {"interval", "0.125"},
                                {"name", "r\"2\\ \xc3\xa4"},
                                {"group", "blue"},
                                {"gcnp", "127.0.0.1:1"},
                                {"gcnp", "[::1]:2"},
                                {"multicast", "239.1.2.3"},
                                {"peer", "robot3"},
                                {"peer", "[fd00::1]:9"},
                                {"interface", "wlan0"},
                                {"ontology", "/a b/c.ttl"},
                                {"strict", "true"},
                                {"log-level", "warning"},
                                {"log-format", "json"}});
  const auto result = resolved(layer);
  ASSERT_TRUE(result) << result.error()[0];
  const auto file = read_configuration_text(to_toml(*result), "/printed.toml");
  ASSERT_TRUE(file) << file.error()[0];
  EXPECT_EQ(resolve({&*file}, "other"), result);
}

TEST(Configuration, IsStrictWhereItIsTold) {
  EXPECT_FALSE(resolved({})->is_strict);
  EXPECT_TRUE(resolved(layer_of({{"strict", "true"}}))->is_strict);
  EXPECT_FALSE(resolved(layer_of({{"strict", "false"}}))->is_strict);
  EXPECT_THAT(resolved(layer_of({{"strict", "yes"}})).error(),
              ElementsAre("--strict: 'yes' is no truth value: use true or false"));
  const auto file = read_configuration_text("strict = true\n", "f.toml");
  ASSERT_TRUE(file);
  EXPECT_TRUE(resolve({&*file}, "host")->is_strict);
}

TEST(Configuration, PrintedForATerminalIsHarmlessAndMeansTheSame) {
  const auto result = resolved(layer_of({{"ontology", "/a\u009b31m\u202e.ttl"}}));
  ASSERT_TRUE(result);
  EXPECT_THAT(to_toml(*result), HasSubstr("ontology = [\"/a\\u009b31m\\u202e.ttl\"]"));
  const auto file = read_configuration_text(to_toml(*result), "/f.toml");
  ASSERT_TRUE(file);
  EXPECT_EQ(resolve({&*file}, "host")->ontologies, result->ontologies);
}

TEST(ConfigurationFile, IsReadWithItsPlaces) {
  const auto layer = read_configuration_text(
      "# a team\nport = 4000\nontology = [\"a.ttl\",\n  \"/b.ttl\"]\ninterval = 0.5\n", "/etc/geminga.toml");
  ASSERT_TRUE(layer);
  EXPECT_EQ(layer->values.at("port")[0].text, "4000");
  EXPECT_EQ(layer->values.at("port")[0].origin, "/etc/geminga.toml:2");
  ASSERT_THAT(layer->values.at("ontology"), SizeIs(2));
  EXPECT_EQ(layer->values.at("ontology")[0].text, "/etc/a.ttl") << "relative to the file";
  EXPECT_EQ(layer->values.at("ontology")[1].text, "/b.ttl");
  EXPECT_EQ(layer->values.at("ontology")[1].origin, "/etc/geminga.toml:4");
  EXPECT_EQ(layer->values.at("interval")[0].text, "0.5");
}

TEST(ConfigurationFile, IsRefusedWithFileAndLine) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"port = \"4717\"", "f.toml:1: port must be a whole number"},
      {"port = 1.5", "f.toml:1: port must be a whole number"},
      {"\nport = true", "f.toml:2: port must be a whole number"},
      {"port = [1]", "f.toml:1: port must be a whole number"},
      {"strict = \"true\"", "f.toml:1: strict must be true or false"},
      {"strict = 1", "f.toml:1: strict must be true or false"},
      {"interval = \"2\"", "f.toml:1: interval must be a number of seconds"},
      {"name = 7", "f.toml:1: name must be a text in quotes"},
      {"name = [\"a\"]", "f.toml:1: name must be a text in quotes"},
      {"ontology = [\"a\", 7]", "f.toml:1: ontology must be a text in quotes, or several"},
      {"colour = 1", "f.toml:1: unknown key 'colour'"},
      {"config = \"x\"", "f.toml:1: unknown key 'config'"},
      {"intervall = 2", "f.toml:1: unknown key 'intervall': did you mean 'interval'? the keys are"},
      {"[port]\nx = 1", "f.toml:1: port must be a whole number"},
      {"port = 1\nport = 2", "f.toml:2: "},
      {"port = \n", "f.toml:1: "},
      {"name = \"\xff\"", "f.toml:1: "},
      {"prefixes = 1", "f.toml:1: prefixes must be a table"},
      {"[prefixes]\nzoo = 1", "f.toml:2: a prefix must be an IRI in quotes"},
  };
  for (const auto& [text, words] : cases) {
    const auto layer = read_configuration_text(text, "f.toml");
    ASSERT_FALSE(layer) << text;
    EXPECT_THAT(layer.error(), ElementsAre(testing::StartsWith(words)));
  }
}

TEST(ConfigurationFile, NamesPrefixes) {
  const auto file = read_configuration_text("[prefixes]\nzoo = \"http://zoo.example/#\"\n", "f.toml");
  ASSERT_TRUE(file);
  const auto result = resolve({&*file}, "host");
  ASSERT_TRUE(result);
  EXPECT_THAT(result->prefixes, ElementsAre(testing::Pair("zoo", "http://zoo.example/#")));
  EXPECT_THAT(to_toml(*result), HasSubstr("\n[prefixes]\nzoo = \"http://zoo.example/#\"\n"));
  for (const char* wrong : {"\"a b\" = \"http://x/\"", "\"1\" = \"http://x/\"", "a = \"http://x/>\"", "a = \"no iri\"",
                            "a = \"relative\"", "a = \"http://x/\\n\""}) {
    const auto read = read_configuration_text("[prefixes]\n" + std::string(wrong), "f.toml");
    ASSERT_TRUE(read) << wrong;
    EXPECT_THAT(resolve({&*read}, "host").error(), ElementsAre(testing::StartsWith("f.toml:2: "))) << wrong;
  }
}

/// A folder with files of configuration, removed at the end.
class ConfigurationFolder : public testing::Test {
 protected:
  ConfigurationFolder() {
    std::string pattern = testing::TempDir() + "configuration-XXXXXX";
    folder = ::mkdtemp(pattern.data());
  }
  ~ConfigurationFolder() override { std::filesystem::remove_all(folder); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder + '/' + name) << text; }
  [[nodiscard]] auto read() const { return read_configuration_files({{folder, "--config"}}); }

  std::string folder;
};

TEST_F(ConfigurationFolder, IsReadInTheOrderOfNamesAndALaterFileBeatsAnEarlierOne) {
  write("10-first.toml", "group = \"red\"\nname = \"a\"\ninterface = [\"x\", \"y\"]\n[prefixes]\np = \"http://p/\"\n");
  write("9-later.toml", "group = \"blue\"\ninterface = [\"z\"]\n[prefixes]\nq = \"http://q/\"\n");
  write("ignored.txt", "group = 1");
  write(".hidden.toml", "group = 2");
  const auto layer = read();
  ASSERT_TRUE(layer) << layer.error().front();
  EXPECT_EQ(layer->values.at("group").front().text, "blue");
  EXPECT_EQ(layer->values.at("group").front().origin, folder + "/9-later.toml:1");
  EXPECT_EQ(layer->values.at("name").front().text, "a");
  EXPECT_EQ(layer->values.at("interface").size(), 1U) << "a list replaces a whole list";
  EXPECT_EQ(layer->prefixes.size(), 2U);
}

TEST_F(ConfigurationFolder, FailsWithThePlaceOfWhatIsWrong) {
  write("a.toml", "group = \"red\"\n");
  write("b.toml", "\ngroup = 1\n");
  EXPECT_THAT(read().error(), ElementsAre(testing::StartsWith(folder + "/b.toml:2: group must be")));
  EXPECT_THAT(read_configuration_files({{"", "GEMINGA_CONFIG"}}).error(),
              ElementsAre("GEMINGA_CONFIG: an empty path: name a file or a folder"));
}

TEST_F(ConfigurationFolder, HoldsNoMoreFilesThanTheLimit) {
  for (std::size_t file = 0; file + 1 < max_configuration_files; ++file) write(std::to_string(file) + ".toml", "");
  EXPECT_TRUE(read());
  write("at-the-limit.toml", "");
  EXPECT_TRUE(read());
  write("one-more.toml", "");
  EXPECT_THAT(read().error(), ElementsAre(testing::HasSubstr("more than 64 files")));
}

TEST(ConfigurationFile, IsNoFolderAndNoHole) {
  EXPECT_THAT(read_configuration_file("/").error(), ElementsAre(testing::StartsWith("/: ")));
  EXPECT_THAT(read_configuration_file("/no/such/file").error(),
              ElementsAre("/no/such/file: No such file or directory"));
}

TEST(Environment, IsReadByTheNamesOfTheFlags) {
  const char* const variables[] = {"GEMINGA_PORT=4000",
                                   "GEMINGA_ONTOLOGY=a.ttl,b.ttl",
                                   "GEMINGA_LOG_LEVEL=debug",
                                   "GEMINGA_NAME=",
                                   "GEMINGA_PORTABLE=1",
                                   "GEMINGA_CONNECT=x",
                                   "GEMINGA_INTERFACE=a,,b",
                                   "HOME=/root",
                                   nullptr};
  const Layer layer = read_environment(variables);
  EXPECT_THAT(layer.values, SizeIs(4));
  EXPECT_EQ(layer.values.at("port")[0].text, "4000");
  EXPECT_EQ(layer.values.at("port")[0].origin, "GEMINGA_PORT");
  EXPECT_THAT(layer.values.at("ontology"), SizeIs(2));
  EXPECT_THAT(layer.values.at("interface"), SizeIs(2));
  EXPECT_EQ(layer.values.at("log-level")[0].text, "debug");
  EXPECT_THAT(mistyped_variables(variables), IsEmpty());
}

TEST(Environment, NamesTheVariableThatMayBeMeant) {
  const char* const variables[] = {
      "GEMINGA_INTERVL=1",   "GEMINGA_LOGLEVEL=debug", "GEMINGA_INTERVAL=2", "GEMINGA_SEED=7",  "GEMINGA_CONNECT=x:1",
      "GEMINGA_TEST_DATA=/", "GEMINGA_COLOUR=red",     "INTERVL=1",          "GEMINGA_ONTOLGY", nullptr};
  EXPECT_THAT(mistyped_variables(variables), ElementsAre("GEMINGA_INTERVL: unknown: did you mean GEMINGA_INTERVAL?",
                                                         "GEMINGA_LOGLEVEL: unknown: did you mean GEMINGA_LOG_LEVEL?",
                                                         "GEMINGA_ONTOLGY: unknown: did you mean GEMINGA_ONTOLOGY?"));
}

}  // namespace
}  // namespace geminga::daemon
