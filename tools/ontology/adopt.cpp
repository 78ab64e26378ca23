// `geminga-ontology adopt`: fetches, version by version, the ontologies that the daemon of this host adopts.
#include <poll.h>
#include <sys/stat.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/numbered_folders.hpp"
#include "base/text.hpp"
#include "ontology/command/client_exit.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/travel/folder.hpp"
#include "ontology/travel/taking.hpp"

namespace geminga::ontology {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// The newest versions of a publisher that stay: the daemon takes an older one where a newer one cannot be used.
constexpr std::size_t kept_versions = 3;
constexpr std::chrono::milliseconds between_looks_for_versions{5000};
/// The time before a version is asked for again that could not be taken.
constexpr std::chrono::minutes after_failure{1};

struct AdoptRequest {
  std::string connect;
  bool is_open = false;
  bool is_once = false;
  unsigned time_limit = 600;  ///< seconds for one version
  std::string folder;         ///< of all publishers, as the daemon said at the start
};

/// The publishers that the daemon adopts, and the folder for them.
struct Adopted {
  std::vector<std::string> publishers;
  std::string folder;
};

std::expected<Adopted, ClientError> adopted_by(Client& client) {
  const auto answer = client.query("status");
  if (!answer) return std::unexpected(answer.error());
  Adopted adopted;
  for (const Record& record : answer->records) {
    std::string_view names = record["adopt_from"];
    adopted.folder = record["adopted_folder"];
    while (!names.empty()) {
      const std::size_t end = std::min(names.find(','), names.size());
      adopted.publishers.emplace_back(names.substr(0, end));
      names.remove_prefix(std::min(end + 1, names.size()));
    }
  }
  return adopted;
}

/// Asks the daemon for the folder, and makes it. It is done before the cage is closed, which needs to know the folder.
Exit find_folder(AdoptRequest& request) {
  auto client = Client::connect({.connect = request.connect, .name = {}});
  if (!client) return say_error(client.error().text, exit_of_client(client.error()));
  const auto adopted = adopted_by(*client);
  if (!adopted) return say_error(adopted.error().text, exit_of_client(adopted.error()));
  if (adopted->publishers.empty())
    return say_error("gemingad adopts from nobody: set adopt-from = [\"PARTICIPANT\"] and send it SIGHUP", Exit::no);
  request.folder = adopted->folder;
  std::error_code error;
  fs::create_directories(request.folder, error);
  if (error) return say_error(request.folder + ": cannot be made: " + error.message());
  return Exit::yes;
}

class Adopting {
 public:
  explicit Adopting(const AdoptRequest& request) : request_(request) {}

  /// Looks once at each publisher.
  Exit look() {
    auto client = Client::connect({.connect = request_.connect, .name = {}});
    if (!client) return say_once(client.error());
    const auto adopted = adopted_by(*client);
    if (!adopted) return say_once(adopted.error());
    if (!adopted->publishers.empty() && adopted->folder != request_.folder)
      return say_error("the daemon adopts into another folder: start this anew");
    const auto all = candidates(*client);
    if (!all) return say_once(all.error());
    said_.clear();
    Exit exit = Exit::yes;
    for (const std::string& publisher : adopted->publishers) {
      if (const Exit taken = take_newer(publisher, *all); taken != Exit::yes) exit = taken;
    }
    return exit;
  }

 private:
  /// Says what keeps the daemon from answering, unless it was said at the last look.
  Exit say_once(const ClientError& error) {
    if (std::exchange(said_, error.text) != error.text) say_error(error.text);
    return exit_of_client(error);
  }

  Exit take_newer(const std::string& publisher, const std::vector<Candidate>& all) {
    const std::string folder = (fs::path(request_.folder) / publisher).string();
    const std::vector<std::uint64_t> versions = base::numbered_folders(folder);
    const Wish wish{.participant = publisher,
                    .least_version = versions.empty() ? 1 : versions.back() + 1,
                    .is_newest = true,
                    .connect = request_.connect,
                    .is_open = request_.is_open,
                    .patience = {},
                    .time = std::chrono::seconds(request_.time_limit)};
    const auto newer = candidates_for(wish, all);
    if (newer.empty()) return Exit::yes;
    auto& next_try = next_tries_[newer.front().digest];
    if (Clock::now() < next_try) return Exit::yes;
    next_try = Clock::now() + after_failure;
    const auto taken = take(wish, [](std::string_view line) { say_error(line); });
    if (!taken) return say_error(base::printable(publisher) + ": " + taken.error().text, Exit::no);
    return keep(folder, *taken);
  }

  Exit keep(const std::string& folder, const Taken& taken) {
    const Manifest& manifest = *taken.arrival.manifest();
    // The version that was announced is not covered by the digest, the one of the manifest is.
    if (manifest.version != taken.provider.version)
      return say_error(taken.provider.service + " announces another version than it offers", Exit::no);
    ::mkdir(folder.c_str(), 0777);
    const std::string version = (fs::path(folder) / std::to_string(manifest.version)).string();
    const auto written = write_folder(version, manifest, taken.arrival.content(), random_tag());
    if (!written) return say_error(written.error(), Exit::no);
    keep_newest_versions(folder, kept_versions, random_tag());
    return say_error(version + ": fetched, " + taken.provider.digest, Exit::yes);
  }

  const AdoptRequest& request_;
  std::map<std::string, Clock::time_point> next_tries_;  ///< by digest
  std::string said_;                                     ///< of the daemon, at the last look
};

Exit adopt(const AdoptRequest& request) {
  Adopting adopting(request);
  while (true) {
    const Exit exit = adopting.look();
    if (request.is_once || exit == Exit::usage) return exit;
    ::poll(nullptr, 0, static_cast<int>(between_looks_for_versions.count()));
  }
}

}  // namespace

void add_adopt(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<AdoptRequest>();
  CLI::App* command = program.add_subcommand("adopt", "Keep fetching the ontologies that this host's daemon adopts");
  add_connect(*command, request->connect);
  command->add_flag("--open", request->is_open, "also where the team has no key");
  command->add_flag("--once", request->is_once, "look once and end");
  add_number(*command, "--time-limit", request->time_limit, 1, 1'000'000, "seconds for one version; default: 600")
      ->type_name("N");
  command->footer(
      "\nThe daemon's setting adopt-from says from whom ontologies are adopted. The daemon reads them in\n"
      "STATE-FOLDER/adopted/PARTICIPANT/VERSION. A greater version than those there is fetched, by the rules of\n"
      "the command fetch; three versions are kept. The daemon puts in force the newest one that it can read whole\n"
      "and that contradicts neither itself nor the daemon's own files. The service geminga-adopt of the package\n"
      "is off until it is enabled.\n"
      "Exit status: 0 looked once, 1 something could not be fetched, or the daemon adopts from nobody, 2 wrong\n"
      "usage, 3 no daemon.\n"
      "\nExample:\n  geminga-ontology adopt --once");
  command->callback([request, &choice] {
    choice.may_talk = true;
    choice.may_make_folders = true;
    choice.prepare = [request, &choice] {
      const Exit found = find_folder(*request);
      choice.outputs.push_back((fs::path(request->folder) / "adopted").string());
      choice.readable.push_back(request->folder);
      return found;
    };
    choice.run = [request] { return adopt(*request); };
  });
}

}  // namespace geminga::ontology
