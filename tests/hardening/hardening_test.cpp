// The hardening of every program and of libgeminga.so, read from the files themselves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "hardening/linked_file.hpp"

namespace geminga::hardening {
namespace {

using testing::Contains;
using testing::IsEmpty;

constexpr std::string_view endbr64 = "\xf3\x0f\x1e\xfa";
constexpr std::string_view probe = {"\x48\x83\x0c\x24\x00", 5};  // orq $0, (%rsp)
constexpr std::string_view subtraction = {"\x48\x81\xec", 3};    // sub $imm32, %rsp
constexpr std::uint32_t page_bytes = 4096;
/// The octets of a function in which it makes room for its variables.
constexpr std::size_t prologue_bytes = 64;

std::vector<std::string> linked_files() {
  std::vector<std::string> paths;
  std::ifstream list(GEMINGA_LINKED);
  for (std::string line; std::getline(list, line);) paths.push_back(line);
  return paths;
}

struct Hardening : testing::TestWithParam<std::string> {
  void SetUp() override { ASSERT_TRUE(file) << GetParam() << " is no program of this machine"; }
  [[nodiscard]] bool is_library() const { return GetParam().find("libgeminga.so") != std::string::npos; }
  [[nodiscard]] bool is_x86() const { return file->header().e_machine == EM_X86_64; }

  std::optional<LinkedFile> file = LinkedFile::read(GetParam());
};

TEST_P(Hardening, LoadsAtAnyAddress) {
  EXPECT_EQ(file->header().e_type, ET_DYN);
  EXPECT_EQ(file->segment(PT_INTERP).has_value(), !is_library());
  if (!is_library()) {
    EXPECT_NE(file->dynamic(DT_FLAGS_1).value_or(0) & DF_1_PIE, 0U);
  }
  EXPECT_FALSE(file->dynamic(DT_TEXTREL));
}

TEST_P(Hardening, HasAReadOnlyTableOfAddressesAndNoExecutableStack) {
  EXPECT_TRUE(file->segment(PT_GNU_RELRO));
  EXPECT_NE(file->dynamic(DT_FLAGS).value_or(0) & DF_BIND_NOW, 0U);
  EXPECT_NE(file->dynamic(DT_FLAGS_1).value_or(0) & DF_1_NOW, 0U);
  const auto stack = file->segment(PT_GNU_STACK);
  ASSERT_TRUE(stack);
  EXPECT_EQ(stack->p_flags & PF_X, 0U);
}

TEST_P(Hardening, ChecksItsStackAndItsBuffers) {
  const auto imported = file->imported();
  EXPECT_THAT(imported, Contains("__stack_chk_fail"));
  const bool has_checks = std::ranges::any_of(
      imported, [](std::string_view name) { return name.starts_with("__") && name.ends_with("_chk"); });
  if (GEMINGA_IS_FORTIFIED) {
    EXPECT_TRUE(has_checks) << "no function of FORTIFY";
  }
}

TEST_P(Hardening, SkipsNoPageOfItsStack) {
  if (!is_x86()) return;
  std::vector<std::string_view> skipping;
  for (const Function& function : file->functions()) {
    const std::string_view prologue = function.code.substr(0, prologue_bytes);
    for (auto at = prologue.find(subtraction); at != std::string_view::npos; at = prologue.find(subtraction, at + 1)) {
      std::uint32_t room = 0;
      if (at + subtraction.size() + sizeof room > prologue.size()) break;
      std::memcpy(&room, prologue.data() + at + subtraction.size(), sizeof room);
      if (room > page_bytes) skipping.push_back(function.name);
    }
  }
  EXPECT_THAT(skipping, IsEmpty());
}

TEST_P(Hardening, MarksTheTargetsOfIndirectBranches) {
  if (!is_x86()) return;
  constexpr std::uint32_t shadow_stack = GNU_PROPERTY_X86_FEATURE_1_SHSTK;
  EXPECT_NE(file->x86_features() & shadow_stack, 0U);
  std::vector<std::string_view> unmarked;
  for (const Function& function : file->functions()) {
    const bool is_of_the_c_runtime = function.name == "_start" || function.name == "_init" || function.name == "_fini";
    if (function.is_global && !is_of_the_c_runtime && !function.code.starts_with(endbr64))
      unmarked.push_back(function.name);
  }
  EXPECT_THAT(unmarked, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Of, Hardening, testing::ValuesIn(linked_files()), [](const auto& test) {
  std::string name = std::filesystem::path(test.param).filename().string();
  std::ranges::replace_if(name, [](char c) { return c == '-' || c == '.'; }, '_');
  return name;
});

TEST(HardeningOfAll, IsReadFromEveryProgramAndTheLibrary) {
  std::vector<std::string> names;
  for (const std::string& path : linked_files()) names.push_back(std::filesystem::path(path).filename().string());
  for (const char* name : {"gemingad", "geminga-ontology", "geminga-publish", "geminga-query", "geminga-subscribe",
                           "geminga-unseal", "geminga-web", "geminga-bridge", "libgeminga.so.1.0.0"})
    EXPECT_THAT(names, Contains(name));
}

TEST(HardeningOfAll, ProbesEachPageOfALargeFrame) {
  for (const std::string& path : linked_files()) {
    const auto file = LinkedFile::read(path);
    if (!path.ends_with("/gemingad") || file->header().e_machine != EM_X86_64) continue;
    EXPECT_TRUE(std::ranges::any_of(file->functions(), [](const Function& function) {
      return function.code.find(probe) != std::string_view::npos;
    }));
  }
}

}  // namespace
}  // namespace geminga::hardening
