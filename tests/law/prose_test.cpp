// The parts of plain English that a program can count: lines of documents, openings of comments, numbers that the code
// knows, and the length of the documents that a newcomer reads first.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "client/protocol/limits.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/gcnp/limits.hpp"
#include "env/env.hpp"
#include "law/source_tree.hpp"

namespace geminga::law {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr std::size_t max_columns = 160;

/// The number of code points of a UTF-8 text.
std::size_t columns(const std::string& line) {
  return static_cast<std::size_t>(std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; }));
}

bool is_table_row(const std::string& line) { return line.starts_with('|'); }

/// The lines of a document that are too long to be read. Rows of tables and examples of code cannot be wrapped.
std::vector<std::string> long_lines(const SourceFile& document) {
  std::vector<std::string> found;
  bool is_code = false;
  for (std::size_t at = 0; at < document.lines.size(); ++at) {
    const std::string& line = document.lines[at];
    if (line.starts_with("```")) is_code = !is_code;
    if (!is_code && !is_table_row(line) && columns(line) > max_columns)
      found.push_back(document.path + ':' + std::to_string(at + 1) + ": has over 160 columns");
  }
  return found;
}

/// The comments that do not begin with a noun or a verb. Only the first line of a comment opens it; a comment behind
/// code (`///<`) opens on its line.
std::vector<std::string> riddles(const SourceFile& file) {
  static const std::regex any_comment(R"(^\s*(//|/?\*|#))");
  static const std::regex opening(
      R"rx((//[/!]?<?|^\s*/?\*+|^\s*#|^\s*[rf]?""")\s*(Who|What|Whom|Whose|who|what|whom|whose)\b)rx");
  std::vector<std::string> found;
  bool is_inside = false;  // of a comment that has been opened
  for (std::size_t at = 0; at < file.lines.size(); ++at) {
    const std::string& line = file.lines[at];
    std::smatch match;
    const bool may_open = line.contains("//") || line.contains("/*") || line.contains('*') || line.contains('#') ||
                          line.contains("\"\"\"");
    const bool is_comment = may_open && std::regex_search(line, any_comment);
    if (!is_inside && may_open && std::regex_search(line, match, opening)) {
      const bool is_lower = std::islower(static_cast<unsigned char>(match[2].str().front())) != 0;
      const std::string before = match.prefix();
      // `///< what ...` explains a member; other small letters are code or the middle of a sentence.
      if (!is_lower || match[1].str().ends_with('<'))
        found.push_back(file.path + ':' + std::to_string(at + 1) + ": begins with " + match[2].str());
    }
    // A block comment is open behind `/**` alone; its first line with text is the opening.
    is_inside = is_comment && !line.ends_with("/**");
  }
  return found;
}

TEST(Prose, OfDocumentsFitsOnAScreen) {
  std::vector<SourceFile> documents = files_below("", {".md"});
  ASSERT_GE(documents.size(), 30U);
  for (const SourceFile& document : documents) {
    EXPECT_THAT(long_lines(document), IsEmpty());
  }
}

TEST(Prose, OfCommentsBeginsWithANounOrAVerb) {
  for (const SourceFile& file : all_sources()) {
    if (file.path.ends_with("prose_test.cpp")) continue;  // it shows what it looks for
    EXPECT_THAT(riddles(file), IsEmpty());
  }
}

TEST(Prose, OfBuildFilesCasesAndTranscriptsBeginsSo) {
  const std::vector<SourceFile> cases = files_below("tests", {".ttl", ".txt"});
  ASSERT_GE(cases.size(), 100U);
  for (const SourceFile& file : cases) EXPECT_THAT(riddles(file), IsEmpty());
  for (const SourceFile& file : files_below("", {"CMakeLists.txt", ".cmake"})) EXPECT_THAT(riddles(file), IsEmpty());
}

