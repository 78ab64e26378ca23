// The published specification of the paper's team, read from the data beside the project, and which pairs it means.
#ifndef GEMINGA_TESTS_SIM_SPECIFICATION_HPP
#define GEMINGA_TESTS_SIM_SPECIFICATION_HPP

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace geminga::sim {

/// One of the hosts and modules that a row names as its counterparts.
struct Counterpart {
  std::string host;  ///< localhost, any, or a group
  std::string module;
  bool is_excluded = false;
};

/// A publication or subscription of one module.
struct SpecificationRow {
  std::string module;
  bool is_publication = false;
  std::string message;
  std::vector<Counterpart> counterparts;
};

/// carpe-noctem/modules.tsv of $GEMINGA_TEST_DATA or of ../shared/data; nothing where neither is there.
[[nodiscard]] std::optional<std::filesystem::path> specification_file();
[[nodiscard]] std::vector<SpecificationRow> read_specification(const std::filesystem::path& file);

/// A host of the team, and what runs there.
struct Post {
  std::string name;  ///< ends in the groups it is in, each behind a `-`
  std::vector<std::string> modules;
};

/// Whether a row on one host names a module on another one.
[[nodiscard]] bool names(const SpecificationRow& row, const Post& own, const Post& other, const std::string& module);

/// Whether two messages are the same; `is_mended`: also where the specification has slips of the pen.
[[nodiscard]] bool is_same_message(const std::string& published, const std::string& wanted, bool is_mended);

}  // namespace geminga::sim

#endif
