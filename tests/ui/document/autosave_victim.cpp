// A process that keeps unsaved work and is killed while it does: writes ever new copies until then.
#include "ui/document/autosave.h"
#include "ui/document/mission_document.h"

#include <QCoreApplication>

#include <cstdio>

int main(int argc, char** argv) {
  QCoreApplication app(argc, argv);
  vp::document::Autosave autosave(QString::fromLocal8Bit(argv[1]));
  vp::document::MissionDocument document;
  for (int i = 1;; ++i) {
    document.edit(QStringLiteral("Add"), [i](vp::mission::Mission& m) {
      m.name = "work of the victim";
      m.targets.assign(50, {});
      for (std::size_t t = 0; t < m.targets.size(); ++t) {
        m.targets[t].name = std::to_string(i) + "." + std::to_string(t);
      }
    });
    if (!autosave.write(vp::document::MissionDocument::recoveryData(document.snapshot()))) {
      return 1;
    }
    if (i == 1) {
      std::puts("working");
      std::fflush(stdout);
    }
  }
}
