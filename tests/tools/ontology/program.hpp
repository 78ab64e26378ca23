// Runs geminga-ontology as a process in a folder of the test.
#ifndef GEMINGA_TESTS_TOOLS_ONTOLOGY_PROGRAM_HPP
#define GEMINGA_TESTS_TOOLS_ONTOLOGY_PROGRAM_HPP

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::ontology {

/// The output and the exit status of one run.
struct Outcome {
  int status = -1;  ///< -1: it did not end by itself
  std::string out;
  std::string err;
};

class Program {
 public:
  Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  /// Runs `geminga-ontology arguments...` in the folder, with an empty standard input.
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const;
  /// Writes a file into the folder.
  void write(const std::string& name, std::string_view content) const;
  /// Writes a Turtle file with the usual prefixes before its content, all on the first line; `:` is http://e/.
  void turtle(const std::string& name, std::string_view content) const;
  [[nodiscard]] std::string read(const std::string& name) const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// The ontologies that ship.
[[nodiscard]] std::string shipped();

}  // namespace geminga::ontology

#endif
