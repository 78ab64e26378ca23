#include "daemon/cage_in_force.hpp"

#include <filesystem>
#include <string_view>

#include "base/text.hpp"
#include "reasoning/compiled/mapped_file.hpp"

namespace geminga::daemon {
namespace {

constexpr std::string_view compiled_ending = ".geminga";

/// The parts of the cage that the kernel lacks, with what that means; empty where it has all.
std::string lacking(const cage::Held& held) {
  std::string text;
  if (!held.by_system_calls) text = "no seccomp, so that every system call is open to gemingad";
  if (held.by_paths) return text;
  if (!text.empty()) text += ", and ";
  return text + "no Landlock, so that gemingad may write into every file that its user may write into";
}

}  // namespace

cage::Freedom freedom_to_serve(const Configuration& configuration) {
  cage::Freedom freedom;
  freedom.may_serve = true;
  freedom.may_read_all = true;          // a configuration that is read again names files anywhere
  freedom.rewritable = {"/dev/null"};   // the child's standard input
  std::vector<std::string> copied{""};  // what a child has compiled
  for (const std::string& ontology : configuration.ontologies)
    if (ontology.ends_with(compiled_ending)) copied.push_back(ontology);
  for (const std::string& file : copied)
    for (std::string& folder : compiled::MappedFile::folders_for(file)) freedom.rewritable.push_back(std::move(folder));
  if (!configuration.gcnp_socket.empty()) {
    const std::filesystem::path folder = std::filesystem::path(configuration.gcnp_socket).parent_path();
    freedom.removable_folders.push_back(folder.empty() ? "." : folder.string());
  }
  return freedom;
}

std::expected<void, std::string> CageInForce::close(const Configuration& configuration, Log& log) {
  if (configuration.cage == CageWish::none) {
    log.write(base::LogLevel::warning, "in no cage: cage = \"none\" is configured");
    return {};
  }
  held_ = cage::close(freedom_to_serve(configuration));
  if (!held_.fault.empty())
    log.write(base::LogLevel::warning, "in its cage without a file: " + base::printable(held_.fault));
  const std::string missing = lacking(held_);
  if (missing.empty()) {
    log.write(base::LogLevel::info, "in its cage: system calls by seccomp, files by Landlock");
  } else if (configuration.cage == CageWish::required) {
    return std::unexpected("this kernel has " + missing + ": take one that has it, or say cage = \"wanted\"");
  } else {
    log.write(base::LogLevel::warning, "this kernel has " + missing);
  }
  return {};
}

std::string CageInForce::words() const {
  if (held_.by_system_calls) return held_.by_paths ? "calls,files" : "calls";
  return held_.by_paths ? "files" : "none";
}

}  // namespace geminga::daemon
