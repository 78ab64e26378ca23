// The include law of the client libraries in Python, JavaScript and Java: in each the folder protocol knows no sockets,
// the folder channels knows no node, and no files import each other in a circle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "law/source_tree.hpp"

namespace geminga::law {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// The file or package that a relative import of Python names, without its ending: `..protocol.frame` from a/b/c.py is
/// a/protocol/frame.
std::string python_target(const fs::path& file, const std::string& name) {
  fs::path folder = file.parent_path();
  std::size_t dots = name.find_first_not_of('.');
  if (dots == std::string::npos) dots = name.size();
  for (std::size_t up = 1; up < dots; ++up) folder = folder.parent_path();
  std::string rest = name.substr(dots);
  std::ranges::replace(rest, '.', '/');
  return (rest.empty() ? folder : folder / rest).generic_string();
}

void add_python(const fs::path& file, const std::string& line, std::vector<std::string>& found) {
  static const std::regex from(R"(^\s*from (\.+[\w.]*) import (.+)$)");
  static const std::regex word(R"(\w+)");
  std::smatch match;
  if (!std::regex_match(line, match, from)) return;
  if (match[1].str().find_first_not_of('.') != std::string::npos) return found.push_back(python_target(file, match[1]));
  const std::string names = match[2];  // from . import a, b
  for (auto name = std::sregex_iterator(names.begin(), names.end(), word); name != std::sregex_iterator(); ++name)
    found.push_back(python_target(file, match[1].str() + name->str()));
}

void add_javascript(const fs::path& file, const std::string& line, std::vector<std::string>& found) {
  static const std::regex from(R"rx(\bfrom '(\.[^']+)')rx");
  std::smatch match;
  if (!std::regex_search(line, match, from)) return;
  found.push_back((file.parent_path() / match[1].str()).lexically_normal().replace_extension().generic_string());
}

void add_java(const std::string& line, std::vector<std::string>& found) {
  static const std::regex import(R"(^import (?:static )?(geminga\.[\w.]+);)");
  std::smatch match;
  if (!std::regex_search(line, match, import)) return;
  std::string name = match[1];
  std::ranges::replace(name, '.', '/');
  found.push_back("src/client/java/" + name);
}

/// The files of the same library that a file imports, without their endings.
std::vector<std::string> imports(const SourceFile& file) {
  std::vector<std::string> found;
  for (const std::string& line : file.lines) {
    if (file.path.ends_with(".py")) add_python(file.path, line, found);
    if (file.path.ends_with(".js")) add_javascript(file.path, line, found);
    if (file.path.ends_with(".java")) add_java(line, found);
  }
  return found;
}

/// Whether a path has this folder, or names the node or a publisher or subscriber of the public face.
bool is_in(const std::string& path, const std::string& folder) { return path.contains('/' + folder + '/'); }
bool is_of_public_face(const std::string& path) {
  static const std::regex face(
      R"(/geminga/(Node|Publisher|Subscriber)$|/(geminga|lib)/(node|publisher|subscriber|index|__init__)$)");
  return std::regex_search(path, face);
}

std::vector<std::string> forbidden_imports(const SourceFile& file) {
  std::vector<std::string> found;
  for (const std::string& target : imports(file)) {
    const bool is_wrong = (is_in(file.path, "protocol") && (is_in(target, "channels") || is_of_public_face(target))) ||
                          (is_in(file.path, "channels") && is_of_public_face(target));
    if (is_wrong) found.push_back(file.path + " may not import " + target);
  }
  return found;
}

/// The files that import each other in a circle, one of each circle.
std::vector<std::string> circles(const std::vector<SourceFile>& files) {
  std::map<std::string, std::vector<std::string>> graph;
  for (const SourceFile& file : files) graph[fs::path(file.path).replace_extension().generic_string()] = imports(file);
  std::map<std::string, int> visits;  // 1: being visited, 2: done
  std::vector<std::string> found;
  std::function<void(const std::string&)> visit = [&](const std::string& file) {
    visits[file] = 1;
    for (const std::string& target : graph[file]) {
      if (!graph.contains(target)) continue;
      if (visits[target] == 1) found.push_back(file + " and " + target + " import each other in a circle");
      if (visits[target] == 0) visit(target);
    }
    visits[file] = 2;
  };
  for (const SourceFile& file : files) {
    const std::string name = fs::path(file.path).replace_extension().generic_string();
    if (visits[name] == 0) visit(name);
  }
  return found;
}

TEST(Languages, KeepTheProtocolFreeOfSocketsAndChannelsFreeOfTheNode) {
  const auto files = files_below("src/client", {".py", ".js", ".java"});
  ASSERT_GE(files.size(), 100U);
  std::set<std::string> seen;
  for (const SourceFile& file : files) {
    EXPECT_THAT(forbidden_imports(file), IsEmpty());
    for (const char* folder : {"protocol", "channels"}) {
      if (is_in(file.path, folder)) seen.insert(fs::path(file.path).extension().string() + ' ' + folder);
    }
  }
  EXPECT_THAT(seen, SizeIs(6)) << "each of three languages has both folders";
}

TEST(Languages, ImportInNoCircle) {
  EXPECT_THAT(circles(files_below("src/client/python", {".py"})), IsEmpty());
  EXPECT_THAT(circles(files_below("src/client/javascript", {".js"})), IsEmpty());
}

TEST(Languages, ImportsAreFound) {
  EXPECT_THAT(imports({"a/b/c.py", {"from ..d.e import F", "    from .g import H", "from . import i, j", "import os"}}),
              ElementsAre("a/d/e", "a/b/g", "a/b/i", "a/b/j"));
  EXPECT_THAT(imports({"a/b/c.js", {"import { X } from '../d/e.js';", "import fs from 'node:fs';"}}),
              ElementsAre("a/d/e"));
  EXPECT_THAT(imports({"A.java", {"import geminga.protocol.Frame;", "import java.util.List;"}}),
              ElementsAre("src/client/java/geminga/protocol/Frame"));
}

TEST(Languages, ForbiddenImportsAndCirclesAreFound) {
  EXPECT_THAT(forbidden_imports({"src/client/python/geminga/protocol/a.py", {"from ..channels.b import C"}}),
              SizeIs(1));
  EXPECT_THAT(forbidden_imports({"src/client/python/geminga/channels/a.py", {"from ..node import Node"}}), SizeIs(1));
  EXPECT_THAT(forbidden_imports({"src/client/python/geminga/channels/a.py", {"from ..protocol.b import C"}}),
              IsEmpty());
  EXPECT_THAT(forbidden_imports({"src/client/java/geminga/channels/A.java", {"import geminga.Publisher;"}}), SizeIs(1));
  EXPECT_THAT(circles({{"a/b.py", {"from .c import C"}}, {"a/c.py", {"from .b import B"}}}), SizeIs(1));
  EXPECT_THAT(circles({{"a/b.py", {"from .c import C"}}, {"a/c.py", {"from .d import D"}}, {"a/d.py", {}}}), IsEmpty());
}

}  // namespace
}  // namespace geminga::law
