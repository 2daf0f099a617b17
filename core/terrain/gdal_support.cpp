#include "core/terrain/gdal_support.h"

#include <mutex>

#include <cpl_error.h>
#include <gdal.h>

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
  return text_.empty() ? std::string() : " (GDAL: " + text_ + ")";
}

}  // namespace vp::terrain::detail
