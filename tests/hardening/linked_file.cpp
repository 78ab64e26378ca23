#include "hardening/linked_file.hpp"

#include <cstring>
#include <fstream>
#include <iterator>

namespace geminga::hardening {

std::optional<LinkedFile> LinkedFile::read(const std::string& path) {
  LinkedFile file;
  std::ifstream stream(path, std::ios::binary);
  file.bytes_.assign(std::istreambuf_iterator<char>(stream), {});
  if (file.bytes_.size() < sizeof(Elf64_Ehdr) || !file.bytes_.starts_with(ELFMAG)) return std::nullopt;
  std::memcpy(&file.header_, file.bytes_.data(), sizeof file.header_);
  if (file.header_.e_ident[EI_CLASS] != ELFCLASS64) return std::nullopt;
  return file;
}

template <typename Record>
std::vector<Record> LinkedFile::records(std::uint64_t offset, std::uint64_t count) const {
  std::vector<Record> all(offset + count * sizeof(Record) <= bytes_.size() ? count : 0);
  if (!all.empty()) std::memcpy(all.data(), bytes_.data() + offset, all.size() * sizeof(Record));
  return all;
}

std::optional<Elf64_Phdr> LinkedFile::segment(std::uint32_t type) const {
  for (const auto& one : records<Elf64_Phdr>(header_.e_phoff, header_.e_phnum)) {
    if (one.p_type == type) return one;
  }
  return std::nullopt;
}

std::optional<std::uint64_t> LinkedFile::dynamic(std::int64_t tag) const {
  const auto section = segment(PT_DYNAMIC);
  if (!section) return std::nullopt;
  for (const auto& entry : records<Elf64_Dyn>(section->p_offset, section->p_filesz / sizeof(Elf64_Dyn))) {
    if (entry.d_tag == tag) return entry.d_un.d_val;
  }
  return std::nullopt;
}

std::vector<Elf64_Shdr> LinkedFile::sections() const { return records<Elf64_Shdr>(header_.e_shoff, header_.e_shnum); }

std::set<std::string_view> LinkedFile::imported() const {
  std::set<std::string_view> names;
  const auto all = sections();
  for (const Elf64_Shdr& section : all) {
    if (section.sh_type != SHT_DYNSYM) continue;
    for (const auto& symbol : records<Elf64_Sym>(section.sh_offset, section.sh_size / sizeof(Elf64_Sym))) {
      if (symbol.st_shndx == SHN_UNDEF)
        names.insert(bytes_.data() + all.at(section.sh_link).sh_offset + symbol.st_name);
    }
  }
  return names;
}

std::vector<Function> LinkedFile::functions() const {
  std::vector<Function> found;
  const auto all = sections();
  for (const Elf64_Shdr& section : all) {
    if (section.sh_type != SHT_SYMTAB) continue;
    for (const auto& symbol : records<Elf64_Sym>(section.sh_offset, section.sh_size / sizeof(Elf64_Sym))) {
      if (ELF64_ST_TYPE(symbol.st_info) != STT_FUNC || symbol.st_size == 0 || symbol.st_shndx == SHN_UNDEF ||
          symbol.st_shndx >= all.size())
        continue;
      const Elf64_Shdr& home = all[symbol.st_shndx];
      found.push_back(
          {bytes_.data() + all.at(section.sh_link).sh_offset + symbol.st_name,
           std::string_view(bytes_).substr(symbol.st_value - home.sh_addr + home.sh_offset, symbol.st_size),
           ELF64_ST_BIND(symbol.st_info) != STB_LOCAL && ELF64_ST_VISIBILITY(symbol.st_other) == STV_DEFAULT});
    }
  }
  return found;
}

std::uint32_t LinkedFile::x86_features() const {
  const auto note = segment(PT_GNU_PROPERTY);
  if (!note) return 0;
  // The note's header, its name "GNU", then properties: a type, a length, and octets up to a multiple of 8.
  const auto words = records<std::uint32_t>(note->p_offset, note->p_filesz / sizeof(std::uint32_t));
  for (std::size_t at = 4; at + 2 < words.size();) {
    if (words[at] == GNU_PROPERTY_X86_FEATURE_1_AND) return words[at + 2];
    at += 2 + (words[at + 1] + 7) / 8 * 2;
  }
  return 0;
}

}  // namespace geminga::hardening
