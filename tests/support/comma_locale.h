#pragma once
// A locale with a decimal comma, made for a test: no machine has to have it.

#include <QProcess>
#include <QString>
#include <QStringList>

namespace vp::test {

/** Makes de_DE.UTF-8 in a folder, to be used with LOCPATH naming that folder. @return what localedef complains of; empty if it is there */
inline QString makeCommaLocale(const QString& folder) {
  QProcess make;
  make.start(QStringLiteral("localedef"),
             {QStringLiteral("-i"), QStringLiteral("de_DE"), QStringLiteral("-f"), QStringLiteral("UTF-8"), folder + QStringLiteral("/de_DE.UTF-8")});
  if (!make.waitForFinished(60'000)) {
    return QStringLiteral("localedef cannot be run");
  }
  return make.exitCode() == 0 ? QString() : QString::fromLocal8Bit(make.readAllStandardError());
}

}  // namespace vp::test