TEST(Prose, OfTheFirstDocumentsIsShort) {
  const std::map<std::string, std::size_t> most = {{"README.md", 130}, {"ARCHITECTURE.md", 160}};
  for (const SourceFile& document : files_below("", {"README.md", "ARCHITECTURE.md"})) {
    const auto limit = most.find(document.path);
    if (limit == most.end()) continue;
    EXPECT_LE(document.lines.size(), limit->second) << document.path;
  }
}

/// A sentence of a document with a number that the code knows, too.
struct StatedNumber {
  const char* document;
  std::string sentence;
};

TEST(Prose, StatesTheNumbersOfTheCode) {
  const auto text = [](std::size_t number) { return std::to_string(number); };
  const std::string announcement = "src/discovery/announcement/ANNOUNCEMENT.md";
  const std::vector<StatedNumber> all = {
      {"src/discovery/gcnp/GCNP.md", text(gcnp::max_concept_bytes) + " octets each; an expression " +
                                         text(announcement::max_expression_bytes) + " in canonical form"},
      {"src/discovery/gcnp/GCNP.md", text(announcement::max_entry_bytes) + " octets (" + announcement},
      {"src/discovery/gcnp/GCNP.md", "all, which are at most " + text(announcement::max_services_per_participant)},
      {announcement.c_str(), "at most **" + text(announcement::max_entry_bytes) + " octets** of a datagram"},
      {announcement.c_str(), "at most " + text(announcement::max_parts) + " parts"},
      {announcement.c_str(), "keeps at most " + text(announcement::max_participants) + " participants"},
      {announcement.c_str(), "It keeps " + text(announcement::reserved_services) + " services of each participant"},
      {announcement.c_str(), "and " + text(announcement::max_remote_services) + " of all beyond those"},
      {announcement.c_str(), "at most " + text(announcement::max_paths) + " ways"},
      {"src/discovery/sealing/SEALING.md", "The envelope takes " + text(env::max_envelope_bytes) +
                                               " octets and an announcement at most " +
                                               text(announcement::max_datagram_bytes)},
      {"src/discovery/sealing/SEALING.md", "at most " + text(env::max_datagram_bytes) + " octets"},
      {"src/client/CHANNELS.md", "| " + text(client::max_listeners) + " |"},
      {"src/client/CHANNELS.md", "| " + text(client::max_waiting_messages) + " and "},
      {"src/client/CHANNELS.md", "| " + text(client::max_tcp_consumers) + " |"},
  };
  for (const StatedNumber& one : all) {
    const auto documents = files_below("", {std::filesystem::path(one.document).filename().string()});
    const auto document = std::ranges::find(documents, one.document, &SourceFile::path);
    ASSERT_NE(document, documents.end()) << one.document;
    std::string whole;
    for (const std::string& line : document->lines) whole += line + ' ';
    EXPECT_THAT(whole, testing::HasSubstr(one.sentence)) << one.document;
  }
}

TEST(Prose, FindsWhatItLooksFor) {
  EXPECT_THAT(long_lines({"a.md", {std::string(161, 'x'), std::string(160, 'x'), '|' + std::string(200, 'x')}}),
              SizeIs(1));
  EXPECT_THAT(riddles({"a.hpp", {"/// What is there.", "/// Who knows."}}), SizeIs(1));
  EXPECT_THAT(riddles({"a.hpp", {"/// The list of", "/// What is never an opening here."}}), IsEmpty());
  EXPECT_THAT(riddles({"a.hpp", {"  int a;  ///< whose it is", "  int b;  ///< the owner"}}), SizeIs(1));
  EXPECT_THAT(riddles({"a.py", {"  \"\"\"Whom to ask.\"\"\"", "# What follows."}}), SizeIs(2));
  EXPECT_THAT(riddles({"A.java", {"  /** Who asks. */", "  /**", "   * What is asked.", "   */"}}), SizeIs(2));
  EXPECT_THAT(riddles({"a.js", {"  what = 1;  // what is meant"}}), IsEmpty());
}

}  // namespace
}  // namespace geminga::law
