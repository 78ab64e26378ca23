// A folder of files for a daemon, and a small ontology for it.
#ifndef GEMINGA_TESTS_SYSTEM_FOLDER_HPP
#define GEMINGA_TESTS_SYSTEM_FOLDER_HPP

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "support/process.hpp"

namespace geminga::system {

/// A folder for the files of one test, removed with it.
class Folder {
 public:
  Folder() {
    std::string path = std::filesystem::temp_directory_path() / "geminga-test-XXXXXX";
    if (::mkdtemp(path.data()) != nullptr) path_ = path;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

inline constexpr const char* animals = R"(@prefix : <http://zoo.example/#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
<http://zoo.example/> a owl:Ontology .
:Animal a owl:Class .
:Cat a owl:Class ; rdfs:subClassOf :Animal .
)";

inline std::string shipped(const std::string& name) { return std::string(GEMINGA_SOURCE_DIR) + "/ontology/" + name; }

/// Runs a gemingad that is to end by itself.
inline Ran refused(const std::vector<std::string>& flags, std::map<std::string, std::string> environment = {}) {
  std::vector<std::string> words{program("gemingad")};
  words.insert(words.end(), flags.begin(), flags.end());
  return run({.words = words, .environment = std::move(environment), .before = {}});
}

}  // namespace geminga::system

#endif
