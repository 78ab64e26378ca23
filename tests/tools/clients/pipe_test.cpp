// A channel as standard input and output.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tools/clients/bench.hpp"

namespace geminga::tools {
namespace {

/// Runs this by a shell; `$publish` and `$subscribe` are the programs.
Outcome shell(const Bench& bench, const std::string& script) {
  return bench.run("/bin/bash", {"-c", "publish=" + system::program("geminga-publish") +
                                           " subscribe=" + system::program("geminga-subscribe") + "; " + script});
}

TEST(Pipe, CarriesEachLineAsOneMessageInEveryMode) {
  const Bench bench;
  for (const std::string mode : {"oto", "otm/pubsub", "otm/stream"}) {
    const std::string service = " --text " + mode + " --mode " + mode;
    const std::string udp = " --text " + mode + "-udp --mode " + mode;
    const auto outcome =
        shell(bench, "printf 'one\\ntwo words\\n\\nlast' | $publish" + service +
                         " --protocol tcp --send & publisher=$!; $subscribe" + service +
                         " --listen --count 4 --timeout 100; status=$?; wait $publisher && exit $status");
    EXPECT_EQ(outcome.status, 0) << mode << outcome.errors;
    EXPECT_EQ(outcome.out, "one\ntwo words\n\nlast\n") << mode << outcome.errors;
    EXPECT_THAT(outcome.errors, testing::HasSubstr("geminga-publish@")) << mode;
    const auto datagrams =
        shell(bench, "yes ball | $publish" + udp + " --send & publisher=$!; $subscribe" + udp +
                         " --listen --count 3 --timeout 100; status=$?; kill $publisher; exit $status");
    EXPECT_EQ(datagrams.status, 0) << mode << datagrams.errors;
    EXPECT_EQ(datagrams.out, "ball\nball\nball\n") << mode << datagrams.errors;
  }
}

TEST(Pipe, ShowsATerminalNothingThatItObeys) {
  const Bench bench;
  const std::string service = " --text calls --mode oto";
  const auto outcome = shell(
      bench,
      "printf 'red \\033[31m, turned \\342\\200\\256\\n' | $publish" + service +
          " --protocol tcp --send & publisher=$!; script -qec \"$subscribe" + service +
          " --listen --count 1 --timeout 100\" /dev/null < /dev/null; status=$?; wait $publisher && exit $status");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.out, testing::HasSubstr("red \ufffd[31m, turned \ufffd"));
}

TEST(Pipe, CarriesAFileWithoutLossOverTcp) {
  const Bench bench;
  const auto outcome =
      shell(bench,
            "numbers=$(mktemp); seq 20000 > $numbers; "
            "$publish --text numbers --mode oto --protocol tcp --send < $numbers & publisher=$!; "
            "$subscribe --text numbers --mode oto --listen --count 20000 --timeout 100 | cmp - $numbers; "
            "status=$?; wait $publisher; status=$((status | $?)); rm $numbers; exit $status");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
}

TEST(Pipe, LeavesOutALineThatNoDatagramHolds) {
  const Bench bench;
  const auto outcome =
      shell(bench,
            "(echo one; head -c 70000 /dev/zero | tr '\\0' x; echo; echo two) | $publish --text long --mode "
            "oto --send & publisher=$!; $subscribe --text long --mode oto --listen --count 2 --timeout 100; "
            "wait $publisher");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "one\ntwo\n") << outcome.errors;
  EXPECT_THAT(outcome.errors, testing::HasSubstr("a line of 70000 octets is left out"));
  EXPECT_THAT(outcome.errors, testing::Not(testing::HasSubstr("closed the connection")));
}

TEST(Pipe, SaysWhatIsWrong) {
  const Bench bench;
  EXPECT_EQ(shell(bench, "$subscribe ''").status, 2) << "an unset variable is no number 0";
  EXPECT_EQ(shell(bench, "$subscribe concept=").status, 2);
  EXPECT_EQ(shell(bench, "$subscribe --text x --listen --protocol carrier").status, 2);
  EXPECT_EQ(shell(bench, "$subscribe --text x --listen --convert yes").status, 2) << "it has no functions";
  EXPECT_EQ(shell(bench, "$publish --text x --mode oto --port 5000 --converts soccer:A").status, 2);
  EXPECT_EQ(shell(bench, "$publish --text x --mode oto --port 5000 --converts ''").status, 2);
  EXPECT_EQ(shell(bench, "$publish --text x --mode oto --port 5000 converts=soccer:A").status, 2);
  EXPECT_EQ(shell(bench, "$publish soccer:BallInfo --mode oto").status, 2) << "no port, and nothing is sent";
  EXPECT_EQ(shell(bench, "$subscribe --text x --listen --json").status, 2) << "messages are no events";
  EXPECT_EQ(shell(bench, "$publish --text x --send --timestamps < /dev/null").status, 2);
  EXPECT_EQ(shell(bench, "$publish soccer:NoBall --mode oto --send < /dev/null").status, 2);
  EXPECT_EQ(shell(bench, "$subscribe --text nobody --mode oto --listen --timeout 0.2").status, 4);
  EXPECT_EQ(shell(bench, "$subscribe --text x --listen --connect " + nobody()).status, 3);
  EXPECT_EQ(
      shell(
          bench,
          "head -c 70000 /dev/zero | tr '\\0' x | $publish --text big --mode oto --send & publisher=$!; $subscribe "
          "--text big --mode oto --listen & subscriber=$!; wait $publisher; status=$?; kill $subscriber; exit $status")
          .status,
      2)
      << "more than a datagram holds";
}

}  // namespace
}  // namespace geminga::tools
