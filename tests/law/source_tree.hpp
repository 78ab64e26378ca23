// The project's own files as the law tests see them.
#ifndef GEMINGA_TESTS_LAW_SOURCE_TREE_HPP
#define GEMINGA_TESTS_LAW_SOURCE_TREE_HPP

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::law {

/// One source file with its path relative to the project's root.
struct SourceFile {
  std::string path;
  std::vector<std::string> lines;
};

/// Every file below a folder of the project whose name ends with one of the endings, sorted by path. "" is the root;
/// builds and hidden folders are left out.
[[nodiscard]] std::vector<SourceFile> files_below(std::string_view folder, const std::vector<std::string>& endings);

/// Every .hpp, .cpp and .h below a folder of the project, sorted by path.
[[nodiscard]] std::vector<SourceFile> source_files(std::string_view folder);

/// Every source of the project in any of its languages: C++, C, Python, Java and JavaScript.
[[nodiscard]] std::vector<SourceFile> all_sources();

/// The modules of src/ and tools/ and what each names in DEPENDS, as the CMakeLists.txt files say it. A program is the
/// module of its folder, as in "tools/query"; names of modules in src/ are below src/.
using Law = std::map<std::string, std::set<std::string>, std::less<>>;
[[nodiscard]] Law read_law();

/// The module of the law that a path such as "env/asio/streams.hpp" or "tools/shell/json.hpp" belongs to, or "".
[[nodiscard]] std::string module_of(const Law& law, std::string_view path);

/// The includes of a file that break the law, one message each.
[[nodiscard]] std::vector<std::string> violations(const Law& law, const SourceFile& file);

}  // namespace geminga::law

#endif
