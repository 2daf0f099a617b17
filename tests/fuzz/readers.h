#pragma once
// The readers of files from outside, as the fuzz targets and tst_found_inputs drive them.

#include "core/base/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vp::fuzz {

/** What a reader made of a file. */
struct Outcome {
  std::optional<Error> error;  ///< it refused the file
  std::string complaint;       ///< it broke its promise, and how; "" = it kept it
};

/** One reader with what it needs to be tried on any bytes. */
struct Reader {
  const char* name;                            ///< of the target, and of its folders in found/ and seeds/
  const char* ending;                          ///< of the file's name, as users have it
  Outcome (*read)(const std::string& path);    ///< reads, and looks at what comes out: finite, in range, readable again where it can be written
  std::size_t longest = std::size_t{1} << 16;  ///< bytes of an input that are worth trying
};

const std::vector<Reader>& readers();

/** The reader of this name, or nothing. */
const Reader* readerOf(std::string_view name);

/** What an error must be like whatever the file held: one sentence of less than 2000 bytes in UTF-8 without control characters that begins with
 *  the file. "" if it is. */
std::string faultOf(const Error& error, const std::string& path);

/** A file in a folder of its own, in memory where there is such a file system; rewritten for each input, removed at the end. */
class InputFile {
public:
  explicit InputFile(const Reader& reader);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /** Reads these bytes; an input that is not worth trying gives an empty outcome. */
  Outcome read(std::string_view bytes);

private:
  const Reader* reader_;
  std::string folder_;
  std::string path_;
};

}  // namespace vp::fuzz
