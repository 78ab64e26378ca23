// geminga-query record: keeps the stream of events in a file, for replay.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "recording/moment.hpp"
#include "recording/recorder.hpp"
#include "recording/recording_file.hpp"
#include "shell/report.hpp"
#include "shell/stop_signals.hpp"

namespace geminga::query {
namespace {

using recording::At;
using shell::ExitStatus;
using std::chrono::milliseconds;

/// The least pause between two rounds of questions, as with --watch.
constexpr milliseconds least_pause{250};
/// The pause is so many times as long as the round took, so that a great team costs a fifth of a core at most.
constexpr int pauses_in_round = 4;
/// The rounds between two questions for reasons, and between two about the daemon itself.
constexpr unsigned rounds_of_reasons = 4;
constexpr unsigned rounds_of_status = 20;
/// The pause between two attempts to reach a daemon that is gone.
constexpr milliseconds attempt_pause{1000};

struct RecordFlags {
  std::string file;
  bool appends = false;
  std::uint64_t limit_mib = recording::usual_limit_mib;
};

recording::Snapshot source_of(const Client& client) {
  const Welcome& welcome = client.welcome();
  return {to_string(welcome.participant), welcome.participant_name, welcome.ontology, 0};
}

/// Asks in rounds, and writes what the recorder gives.
class Recording {
 public:
  Recording(const Context& context, recording::RecordingFile& file, const RecordFlags& flags, Client client)
      : context_(context),
        file_(file),
        client_(std::move(client)),
        recorder_(source_of(*client_), flags.limit_mib * 1024 * 1024) {}

