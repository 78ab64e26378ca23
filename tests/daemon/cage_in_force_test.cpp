// The freedom that a daemon keeps for what its configuration names.
#include "daemon/cage_in_force.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace geminga::daemon {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

TEST(CageInForce, LeavesFoldersForCopiesAndNoneToRemoveFrom) {
  ASSERT_EQ(::setenv("TMPDIR", "/srv/tmp", 1), 0);
  const cage::Freedom freedom = freedom_to_serve({});
  ::unsetenv("TMPDIR");
  EXPECT_THAT(freedom.rewritable, ElementsAre("/dev/null", "/srv/tmp", "/var/tmp", "/tmp"));
  EXPECT_THAT(freedom.removable_folders, IsEmpty());
  EXPECT_THAT(freedom.writable_folders, IsEmpty());
  EXPECT_TRUE(freedom.may_serve);
  EXPECT_TRUE(freedom.may_read_all) << "a reload may name any file";
  EXPECT_FALSE(freedom.may_become);
}

TEST(CageInForce, LeavesTheFolderOfACompiledOntologyAndThatOfItsSocket) {
  Configuration configuration;
  configuration.ontologies = {"/srv/team/robots.geminga", "/srv/other/robots.ttl"};
  configuration.gcnp_socket = "/run/geminga/gcnp";
  configuration.state_folder = "/var/lib/geminga";
  const cage::Freedom freedom = freedom_to_serve(configuration);
  EXPECT_THAT(freedom.rewritable, Contains("/srv/team"));
  EXPECT_THAT(freedom.rewritable, Not(Contains("/srv/other")));
  EXPECT_THAT(freedom.rewritable, Not(Contains("/var/lib/geminga"))) << "it is written before the cage is closed";
  EXPECT_THAT(freedom.removable_folders, ElementsAre("/run/geminga"));
  configuration.gcnp_socket = "gcnp";
  EXPECT_THAT(freedom_to_serve(configuration).removable_folders, ElementsAre("."));
}

TEST(CageInForce, RefusesFilesAndCallsThatServingDoesNotNeed) {
  std::string folder = std::filesystem::temp_directory_path() / "geminga-cage-XXXXXX";
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  std::ofstream(folder + "/identity") << "identity 00000001\n";
  std::ofstream(folder + "/team.key") << "x";
  const pid_t child = ::fork();
  if (child == 0) {
    Log log(base::LogLevel::error, LogFormat::text);
    CageInForce cage;
    if (!cage.close({}, log)) ::_exit(1);
    const std::string held = cage.words();
    if (!held.contains("calls")) ::_exit(200);
    if (::open((folder + "/team.key").c_str(), O_RDONLY) < 0) ::_exit(2);
    if (::open((folder + "/identity.new").c_str(), O_WRONLY | O_CREAT, 0600) >= 0 || errno != EACCES) ::_exit(3);
    if (::unlink((folder + "/identity").c_str()) == 0 || errno != EACCES) ::_exit(4);
    if (held.contains("files") && (::open("/etc/hosts", O_WRONLY) >= 0 || errno != EACCES)) ::_exit(5);
    if (::socket(AF_PACKET, SOCK_RAW, 0) >= 0 || errno != EACCES) ::_exit(6);
    if (::chmod((folder + "/team.key").c_str(), 0666) == 0 || errno != EACCES) ::_exit(7);
    if (::socket(AF_INET, SOCK_DGRAM, 0) < 0) ::_exit(8);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == 200) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(WEXITSTATUS(status), 0) << "the number of the deed that ended otherwise";
}

TEST(CageInForce, HoldsNothingUntilItIsClosed) { EXPECT_EQ(CageInForce().words(), "none"); }

}  // namespace
}  // namespace geminga::daemon
