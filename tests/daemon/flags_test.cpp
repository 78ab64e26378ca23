#include "daemon/configuration/flags.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace geminga::daemon {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

std::expected<Flags, std::string> read(std::vector<const char*> words) {
  words.insert(words.begin(), "gemingad");
  return read_flags(static_cast<int>(words.size()), words.data());
}

TEST(Flags, OfListsMayBeRepeatedAndTakeOneValueEach) {
  const auto flags =
      read({"--interface", "a", "--interface", "b", "--ontology=x.ttl", "--port", "7", "--check-config"});
  ASSERT_TRUE(flags) << flags.error();
  ASSERT_THAT(flags->layer.values.at("interface"), SizeIs(2));
  EXPECT_EQ(flags->layer.values.at("interface")[1].text, "b");
  EXPECT_EQ(flags->layer.values.at("ontology")[0].origin, "--ontology");
  EXPECT_TRUE(flags->is_check_only);
  EXPECT_FALSE(read({"--interface", "a", "b"})) << "b belongs to nothing";
}

TEST(Flags, OfSingleValuesMayNot) {
  const auto flags = read({"--port", "1", "--port", "2"});
  ASSERT_FALSE(flags);
  EXPECT_THAT(flags.error(), HasSubstr("--port"));
}

TEST(Flags, ThatAreUnknownOrWithoutValueAreRefused) {
  for (const char* flag : {"--colour", "-x", "word", "--por", "--port"}) {
    const auto flags = read({flag});
    ASSERT_FALSE(flags) << flag;
    EXPECT_THAT(flags.error(), HasSubstr("see gemingad --help"));
  }
}

TEST(Flags, ThatAreMistypedNameTheOneThatMayBeMeant) {
  EXPECT_EQ(read({"--ontolgy", "a.ttl"}).error(),
            "'--ontolgy' is no flag: did you mean --ontology? see gemingad --help");
  EXPECT_EQ(read({"--intervall=2"}).error(), "'--intervall' is no flag: did you mean --interval? see gemingad --help");
  EXPECT_EQ(read({"--generate-keys", "x"}).error(),
            "'--generate-keys' is no flag: did you mean --generate-key? see gemingad --help");
  EXPECT_EQ(read({"--colour"}).error(), "'--colour' is no flag: see gemingad --help");
}

TEST(Flags, OfTruthMayStandAlone) {
  EXPECT_EQ(read({"--strict"})->layer.values.at("strict")[0].text, "true");
  EXPECT_EQ(read({"--strict=true"})->layer.values.at("strict")[0].text, "true");
  EXPECT_EQ(read({"--strict=false"})->layer.values.at("strict")[0].text, "false");
  EXPECT_FALSE(read({"--strict=perhaps"}));
  EXPECT_FALSE(read({"--port", "1"})->layer.values.contains("strict"));
}

TEST(Flags, HaveAHelpWithExamples) {
  const auto flags = read({"--help"});
  ASSERT_TRUE(flags);
  for (const Key& key : keys) EXPECT_THAT(flags->answer, HasSubstr("--" + std::string(key.name) + ' '));
  EXPECT_THAT(flags->answer, HasSubstr("Examples:"));
}

TEST(Flags, TellTheVersionAndThoseOfProtocolsAndFiles) {
  EXPECT_THAT(read({"--version"})->answer,
              testing::MatchesRegex(
                  "gemingad [0-9.]+ .announcements [0-9]+, seals [0-9]+, GCNP [0-9]+, compiled ontologies [0-9]+.\n"));
}

TEST(Flags, StandInThePackagedFileAndInTheSpecification) {
  const auto text_of = [](const char* file) {
    std::ifstream in(std::string(GEMINGA_SOURCE_DIR) + file);
    return '\n' + std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string packaged = text_of("/tools/packaging/gemingad.toml");
  const std::string specified = text_of("/src/daemon/CONFIGURATION.md");
  for (const Key& key : keys) {
    const std::string name(key.name);
    if (name == "config") continue;  // it names such a file
    EXPECT_THAT(specified, HasSubstr("| `" + name)) << name;
    EXPECT_TRUE(packaged.contains("\n" + name + " = ") || packaged.contains("\n# " + name + " = ")) << name;
  }
}

}  // namespace
}  // namespace geminga::daemon
