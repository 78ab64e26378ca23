// Every path that a document or a comment names exists: documents and comments outlive the files that they are about.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "law/source_tree.hpp"

namespace geminga::law {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

const fs::path root = GEMINGA_SOURCE_DIR;

/// A line that names a path from the root of the project: `tools/bench reasoner`, src/base/budget.hpp, tests/law.
std::vector<std::string> paths_from_root(const std::string& line) {
  static const std::regex path(R"((^|[^\w/.\-])((src|include|tests|tools|ontology|examples)/[\w\-]+([./]+[\w\-]+)*))");
  std::vector<std::string> found;
  for (auto at = std::sregex_iterator(line.begin(), line.end(), path); at != std::sregex_iterator(); ++at) {
    const char next = at->suffix().length() == 0 ? ' ' : *at->suffix().first;
    if (next != '*') found.push_back((*at)[2]);  // tests/law/*: a pattern
  }
  return found;
}

/// The headers, sources and documents that a line names, with or without folders: budget.hpp, base/budget.hpp.
std::vector<std::string> file_names(const std::string& line) {
  static const std::regex name(R"((^|[^\w/.\-*])([\w\-]+(/[\w\-]+)*\.(hpp|cpp|md|proto|fbs))\b)");
  std::vector<std::string> found;
  for (auto at = std::sregex_iterator(line.begin(), line.end(), name); at != std::sregex_iterator(); ++at)
    found.push_back((*at)[2]);
  return found;
}

/// Where the links of a line lead: [text](target), but for other sites and places on the same page.
std::vector<std::string> links(const std::string& line) {
  static const std::regex link(R"(\]\(([^)#\s]+)[^)]*\))");
  std::vector<std::string> found;
  for (auto at = std::sregex_iterator(line.begin(), line.end(), link); at != std::sregex_iterator(); ++at) {
    if (!(*at)[1].str().contains("://")) found.push_back((*at)[1]);
  }
  return found;
}

/// The headings of a document that its page gives a place: `## Seal a team` is at #seal-a-team.
std::vector<std::string> places(const std::vector<std::string>& lines) {
  std::vector<std::string> found;
  bool is_example = false;
  for (const std::string& line : lines) {
    if (line.starts_with("```")) is_example = !is_example;
    const auto text = line.find_first_not_of('#');
    if (is_example || text == 0 || text == std::string::npos || line[text] != ' ') continue;
    std::string place;
    for (const char one : line.substr(text + 1)) {
      const auto octet = static_cast<unsigned char>(one);
      if (std::isalnum(octet) != 0 || one == '-' || one == '_' || octet >= 0x80) {
        place += static_cast<char>(std::tolower(octet));
      } else if (one == ' ') {
        place += '-';
      }
    }
    found.push_back(place);
  }
  return found;
}

/// Links of a line to places: the document, empty for the same one, and the place in it.
std::vector<std::pair<std::string, std::string>> links_to_places(const std::string& line) {
  static const std::regex link(R"(\]\(([^)#\s:]*)#([^)\s]+)\))");
  std::vector<std::pair<std::string, std::string>> found;
  for (auto at = std::sregex_iterator(line.begin(), line.end(), link); at != std::sregex_iterator(); ++at)
    found.emplace_back((*at)[1], (*at)[2]);
  return found;
}

std::vector<std::string> lines_of(const fs::path& path) {
  std::vector<std::string> lines;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// The sections, `## ...`, that a table of contents before the first of them leaves out; none where there is no such
/// table.
std::vector<std::string> missing_in_contents(const std::vector<std::string>& lines) {
  const auto is_section = [](const std::string& line) { return line.starts_with("## "); };
  const auto first = std::ranges::find_if(lines, is_section);
  std::set<std::string> named;
  for (auto line = lines.begin(); line != first; ++line) {
    if (line->starts_with("- [")) named.insert(line->substr(3, line->find(']') - 3));
  }
  std::vector<std::string> missing;
  for (auto line = first; line != lines.end() && !named.empty(); ++line) {
    if (is_section(*line) && !named.contains(line->substr(3))) missing.push_back(line->substr(3));
  }
  return missing;
}

/// A file may be named without its ending: `tests/law/paths_test`.
bool is_there(const fs::path& path) {
  return std::ranges::any_of(std::vector<const char*>{"", ".hpp", ".cpp"},
                             [&](const char* ending) { return fs::exists(path.string() + ending); });
}

/// The documents at the top and below src/, tests/ and ontology/. The changelog tells of what was.
std::vector<fs::path> documents() {
  std::vector<fs::path> found;
  const auto look_at = [&](const fs::directory_entry& entry) {
    if (entry.path().extension() == ".md" && entry.path().filename() != "CHANGELOG.md") found.push_back(entry.path());
  };
  for (const auto& entry : fs::directory_iterator(root)) look_at(entry);
  for (const char* folder : {"src", "tests", "ontology"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) look_at(entry);
  }
  std::ranges::sort(found);
  return found;
}

/// Every path of the project, and each end of it that begins behind a slash.
std::set<std::string> ends_of_paths() {
  std::set<std::string> ends;
  const auto add = [&](const fs::path& path) {
    const std::string text = fs::relative(path, root).generic_string();
    ends.insert(text);
    for (auto slash = text.find('/'); slash != std::string::npos; slash = text.find('/', slash + 1))
      ends.insert(text.substr(slash + 1));
  };
  for (const auto& entry : fs::directory_iterator(root)) add(entry.path());
  for (const char* folder : {"src", "include", "tools", "tests", "ontology", "examples"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) add(entry.path());
  }
  return ends;
}

TEST(Paths, OfDocumentsExist) {
  const std::set<std::string> ends = ends_of_paths();
  for (const fs::path& document : documents()) {
    std::ifstream file(document);
    std::size_t number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      for (const std::string& path : paths_from_root(line)) {
        // In a link it may be relative to the document.
        EXPECT_TRUE(is_there(root / path) || is_there(document.parent_path() / path))
            << document.string() << ':' << number << ": there is no " << path;
      }
      for (const std::string& name : file_names(line)) {
        EXPECT_TRUE(ends.contains(name)) << document.string() << ':' << number << ": there is no " << name;
      }
      for (const std::string& target : links(line)) {
        EXPECT_TRUE(fs::exists(document.parent_path() / target))
            << document.string() << ':' << number << ": the link leads nowhere: " << target;
      }
    }
  }
}

TEST(Paths, ToPlacesInDocumentsExist) {
  for (const fs::path& document : documents()) {
    const std::vector<std::string> lines = lines_of(document);
    for (const std::string& line : lines) {
      for (const auto& [file, place] : links_to_places(line)) {
        const std::vector<std::string> there = file.empty() ? lines : lines_of(document.parent_path() / file);
        EXPECT_THAT(places(there), testing::Contains(place)) << document.string() << ": " << line;
      }
    }
    EXPECT_THAT(missing_in_contents(lines), IsEmpty()) << document.string();
  }
}

TEST(Paths, OfFilesInCommentsAreKnown) {
  const std::set<std::string> ends = ends_of_paths();
  for (const char* folder : {"src", "include", "tools"}) {
    for (const SourceFile& file : source_files(folder)) {
      for (std::size_t at = 0; at < file.lines.size(); ++at) {
        const auto comment = file.lines[at].find("//");
        if (comment == std::string::npos) continue;
        for (const std::string& name : file_names(file.lines[at].substr(comment))) {
          EXPECT_TRUE(ends.contains(name)) << file.path << ':' << at + 1 << ": there is no " << name;
        }
      }
    }
  }
}

TEST(Paths, OfCommentsExist) {
  for (const char* folder : {"src", "include", "tools"}) {
    for (const SourceFile& file : source_files(folder)) {
      for (std::size_t at = 0; at < file.lines.size(); ++at) {
        const auto comment = file.lines[at].find("//");
        if (comment == std::string::npos) continue;
        for (const std::string& path : paths_from_root(file.lines[at].substr(comment))) {
          EXPECT_TRUE(is_there(root / path)) << file.path << ':' << at + 1 << ": there is no " << path;
        }
      }
    }
  }
}

TEST(Paths, AreFoundInALine) {
  EXPECT_THAT(paths_from_root("see `tools/bench reasoner`, src/base/ and tests/law/paths_test.cpp."),
              ElementsAre("tools/bench", "src/base", "tests/law/paths_test.cpp"));
  EXPECT_THAT(paths_from_root("/usr/src/linux, my-tests/x, src/**/*.md, http://a/tools/b"), IsEmpty());
  EXPECT_THAT(file_names("as base/budget.hpp says, and ANNOUNCEMENT.md; *_test.cpp"),
              ElementsAre("base/budget.hpp", "ANNOUNCEMENT.md"));
  EXPECT_THAT(links("[a](b/c.md#d), [e](https://f/g), [h](#i)"), ElementsAre("b/c.md"));
  EXPECT_THAT(links_to_places("[a](b/c.md#d), [e](https://f/g#k), [h](#i)"),
              ElementsAre(testing::Pair("b/c.md", "d"), testing::Pair("", "i")));
  EXPECT_THAT(places({"# One: two", "```", "# no heading", "```", "## `three` and 4"}),
              ElementsAre("one-two", "three-and-4"));
  EXPECT_THAT(missing_in_contents({"- [One](#one)", "## One", "## Two"}), ElementsAre("Two"));
}

}  // namespace
}  // namespace geminga::law
