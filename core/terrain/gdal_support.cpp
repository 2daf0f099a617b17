#include "core/terrain/gdal_support.h"

#include <cpl_error.h>
#include <gdal.h>

#include <cstddef>
#include <mutex>

namespace vp::terrain::detail {
namespace {

void registerDriversOnce() {
  static std::once_flag once;
  std::call_once(once, [] { GDALAllRegister(); });
}

void CPL_STDCALL onMessage(CPLErr severity, CPLErrorNum /*number*/, const char* message) {
  if (severity == CE_Failure || severity == CE_Fatal) {
    static_cast<GdalMessages*>(CPLGetErrorHandlerUserData())->take(message);
  }
}

}  // namespace

GdalMessages::GdalMessages() {
  registerDriversOnce();
  CPLPushErrorHandlerEx(&onMessage, this);
}

GdalMessages::~GdalMessages() {
  CPLPopErrorHandler();
  CPLErrorReset();
}

void GdalMessages::take(const char* message) {
  text_.clear();
  for (const char* c = message; *c != '\0'; ++c) {
    text_.push_back(*c == '\n' || *c == '\r' || *c == '\t' ? ' ' : *c);
  }
  while (!text_.empty() && (text_.back() == '.' || text_.back() == ' ')) {
    text_.pop_back();
  }
}

std::string GdalMessages::inBrackets() const {
  constexpr std::size_t kMost = 200;  // some of PROJ's messages quote whole coordinate systems
  if (text_.empty()) {
    return {};
  }
  return " (GDAL: " + (text_.size() > kMost ? text_.substr(0, kMost) + "..." : text_) + ")";
}

}  // namespace vp::terrain::detail
