#include "law/source_tree.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace geminga::law {
namespace {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// The words behind DEPENDS in the arguments of a call.
std::set<std::string> depends_in(const std::string& arguments) {
  static const std::regex word(R"(\S+)");
  std::set<std::string> depends;
  bool in_depends = false;
  for (auto w = std::sregex_iterator(arguments.begin(), arguments.end(), word); w != std::sregex_iterator(); ++w) {
    const std::string argument = w->str();
    if (argument == "DEPENDS" || argument == "SOURCES" || argument == "LINK") {
      in_depends = argument == "DEPENDS";
    } else if (in_depends) {
      depends.insert(argument);
    }
  }
  return depends;
}

}  // namespace

std::vector<SourceFile> files_below(std::string_view folder, const std::vector<std::string>& endings) {
  const std::filesystem::path root = GEMINGA_SOURCE_DIR;
  std::vector<SourceFile> files;
  for (auto at = std::filesystem::recursive_directory_iterator(root / folder); at != decltype(at)(); ++at) {
    const auto& entry = *at;
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && (name == "build" || name.starts_with('.'))) at.disable_recursion_pending();
    const auto ends_so = [&](const std::string& ending) { return name.ends_with(ending); };
    if (!entry.is_regular_file() || std::ranges::none_of(endings, ends_so)) continue;
    SourceFile file{std::filesystem::relative(entry.path(), root).string(), {}};
    std::istringstream stream(read_text(entry.path()));
    for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
    files.push_back(std::move(file));
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

std::vector<SourceFile> source_files(std::string_view folder) { return files_below(folder, {".hpp", ".cpp", ".h"}); }

std::vector<SourceFile> all_sources() {
  std::vector<SourceFile> all;
  for (const char* folder : {"src", "include", "tools", "tests", "examples"}) {
    std::ranges::move(files_below(folder, {".hpp", ".cpp", ".h", ".c", ".py", ".java", ".js", ".mjs", ".ts"}),
                      std::back_inserter(all));
  }
  return all;
}

Law read_law() {
  static const std::regex call(R"(geminga_(module|program)\(\s*([a-z/-]+)([^)]*)\))");
  const std::filesystem::path root = GEMINGA_SOURCE_DIR;
  Law law;
  for (const char* wing : {"src", "tools"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / wing)) {
      if (entry.path().filename() != "CMakeLists.txt") continue;
      const std::string folder = std::filesystem::relative(entry.path().parent_path(), root).string();
      const std::string text = read_text(entry.path());
      for (auto it = std::sregex_iterator(text.begin(), text.end(), call); it != std::sregex_iterator(); ++it) {
        const bool is_program = (*it)[1] == "program";
        if (is_program && folder.starts_with("src/")) continue;  // main() of a module
        law[is_program ? folder : std::string((*it)[2])].merge(depends_in((*it)[3]));
      }
    }
  }
  return law;
}

std::string module_of(const Law& law, std::string_view path) {
  std::string best;
  for (const auto& [module, depends] : law) {
    if (path.starts_with(module + '/') && module.size() > best.size()) best = module;
  }
  return best;
}

std::vector<std::string> violations(const Law& law, const SourceFile& file) {
  static const std::regex include(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  // Libraries that one folder alone may name, or two where a file is told.
  using Owners = std::vector<std::string>;
  static const std::map<std::string, Owners> owners = {
      {"avahi-", {"tools/bridge/avahi"}},
      {"boost/multi_index", {"discovery/registry"}},
      {"dds/", {"tools/bridge/cyclone"}},
      {"librdf", {"reasoning/syntax/graph/terms"}},
      {"rasqal", {"reasoning/syntax/graph/terms"}},
      {"mosquitto.h", {"tools/bridge/mosquitto"}},
      {"nats/", {"tools/bridge/cnats"}},
      {"raptor", {"reasoning/syntax/rdf/triples"}},
      {"re2", {"reasoning/dl/hypertableau/rules", "reasoning/syntax/graph/formulas"}},
      {"google/protobuf", {"discovery/announcement", "tools/wireshark"}},
      {"sodium", {"discovery/sealing", "client/protocol/primitives.cpp", "tools/ontology/travel"}},
      {"zstd", {"discovery/sealing"}}};
  std::vector<std::string> found;
  const bool is_public = file.path.starts_with("include/");
  const bool is_tool = file.path.starts_with("tools/");
  const std::string_view path = file.path;
  const std::string own =
      is_public ? "" : module_of(law, is_tool ? path : path.substr(std::string_view("src/").size()));
  if (!is_public && own.empty()) return {file.path + ": belongs to no module"};
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    std::smatch match;
    if (!std::regex_search(file.lines[i], match, include)) continue;
    const std::string target = match[2];
    const std::string place = file.path + ':' + std::to_string(i + 1) + ": ";
    for (const auto& [library, homes] : owners) {
      const bool is_home = std::ranges::any_of(
          homes, [&](const std::string& home) { return own == home || file.path == "src/" + home; });
      if (target.starts_with(library) && !is_home) found.push_back(place + target + " belongs to src/" + homes.front());
    }
    if (match[1] == "<" || target.starts_with("geminga/")) continue;
    std::string other = module_of(law, target);
    if (is_tool && other.empty()) other = module_of(law, "tools/" + target);
    if (is_public) {
      found.push_back(place + "the public face includes " + target);
    } else if (!other.empty() && other != own && !law.at(own).contains(other)) {
      found.push_back(place + own + " may not include " + target);
    }
  }
  return found;
}

}  // namespace geminga::law
