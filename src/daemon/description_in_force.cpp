#include "daemon/description_in_force.hpp"

#include <unistd.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "base/text.hpp"
#include "daemon/adoption/adoption.hpp"
#include "daemon/ontology/ontology_loader.hpp"
#include "discovery/participant/description_check.hpp"

namespace geminga::daemon {
namespace {

using base::LogLevel;

constexpr const char* kept_description = "the description in force is kept";

std::vector<std::string> describing_arguments(const Configuration& configuration) {
  std::error_code ignored;
  // Absolute, so that no path looks like a flag.
  const auto whole = [&](const std::string& path) { return std::filesystem::absolute(path, ignored).string(); };
  std::vector<std::string> arguments{"describe", whole(configuration.description)};
  std::vector<std::string> ontologies = configuration.ontologies;
  const std::vector<std::string> adopted = adopted_versions(configuration.adopted, 0);
  ontologies.insert(ontologies.end(), adopted.begin(), adopted.end());
  for (const std::string& file : ontologies) {
    // A compiled form has no declarations that a reader of other files can use.
    if (!file.ends_with(compiled_suffix)) arguments.push_back(whole(file));
  }
  return arguments;
}

/// The line that the child has written; nothing where it is not one, or too long.
std::optional<std::string> line_in(const base::PrivateFile& output) {
  std::string text(max_description_bytes + 2, '\0');
  const ssize_t size = ::pread(output.descriptor(), text.data(), text.size(), 0);
  if (size < 1) return std::nullopt;
  text.resize(static_cast<std::size_t>(size));
  if (text.find('\n') != text.size() - 1) return std::nullopt;
  text.pop_back();
  return text;
}

/// The lines as lines about the key `describe`.
std::vector<std::string> marked(const std::vector<std::string>& lines) {
  std::vector<std::string> all;
  for (const std::string& line : lines) all.push_back("describe: " + line);
  return all;
}

}  // namespace

void DescriptionInForce::load(const Configuration& configuration, participant::Participant& participant) {
  read(configuration, [this, &participant](const std::expected<Described, std::vector<std::string>>& described) {
    if (!described) return log_.write_failed_reading(marked(described.error()), kept_description);
    for (const std::string& line : marked(described->remarks)) log_.write(LogLevel::warning, line);
    log_.write(LogLevel::info, "describe: " + base::printable(file_) + " is in force, as an expression of " +
                                   std::to_string(described->expression.size()) + " octets");
    env_.event([&] { participant.describe(described->expression); });
    after_event_();
  });
}

void DescriptionInForce::check(const Configuration& configuration, participant::Participant::Vocabulary vocabulary,
                               std::function<void(std::vector<std::string>)> done) {
  if (!configuration.describes_by_file()) return done(faults_of(configuration.description, vocabulary));
  read(configuration, [this, vocabulary = std::move(vocabulary),
                       done = std::move(done)](const std::expected<Described, std::vector<std::string>>& described) {
    done(described ? faults_of(described->expression, vocabulary) : marked(described.error()));
  });
}

std::vector<std::string> DescriptionInForce::faults_of(const std::string& expression,
                                                       const participant::Participant::Vocabulary& vocabulary) const {
  const auto fault = participant::check_description(env_, vocabulary, expression);
  return fault ? marked({fault->text}) : std::vector<std::string>();
}

void DescriptionInForce::read(const Configuration& configuration, Done done) {
  child_.reset();
  if (!configuration.describes_by_file()) return;
  file_ = configuration.description;
  const auto fail = [&](std::string line) { done(std::unexpected(std::vector{std::move(line)})); };
  auto output = base::PrivateFile::in_memory();
  if (!output) return fail(output.error());
  output_ = std::make_unique<base::PrivateFile>(std::move(*output));
  const std::string program = find_compiler();
  auto started = Child::start(
      context_, program, describing_arguments(configuration), {},
      [this, done](const ChildEnd& end) { done(described_at(end)); }, output_->descriptor());
  if (!started) return fail("cannot start " + program + ": " + started.error());
  child_ = std::move(*started);
}

std::expected<DescriptionInForce::Described, std::vector<std::string>> DescriptionInForce::described_at(
    const ChildEnd& end) {
  std::vector<std::string> lines = compiler_lines(end.words);
  // The child is destroyed in an event of its own, since it is what calls.
  boost::asio::post(context_, [child = std::shared_ptr<Child>(std::move(child_))] {});
  auto expression = end.has_succeeded ? line_in(*output_) : std::nullopt;
  output_.reset();
  if (expression) return Described{std::move(*expression), std::move(lines)};
  if (lines.empty() || !end.how.starts_with("exit status")) lines.push_back("geminga-ontology: " + end.how);
  return std::unexpected(std::move(lines));
}

}  // namespace geminga::daemon
