#include "daemon/ontology/ontology_loader.hpp"

#include <unistd.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include "base/private_file.hpp"
#include "base/text.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/mapped_file.hpp"

namespace geminga::daemon {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view program_name = "geminga-ontology";
/// The most lines of the compiler's output that are shown, and the most octets of each.
constexpr std::size_t max_lines = 40;
constexpr std::size_t max_child_line_bytes = 1000;

/// The limits of the search of the compiler: a quarter of the time that the child may take in all. Questions that are
/// not settled by then stay undecided, and the robot matches by the rest.
constexpr const char* search_seconds = "30";
constexpr const char* search_steps = "200000000";
/// The compiler's exit status when a limit was reached.
constexpr int limit_reached = 4;

bool is_executable(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

using Loaded = OntologyLoader::Loaded;

std::unexpected<std::vector<std::string>> failure(std::string line) {
  return std::unexpected(std::vector<std::string>{std::move(line)});
}

/// Maps a copy of the file. Errors call it `shown`.
Loaded map(const std::string& path, const std::string& shown) {
  LoadedOntology loaded;
  if (compiled::MappedFile::needs_memory(path))
    loaded.remarks.push_back(shown + " is held in memory: no local disk has room for a copy, set TMPDIR");
  auto mapped = compiled::Ontology::map(path);
  if (!mapped) {
    const std::string& text = mapped.error().text;
    const bool is_named = text.starts_with(path + ": ");
    return failure(shown + ": " + (is_named ? text.substr(path.size() + 2) : text));
  }
  loaded.ontology = std::make_unique<compiled::Ontology>(std::move(*mapped));
  return loaded;
}

/// Maps a compiled ontology that the user keeps, unless it is older than its sources. The first load verifies only what
/// matching needs, so that the start is short. A later one verifies all of it, so that no damaged ontology replaces the
/// one in force.
Loaded map_current(const std::string& path, bool is_first) {
  auto loaded = map(path, path);
  if (!loaded) return loaded;
  if (!is_first) {
    if (const auto whole = loaded->ontology->check_whole(); !whole) return failure(path + ": " + whole.error().text);
  }
  if (const auto stale = loaded->ontology->stale_source()) return failure(path + " is refused: " + *stale);
  return loaded;
}

/// Adds the lines of a compiler that succeeded.
void add_lines(std::vector<std::string> lines, LoadedOntology& loaded) {
  const auto others = std::ranges::stable_partition(
      lines, [](const std::string& line) { return line.starts_with(compiled::left_out_words); });
  loaded.left_out.assign(lines.begin(), others.begin());
  loaded.remarks.insert(loaded.remarks.begin(), others.begin(), others.end());
}

Loaded map_output(const ChildEnd& end, const std::string& compiler, const base::PrivateFile& output) {
  std::vector<std::string> lines = compiler_lines(end.words);
  if (end.has_succeeded || end.exit_status == limit_reached) {
    auto mapped = map("/proc/self/fd/" + std::to_string(output.descriptor()), "the compiled ontology");
    if (mapped) {
      add_lines(std::move(lines), *mapped);
      return mapped;
    }
    // Where the limit came before there was any output, the compiler's words say more than that the output is empty.
    if (end.has_succeeded) return mapped;
  }
  if (lines.empty() || !end.how.starts_with("exit status")) lines.push_back(compiler + ": " + end.how);
  return std::unexpected(std::move(lines));
}

std::vector<std::string> compiler_arguments(const std::vector<std::string>& files, const Prefixes& prefixes,
                                            bool leaves_out_refused) {
  std::vector<std::string> arguments{"compile"};
  if (leaves_out_refused) arguments.emplace_back("--leave-out-refused");
  for (const auto& [name, iri] : prefixes) {
    arguments.emplace_back("--prefix");
    arguments.push_back(name);
    arguments.back().append("=").append(iri);
  }
  arguments.insert(arguments.end(), {"-o", "-"});
  // Absolute, so that no path looks like a flag, and the sources in the compiled form can be found from everywhere.
  std::error_code ignored;
  for (const std::string& file : files) arguments.push_back(fs::absolute(file, ignored).string());
  arguments.insert(arguments.end(), {"--time-limit", search_seconds, "--steps", search_steps});
  return arguments;
}

}  // namespace

std::vector<std::string> compiler_lines(std::string_view words) {
  std::vector<std::string> lines;
  while (!words.empty() && lines.size() < max_lines) {
    const auto end = std::min(words.find('\n'), words.size());
    std::string_view line = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    const std::string prefix = std::string(program_name) + ": ";
    if (line.starts_with(prefix)) line.remove_prefix(prefix.size());
    if (!line.empty()) lines.push_back(base::printable(line, max_child_line_bytes));
  }
  return lines;
}

std::string find_compiler() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (const std::string beside = (self.parent_path() / program_name).string(); !error && is_executable(beside))
    return beside;
  const char* variable = std::getenv("PATH");
  std::string_view folders = variable == nullptr ? std::string_view() : variable;
  while (!folders.empty()) {
    const auto end = std::min(folders.find(':'), folders.size());
    const std::string candidate = std::string(folders.substr(0, end)) + '/' + std::string(program_name);
    if (end > 0 && is_executable(candidate)) return candidate;
    folders.remove_prefix(std::min(end + 1, folders.size()));
  }
  return std::string(program_name);
}

