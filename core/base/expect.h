#pragma once

#include <stdexcept>
#include <string>

namespace vp {

/** A bug in this program. Stops the job that met it, never the process. */
class LogicError : public std::logic_error {
public:
  using std::logic_error::logic_error;
};

[[noreturn]] inline void throwLogicError(const char* condition, const char* file, int line) {
  throw LogicError(std::string("internal error: expected ") + condition + " at " + file + ":" + std::to_string(line));
}

}  // namespace vp

/** States what must hold if the code is right. Never compiled out. */
#define VP_EXPECT(cond) ((cond) ? static_cast<void>(0) : ::vp::throwLogicError(#cond, __FILE__, __LINE__))
