// geminga-query replay: plays a recording to every program that speaks GCNP, or writes it as MCAP.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "recording/mcap/export.hpp"
#include "recording/player.hpp"
#include "recording/serving/server.hpp"
#include "shell/report.hpp"
#include "shell/timestamp.hpp"

namespace geminga::query {
namespace {

using shell::ExitStatus;

/// The most findings about a recording that are told one by one.
constexpr std::size_t max_told_findings = 20;

struct ReplayFlags {
  std::string file;
  std::string where = "127.0.0.1:4718";
  double speed = 1;
  std::optional<recording::Moment> from;
  bool is_paused = false;
  bool ends = false;
  std::string mcap;
};

/// Says what is wrong in a recording, up to a number of findings, and how many there were.
class ToldFindings {
 public:
  explicit ToldFindings(std::string file) : file_(std::move(file)) {}
  ~ToldFindings() {
    if (count_ <= max_told_findings) return;
    shell::complain(program, file_ + ": " + std::to_string(count_ - max_told_findings) + " more such lines");
  }
  ToldFindings(const ToldFindings&) = delete;
  ToldFindings& operator=(const ToldFindings&) = delete;

  void tell(const recording::Finding& finding) {
    if (++count_ <= max_told_findings) shell::complain(program, file_ + ": " + recording::to_string(finding));
  }
  ExitStatus refuse(const recording::Finding& finding) const {
    shell::complain(program, file_ + ": " + (finding.line == 0 ? finding.text : recording::to_string(finding)));
    return ExitStatus::wrong_use;
  }

