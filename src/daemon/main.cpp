// gemingad: reads its configuration, then hands over to Daemon.
#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/system/system_error.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>

#include "base/harmless.hpp"
#include "daemon/configuration/configuration.hpp"
#include "daemon/configuration/configuration_file.hpp"
#include "daemon/configuration/flags.hpp"
#include "daemon/configuration/key_files.hpp"
#include "daemon/configuration/layer.hpp"
#include "daemon/daemon.hpp"
#include "daemon/log/log.hpp"
#include "daemon/memory/process_limits.hpp"
#include "daemon/supervisor/supervisor.hpp"

namespace {

using geminga::daemon::Configuration;
using geminga::daemon::Layer;
using Errors = std::vector<std::string>;

std::string host_name() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "";
  return name.data();
}

/// Puts flags over environment over files over the service's state folder, and reads the key files.
std::expected<Configuration, Errors> configure(const Layer& flags, const Layer& environment, const Layer& service) {
  std::expected<Layer, Errors> files;
  for (const Layer* layer : {&flags, &environment}) {
    const auto named = layer->values.find("config");
    if (named == layer->values.end()) continue;
    files = geminga::daemon::read_configuration_files(named->second);
    break;
  }
  if (!files) return std::unexpected(std::move(files.error()));
  auto configuration = geminga::daemon::resolve({&flags, &environment, &*files, &service}, host_name());
  if (!configuration) return configuration;
  auto keys = geminga::daemon::read_keys(configuration->key_files);
  if (!keys) return std::unexpected(std::move(keys.error()));
  configuration->sealing.keys = std::move(*keys);
  return configuration;
}

/// Opens standard input, output and error where they are closed. Else a socket could get one of their numbers, and with
/// it our messages.
void hold_standard_descriptors() {
  while (true) {
    const int descriptor = ::open("/dev/null", O_RDWR);
    if (descriptor < 0) return;
    if (descriptor <= STDERR_FILENO) continue;
    ::close(descriptor);
    return;
  }
}

int refuse(const Errors& errors) {
  for (const std::string& error : errors)
    std::fprintf(stderr, "gemingad: %s\n", geminga::base::harmless(error).c_str());
  return geminga::daemon::exit_wrong;
}

int make_key(const std::string& path) {
  if (path.empty()) return refuse({"--generate-key: an empty path: name a file"});
  const auto id = geminga::daemon::generate_key(path);
  if (!id) return refuse({id.error()});
  std::printf("%s: key %s: copy it to each host of the team, and keep it secret\n", path.c_str(), id->c_str());
  return geminga::daemon::exit_done;
}

int serve(int argc, char** argv) {
  const auto flags = geminga::daemon::read_flags(argc, argv);
  if (!flags) return refuse({flags.error()});
  if (!flags->answer.empty()) {
    std::fputs(flags->answer.c_str(), stdout);
    return geminga::daemon::exit_done;
  }
  if (flags->key_to_generate) return make_key(*flags->key_to_generate);
  if (const Errors errors = geminga::daemon::mistyped_variables(environ); !errors.empty()) return refuse(errors);
  const Layer environment = geminga::daemon::read_environment(environ);
  const Layer service = geminga::daemon::read_service(environ);
  const auto reread = [&] { return configure(flags->layer, environment, service); };
  const auto configuration = reread();
  if (!configuration) return refuse(configuration.error());
  const geminga::daemon::Supervisor supervisor(environ);
  geminga::daemon::Log log(configuration->log_level, configuration->log_format);
  int status = geminga::daemon::exit_done;
  bool is_at_work = false;
  if (const auto shortage = geminga::daemon::check_descriptors()) return refuse({*shortage});
  try {
    geminga::daemon::Daemon daemon(*configuration, reread, supervisor, log);
    const auto done = flags->is_check_only ? daemon.check() : daemon.run();
    if (!done) status = refuse(done.error());
    is_at_work = daemon.is_at_work();
  } catch (const boost::system::system_error& error) {  // no epoll, no timer, no pipe for signals
    return refuse({std::string("the system refuses what is needed: ") + error.what()});
  } catch (const std::bad_alloc&) {
    return refuse({"there is not enough memory to start"});
  }
  if (flags->is_check_only && status == geminga::daemon::exit_done) {
    std::fputs(geminga::daemon::to_toml(*configuration).c_str(), stdout);
  }
  if (is_at_work) std::_Exit(status);  // the end does not wait for a thread whose result is not wanted
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  ::mallopt(M_ARENA_MAX, 1);
  std::signal(SIGPIPE, SIG_IGN);
  hold_standard_descriptors();
  return serve(argc, argv);
}
