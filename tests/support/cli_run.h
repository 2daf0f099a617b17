#pragma once
// Runs volplane-cli and keeps what it printed.

#include <QByteArray>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStringList>

namespace vp::test {

struct CliResult {
  int status = -1;
  QByteArray out;
  QByteArray err;
  bool crashed = false;
};

inline CliResult runCli(const QStringList& arguments, const QString& folder = {}) {
  QProcess process;
  process.setWorkingDirectory(folder);
  process.start(QStringLiteral(VOLPLANE_BIN_DIR "/volplane-cli"), arguments);
  process.waitForFinished(900'000);
  return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError(), process.exitStatus() == QProcess::CrashExit};
}

inline QByteArray readAll(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline bool writeAll(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

}  // namespace vp::test