std::optional<std::string> contradiction_in(const LoadedOntology& loaded, const std::vector<std::string>& files) {
  if (loaded.ontology == nullptr || loaded.ontology->is_consistent()) return std::nullopt;
  return "the ontology contradicts itself, so that no class can have an instance: see " + std::string(program_name) +
         " check " + base::joined(files, " ");
}

OntologyLoader::OntologyLoader(boost::asio::io_context& context, std::string compiler, ChildLimits limits)
    : context_(context),
      background_(context),
      compiler_(std::move(compiler)),
      limits_(limits),
      alive_(std::make_shared<int>(0)) {}
OntologyLoader::~OntologyLoader() = default;

void OntologyLoader::load(const std::vector<std::string>& files, const Prefixes& prefixes, Done done,
                          bool leaves_out_refused) {
  child_.reset();
  background_.cancel();
  ++generation_;
  done_ = std::move(done);
  if (files.empty()) return answer_later(LoadedOntology{});
  if (files.size() == 1 && files.front().ends_with(compiled_suffix)) {
    return answer_with([path = files.front(), is_first = !has_loaded_] { return map_current(path, is_first); });
  }
  auto output = base::PrivateFile::in_memory();
  if (!output) return answer_later(failure(output.error()));
  output_ = std::make_shared<base::PrivateFile>(std::move(*output));
  auto started = Child::start(
      context_, compiler_, compiler_arguments(files, prefixes, leaves_out_refused), limits_,
      [this](const ChildEnd& end) { finish(end); }, output_->descriptor());
  if (!started) return answer_later(failure("cannot start " + compiler_ + ": " + started.error()));
  child_ = std::move(*started);
}

void OntologyLoader::finish(const ChildEnd& end) {
  answer_with([end, compiler = compiler_, output = output_] { return map_output(end, compiler, *output); });
}

/// Runs `find` on the thread and answers with its result.
void OntologyLoader::answer_with(std::function<Loaded()> find) {
  background_.start([this, find = std::move(find)]() -> Background::After {
    auto result = std::make_shared<Loaded>();
    try {
      *result = find();
    } catch (const std::bad_alloc&) {
      *result = failure("not enough memory for the compiled ontology");
    }
    return [this, result] { answer(std::move(*result)); };
  });
}

/// Answers in an event of its own, so that `done` may start the next load.
void OntologyLoader::answer_later(Loaded result) {
  auto kept = std::make_shared<Loaded>(std::move(result));
  boost::asio::post(context_, [this, kept, generation = generation_, alive = std::weak_ptr<int>(alive_)] {
    if (!alive.expired() && generation == generation_) answer(std::move(*kept));
  });
}

void OntologyLoader::answer(Loaded result) {
  child_.reset();
  output_.reset();
  has_loaded_ = has_loaded_ || (result && result->ontology != nullptr);
  std::exchange(done_, nullptr)(std::move(result));
}

}  // namespace geminga::daemon