  ExitStatus run() {
    while (true) {
      const At began = at();
      if (client_) ask();
      if (!client_ && status_ == ExitStatus::found) connect();
      if (status_ != ExitStatus::found) return finish("error");
      const At round_pause = std::max<At>(least_pause, pauses_in_round * (at() - began));
      const auto woken = signals_.wait(-1, client_ ? round_pause : attempt_pause);
      if (woken == shell::StopSignals::Woken::stopped) return finish("stopped");
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] At at() const { return std::chrono::duration_cast<At>(Clock::now() - begin_); }
  [[nodiscard]] static recording::Time time() {
    return std::chrono::floor<milliseconds>(std::chrono::system_clock::now());
  }

  void write(const std::string& lines) {
    if (const auto written = file_.write(lines, at()); !written) fail(written.error());
  }
  void fail(const std::string& text) {
    shell::complain(program, text);
    status_ = ExitStatus::wrong_use;
  }

  /// The answer to a query; nothing where the daemon refuses it now or is gone.
  std::optional<Answer> query(std::string_view kind,
                              const std::vector<std::pair<std::string, std::string>>& parameters = {}) {
    if (!client_) return std::nullopt;
    auto answer = client_->query(kind, parameters);
    if (answer) return std::move(*answer);
    if (answer.error().kind == ClientError::Kind::refused) return std::nullopt;
    shell::complain(program, answer.error().text + ": the recording goes on when it is there again");
    write(recorder_.lost(answer.error().text, at(), time()));
    client_.reset();
    return std::nullopt;
  }

  void connect() {
    auto client = Client::connect(client_options(context_));
    if (!client) return;
    client_ = std::move(*client);
    recorder_.found_again(source_of(*client_));
    round_ = 0;
    shell::complain(program, "the daemon is there again");
  }

  /// Adds why and because to the records that nobody answers (their `flag` says so). Returns whether all have them.
  static bool add_reasons(std::vector<Record>& records, std::string_view key, std::string_view flag,
                          const std::map<std::string, Record>& reasons) {
    bool has_all = true;
    for (Record& record : records) {
      if (record[flag] != "0") continue;
      const auto reason = reasons.find(std::string(record[key]));
      has_all = has_all && reason != reasons.end();
      if (reason == reasons.end()) continue;
      for (const char* field : {"why", "because"}) record.fields.emplace_back(field, reason->second[field]);
    }
    return has_all;
  }
  void ask_for_reasons(std::string_view kind, const char* flag, std::string_view key,
                       std::map<std::string, Record>& reasons) {
    const auto answer = query(kind, {{flag, "1"}});
    if (!answer) return;
    reasons.clear();
    for (const Record& record : answer->records) reasons.emplace(std::string(record[key]), record);
  }

  void ask() {
    const bool asks_reasons = round_ % rounds_of_reasons == 0;
    const bool asks_status = round_ % rounds_of_status == 0;
    ++round_;
    if (asks_reasons || !has_all_reasons_) {
      ask_for_reasons("requests", "unmatched", "subscription", unmatched_);
      ask_for_reasons("services", "unused", "service", unused_);
    }
    auto participants = query("participants");
    auto services = query("services");
    auto requests = query("requests");
    if (!participants || !services || !requests) return;
    recording::Observation seen{std::move(participants->records), std::move(services->records),
                                std::move(requests->records)};
    const bool has_all_of_requests = add_reasons(seen.requests, "subscription", "served", unmatched_);
    has_all_reasons_ = add_reasons(seen.services, "service", "used", unused_) && has_all_of_requests;
    const auto lines = recorder_.observe(seen, at(), time());
    if (!lines) return fail(lines.error());
    write(*lines);
    if (asks_reasons) ask_why(seen.requests);
    if (asks_status) ask_about_daemon();
  }

  void note(const recording::Answered& answered) { write(recorder_.answered(answered, at(), time())); }

  void ask_why(const std::vector<Record>& requests) {
    for (const std::string& subscription : recorder_.requests_to_ask()) {
      if (auto answer = query("why", {{"subscription", subscription}})) {
        note({"why", subscription, std::move(*answer)});
      }
      const auto request =
          std::ranges::find(requests, subscription, [](const Record& one) { return one["subscription"]; });
      if (request != requests.end() && !(*request)["concept"].empty()) ask_match(*request);
    }
  }
  /// Asks what the ontology finds for the concept of a request. Ages go by the signs of life.
  void ask_match(const Record& request) {
    std::vector<std::pair<std::string, std::string>> parameters;
    for (const char* key : {"concept", "representation"}) {
      if (!request[key].empty()) parameters.emplace_back(key, request[key]);
    }
    auto answer = query("match", parameters);
    if (!answer) return;
    for (Record& one : answer->records)
      std::erase_if(one.fields, [](const auto& field) { return field.first == "age"; });
    note({"match", std::string(request["subscription"]), std::move(*answer)});
  }
  void ask_about_daemon() {
    for (const char* kind : {"status", "ontology", "security", "interfaces", "peers"}) {
      if (auto answer = query(kind)) note({kind, "", std::move(*answer)});
    }
  }

  ExitStatus finish(const std::string& reason) {
    if (status_ == ExitStatus::found) write(recorder_.end(reason, at(), time()));
    const std::size_t skipped = recorder_.skipped_in_all();
    std::string text = "recorded " + recording::span_words(at()) + " in " + std::to_string(file_.written()) + " octets";
    if (skipped > 0) {
      text += "; " + std::to_string(skipped) + " rounds were left out at the limit: give a greater --limit";
    }
    shell::complain(program, text);
    return status_;
  }

  const Context& context_;
  recording::RecordingFile& file_;
  shell::StopSignals signals_;
  std::optional<Client> client_;
  recording::Recorder recorder_;
  Clock::time_point begin_ = Clock::now();
  unsigned round_ = 0;
  std::map<std::string, Record> unmatched_;
  std::map<std::string, Record> unused_;
  bool has_all_reasons_ = true;
  ExitStatus status_ = ExitStatus::found;
};

ExitStatus record(const Context& context, const RecordFlags& flags) {
  if (refuses_watch(context, "record")) return ExitStatus::wrong_use;
  auto client = Client::connect(client_options(context));
  if (!client) return shell::report(program, client.error());
  auto file = recording::RecordingFile::open(flags.file, flags.appends);
  if (!file) {
    shell::complain(program, file.error());
    return ExitStatus::wrong_use;
  }
  return Recording(context, *file, flags, std::move(*client)).run();
}

}  // namespace

void add_record(CLI::App& app, RunAlone& selected) {
  CLI::App* command =
      app.add_subcommand("record", "Record what happens in the team in a file, until Ctrl-C; replay plays it");
  const auto flags = std::make_shared<RecordFlags>();
  command->add_option("FILE", flags->file, "The recording; - is standard output")->required();
  command->add_flag("--append", flags->appends, "Continue an existing recording");
  command
      ->add_option("--limit", flags->limit_mib,
                   "The most MiB in an hour (default: 64); above it the recording leaves moments out, and says so")
      ->type_name("MIB")
      ->check(shell::whole_number(recording::least_limit_mib, recording::most_limit_mib), "", "");
  command->footer(
      "Examples:\n  geminga-query record field-test.jsonl\n  geminga-query record --append --limit 16 "
      "/var/lib/robot/team.jsonl\n"
      "  geminga-query record - | zstd > field-test.jsonl.zst\n"
      "A recording has one JSON object a line. A loss of power costs its last two seconds at most. It goes on when a "
      "lost\ndaemon is back.");
  command->callback(
      [flags, &selected] { selected = [flags](const Context& context) { return record(context, *flags); }; });
}

}  // namespace geminga::query