 private:
  std::string file_;
  std::size_t count_ = 0;
};

ExitStatus write_mcap(recording::Reader& reader, const ReplayFlags& flags, const ToldFindings& findings) {
  std::ofstream out(flags.mcap, std::ios::binary | std::ios::trunc);
  if (!out) {
    shell::complain(program, flags.mcap + " cannot be written: choose another place for --mcap");
    return ExitStatus::wrong_use;
  }
  const auto count = recording::mcap::export_recording(reader, out);
  out.close();
  if (!count) return findings.refuse(count.error());
  if (out.fail()) {
    shell::complain(program, flags.mcap + " could not be written whole: is the disk full?");
    return ExitStatus::wrong_use;
  }
  std::cout << flags.mcap << ": " << *count << " messages\n";
  return ExitStatus::found;
}

ExitStatus play(recording::Player& player, const ReplayFlags& flags, const ToldFindings& findings) {
  ExitStatus status = ExitStatus::found;
  recording::Server server(
      player, {.where = flags.where,
               .is_paused = flags.is_paused,
               .ends = flags.ends,
               .ended =
                   [&](const std::optional<recording::Finding>& finding) {
                     if (finding) status = findings.refuse(*finding);
                     std::cout << "The recording ends at " << shell::timestamp(player.state().time())
                               << (flags.ends ? "." : ": its last moment stays until Ctrl-C.") << '\n'
                               << std::flush;
                   },
               .words = flags.file == "-" ? -1 : STDIN_FILENO,
               .followed =
                   [&](bool plays, const std::string& error) {
                     if (!error.empty()) shell::complain(program, error);
                     std::cout << (plays ? "Plays from " : "Stands at ") << shell::timestamp(player.state().time());
                     if (player.speed() != 1) std::cout << ", speed " << player.speed();
                     std::cout << '\n' << std::flush;
                   }});
  if (const auto listening = server.listen(); !listening) {
    shell::complain(program, listening.error());
    return ExitStatus::wrong_use;
  }
  const recording::Snapshot& source = player.state().source();
  std::cout << (flags.is_paused ? "Stands at " : "Plays from ") << shell::timestamp(player.state().time()) << ", as "
            << shell::printable(source.name.empty() ? source.participant : source.name)
            << " saw it: geminga-query --connect " << flags.where << " participants" << '\n'
            << std::flush;
  server.run();
  return status;
}

ExitStatus replay(const Context& context, const ReplayFlags& flags) {
  if (refuses_watch(context, "replay")) return ExitStatus::wrong_use;
  std::ifstream file;
  if (flags.file != "-") file.open(flags.file, std::ios::binary);
  std::istream& in = flags.file == "-" ? std::cin : file;
  if (!in || in.peek() == std::char_traits<char>::eof()) {
    shell::complain(program, flags.file + " cannot be read, or is empty: name a file that geminga-query record wrote");
    return ExitStatus::wrong_use;
  }
  ToldFindings findings(flags.file);
  recording::Reader reader(in, [&](const recording::Finding& finding) { findings.tell(finding); });
  if (!flags.mcap.empty()) return write_mcap(reader, flags, findings);
  auto player = recording::Player::begin(std::move(reader), flags.speed, flags.from);
  return player ? play(*player, flags, findings) : findings.refuse(player.error());
}

/// The error in a --speed; empty: none. (CLI::Range would accept NaN.)
std::string complaint_about_speed(const std::string& text) {
  double speed = 0;
  const bool is_number = CLI::detail::lexical_cast(text, speed);
  if (is_number && speed >= recording::least_speed && speed <= recording::most_speed) return {};
  return "must be a number from 0.01 to 10000";
}

void read_moment(ReplayFlags& flags, const std::string& flag, const std::string& word) {
  flags.from = recording::parse_moment(word);
  if (flags.from) return;
  throw CLI::ValidationError(flag,
                             "must be seconds from the beginning, HH:MM or HH:MM:SS in UTC, or a time such as "
                             "2026-11-22T14:03:00Z");
}

}  // namespace

void add_replay(CLI::App& app, RunAlone& selected) {
  CLI::App* command = app.add_subcommand("replay", "Answer programs from a recording, as the daemon did then");
  const auto flags = std::make_shared<ReplayFlags>();
  command->add_option("FILE", flags->file, "What geminga-query record wrote; - is standard input")->required();
  command->add_option("--gcnp", flags->where, "Where to listen for programs (default: 127.0.0.1:4718)")
      ->type_name("ADDRESS:PORT|PATH");
  command->add_option("--speed", flags->speed, "How many seconds of the recording pass in one second (default: 1)")
      ->type_name("X")
      ->check(complaint_about_speed, "", "");
  CLI::Option* from = command->add_option_function<std::string>(
      "--from", [flags](const std::string& word) { read_moment(*flags, "--from", word); },
      "Begin at this moment: seconds from the beginning, a time of day in UTC, or a whole time");
  from->type_name("TIME");
  command
      ->add_option_function<std::string>(
          "--at",
          [flags](const std::string& word) {
            read_moment(*flags, "--at", word);
            flags->is_paused = true;
          },
          "Stand still at this moment")
      ->type_name("TIME")
      ->excludes(from);
  command->add_flag("--end", flags->ends, "End when the recording ends (default: its last moment stays)");
  command->add_option("--mcap", flags->mcap, "Play nothing, and write the whole recording as MCAP into this file")
      ->type_name("FILE");
  command->footer(
      "Examples:\n  geminga-query replay field-test.jsonl --speed 10\n"
      "  geminga-query --connect 127.0.0.1:4718 --watch services     (meanwhile)\n"
      "  geminga-query replay field-test.jsonl --at 14:03:10\n"
      "  zstd -dc field-test.jsonl.zst | geminga-query replay - --from 90\n"
      "  geminga-query replay field-test.jsonl --mcap field-test.mcap\n"
      "While it runs, a line of standard input moves it: pause, play (an empty line does either), speed X, seek TIME, "
      "+10, -10 (seconds).\n"
      "A recording has no ontology: it knows why a request had its services or none, what matched the concepts of "
      "requests, "
      "and compares other concepts by their names.");
  command->callback(
      [flags, &selected] { selected = [flags](const Context& context) { return replay(context, *flags); }; });
}

}  // namespace geminga::query
