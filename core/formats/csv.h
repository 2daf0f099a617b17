#pragma once

#include "core/base/result.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace vp::formats {

struct CsvRecord {
  std::size_t row = 1;  ///< line of the file that the record begins on, from 1
  std::vector<std::string> fields;
};

/** How quotes are taken. */
enum class CsvQuotes {
  Strict,   ///< RFC 4180: a quoted field may span lines, a quote inside is doubled
  Lenient,  ///< SeeYou: a record is a line; a quote that no comma follows belongs to the text; spaces around fields are dropped
};

/** Walks the records of a CSV text (LF, CRLF or CR line ends), leaving out empty lines. A quote that is never closed ends
 *  the reading where it stands, however long the text. */
class CsvReader {
public:
  CsvReader(std::string_view text, std::string file, CsvQuotes quotes, char separator = ',')
      : text_(text), file_(std::move(file)), quotes_(quotes), separator_(separator), fieldEnds_{separator, '\r', '\n'} {}

  /** Reads the next record. @return false at the end of the text
   *  @errors BadFormat - an open quote or text after a closing quote; names file, row and column */
  Result<bool> next(CsvRecord& record);

  /** The rest of the line that the next record begins on, as it is. */
  [[nodiscard]] std::string_view peekLine() const;

private:
  Result<void> readQuoted(std::string& field, std::size_t row, std::size_t column);
  void skipLineEnd();
  [[nodiscard]] bool atLineEnd() const { return at_ >= text_.size() || text_[at_] == '\n' || text_[at_] == '\r'; }
  [[nodiscard]] bool isDoubledQuote() const;
  [[nodiscard]] bool closesField(std::size_t quote) const;
  tl::unexpected<Error> fault(std::string what, std::size_t row, std::size_t column) const;

  std::string_view text_;
  std::string file_;
  CsvQuotes quotes_;
  char separator_;
  std::array<char, 3> fieldEnds_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

/** "FILE, row R, column C (NAME)" as errors name a place; column from 1. */
std::string csvPlace(const std::string& file, std::size_t row, std::size_t column, const std::string& name);

/** Columns of a CSV by the names in its first record (case and surrounding spaces do not matter). */
class CsvColumns {
public:
  CsvColumns(std::string file, const CsvRecord& header);

  /** Place of the first of these names that the header has, or -1. */
  [[nodiscard]] int find(const std::vector<std::string>& names) const;
  /** The same, recording an error if none is there. */
  int require(const std::string& name);
  [[nodiscard]] const std::string& missing() const { return missing_; }

private:
  std::string file_;
  std::vector<std::string> names_;
  std::string missing_;
};

/** The field in a column with spaces around it dropped; "" if the record is shorter or the column is -1. */
std::string_view fieldOf(const CsvRecord& record, int column);

std::string_view trimmed(std::string_view text);

}  // namespace vp::formats
