#pragma once

#include <string>

namespace vp::terrain::detail {

/** Catches what GDAL and PROJ say on this thread while it lives, so that nothing spills on stderr and the words can go
 *  into our own sentence. Registers GDAL's drivers on first use. Objects must end in reverse order of their making. */
class GdalMessages {
public:
  GdalMessages();
  ~GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  /** The last error as one line, without the final stop; empty if there was none. */
  [[nodiscard]] const std::string& text() const { return text_; }
  /** " (GDAL: the last error)" for the end of a sentence; empty if there was none. */
  [[nodiscard]] std::string inBrackets() const;
  void clear() { text_.clear(); }
  void take(const char* message);

private:
  std::string text_;
};

}  // namespace vp::terrain::detail
