#pragma once

#include <string>

namespace vp::cli {

/** What the commands print with --json. @param value  a JSON value of the library; a template, because the library stays out of headers.
 *  @return indented text with a newline at its end; bytes that are no UTF-8 are replaced */
template <typename Json>
std::string jsonText(const Json& value) {
  return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace vp::cli
