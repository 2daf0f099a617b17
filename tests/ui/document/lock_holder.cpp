// A process that has a mission open until it is killed.
#include "ui/document/document_lock.h"

#include <QCoreApplication>

#include <cstdio>
#include <unistd.h>

int main(int argc, char** argv) {
  QCoreApplication app(argc, argv);
  vp::document::DocumentLock lock;
  std::puts(lock.take(QString::fromLocal8Bit(argv[1])) == vp::document::DocumentLock::Outcome::Held ? "held" : "not held");
  std::fflush(stdout);
  for (;;) {
    ::pause();
  }
}
