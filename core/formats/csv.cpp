#include "core/formats/csv.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::formats {
namespace {

bool isBlank(char c) {
  return c == ' ' || c == '\t';
}

std::string lowered(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return out;
}

}  // namespace

std::string csvPlace(const std::string& file, std::size_t row, std::size_t column, const std::string& name) {
  return name.empty() ? fmt::format("{}, row {}, column {}", file, row, column) : fmt::format("{}, row {}, column {} ({})", file, row, column, name);
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && isBlank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

tl::unexpected<Error> CsvReader::fault(std::string what, std::size_t row, std::size_t column) const {
  return fail(Errc::BadFormat, std::move(what), csvPlace(file_, row, column, {}));
}

void CsvReader::skipLineEnd() {
  if (at_ < text_.size()) {
    at_ += text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n' ? 2 : 1;
    ++line_;
  }
}

std::string_view CsvReader::peekLine() const {
  return text_.substr(at_, text_.find_first_of("\r\n", at_) - at_);
}

/// Whether the quote at this place ends its field: only blanks follow up to a comma or the end of the line.
bool CsvReader::closesField(std::size_t quote) const {
  std::size_t next = quote + 1;
  while (next < text_.size() && isBlank(text_[next]) && text_[next] != separator_) {
    ++next;
  }
  return next >= text_.size() || text_[next] == separator_ || text_[next] == '\n' || text_[next] == '\r';
}

/// Two quotes that stand for one. In SeeYou files a pair before the end of the line is a quote of the text and the end of the field.
bool CsvReader::isDoubledQuote() const {
  if (text_[at_] != '"' || at_ + 1 >= text_.size() || text_[at_ + 1] != '"') {
    return false;
  }
  const bool endsLine = at_ + 2 >= text_.size() || text_[at_ + 2] == '\n' || text_[at_ + 2] == '\r';
  return quotes_ == CsvQuotes::Strict || !endsLine;
}

Result<void> CsvReader::readQuoted(std::string& field, std::size_t row, std::size_t column) {
  ++at_;
  for (;;) {
    if (at_ >= text_.size() || (quotes_ == CsvQuotes::Lenient && atLineEnd())) {
      return fault("a quote is opened here and never closed; add the closing quote", row, column);
    }
    const char c = text_[at_];
    if (isDoubledQuote()) {
      field += '"';
      at_ += 2;
    } else if (c == '"' && (quotes_ == CsvQuotes::Strict || closesField(at_))) {
      ++at_;
      break;
    } else if (atLineEnd()) {
      field += '\n';
      skipLineEnd();
    } else {
      field += c;
      ++at_;
    }
  }
  while (at_ < text_.size() && isBlank(text_[at_]) && text_[at_] != separator_) {
    ++at_;
  }
  if (!atLineEnd() && text_[at_] != separator_) {
    return fault("text follows a closing quote; double the quotes inside a field or add the missing comma", row, column);
  }
  return {};
}

Result<bool> CsvReader::next(CsvRecord& record) {
  record.fields.clear();
  while (at_ < text_.size() && atLineEnd()) {
    skipLineEnd();
  }
  if (at_ >= text_.size()) {
    return false;
  }
  record.row = line_;
  for (;;) {
    std::string& field = record.fields.emplace_back();
    if (quotes_ == CsvQuotes::Lenient) {
      while (at_ < text_.size() && isBlank(text_[at_]) && text_[at_] != separator_) {
        ++at_;
      }
    }
    if (at_ < text_.size() && text_[at_] == '"') {
      if (const Result<void> read = readQuoted(field, line_, record.fields.size()); !read) {
        return forward(read);
      }
    } else {
      const std::size_t end = std::min(text_.find_first_of(std::string_view(fieldEnds_.data(), fieldEnds_.size()), at_), text_.size());
      field = text_.substr(at_, end - at_);
      at_ = end;
    }
    if (atLineEnd()) {
      skipLineEnd();
      return true;
    }
    ++at_;  // the separator
  }
}

CsvColumns::CsvColumns(std::string file, const CsvRecord& header) : file_(std::move(file)) {
  for (const std::string& field : header.fields) {
    names_.push_back(lowered(trimmed(field)));
  }
}

int CsvColumns::find(const std::vector<std::string>& names) const {
  for (const std::string& name : names) {
    const auto place = std::find(names_.begin(), names_.end(), lowered(name));
    if (place != names_.end()) {
      return static_cast<int>(place - names_.begin());
    }
  }
  return -1;
}

int CsvColumns::require(const std::string& name) {
  const int place = find({name});
  if (place < 0 && missing_.empty()) {
    missing_ = name;
  }
  return place;
}

std::string_view fieldOf(const CsvRecord& record, int column) {
  const auto place = static_cast<std::size_t>(column);
  return column >= 0 && place < record.fields.size() ? trimmed(record.fields[place]) : std::string_view();
}

}  // namespace vp::formats
