// A program or shared library of ELF64 in this machine's byte order, as far as its hardening shows in it.
#ifndef GEMINGA_TESTS_HARDENING_LINKED_FILE_HPP
#define GEMINGA_TESTS_HARDENING_LINKED_FILE_HPP

#include <elf.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::hardening {

/// A function that is defined in the file, with its instructions.
struct Function {
  std::string_view name;
  std::string_view code;
  bool is_global = false;
};

class LinkedFile {
 public:
  /// Reads the file. Nothing where it is no such file.
  static std::optional<LinkedFile> read(const std::string& path);

  [[nodiscard]] const Elf64_Ehdr& header() const { return header_; }
  /// The first segment of this type, or nothing.
  [[nodiscard]] std::optional<Elf64_Phdr> segment(std::uint32_t type) const;
  /// The value of this tag of the dynamic section, or nothing.
  [[nodiscard]] std::optional<std::uint64_t> dynamic(std::int64_t tag) const;
  /// The functions that it takes from other files.
  [[nodiscard]] std::set<std::string_view> imported() const;
  /// The functions of its symbol table.
  [[nodiscard]] std::vector<Function> functions() const;
  /// The property GNU_PROPERTY_X86_FEATURE_1_AND; 0 where there is none.
  [[nodiscard]] std::uint32_t x86_features() const;

 private:
  template <typename Record>
  [[nodiscard]] std::vector<Record> records(std::uint64_t offset, std::uint64_t count) const;
  [[nodiscard]] std::vector<Elf64_Shdr> sections() const;

  std::string bytes_;
  Elf64_Ehdr header_{};
};

}  // namespace geminga::hardening

#endif
