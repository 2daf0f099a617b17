// volplane: the window.
#include "app/gui/main_window.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>

int main(int argc, char** argv) {
  QApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
  QCoreApplication::setOrganizationName(QStringLiteral("Volplane"));
  QCoreApplication::setApplicationName(QStringLiteral("volplane"));
  QCoreApplication::setApplicationVersion(QStringLiteral(VOLPLANE_VERSION));
  QGuiApplication::setDesktopFileName(QStringLiteral("volplane"));
  QApplication application(argc, argv);
  QGuiApplication::setApplicationDisplayName(QString());

  QCommandLineParser parser;
  parser.setApplicationDescription(
      QCoreApplication::translate("main", "Plans closed surveillance tours from every point of which the aircraft can glide to a runway."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("files"),
                               QCoreApplication::translate("main", "A mission (*.vpm) or plan (*.vpp), or terrain and airfields"),
                               QStringLiteral("[files...]"));
  parser.process(application);

  vp::gui::MainWindow window;
  window.show();
  const QStringList files = parser.positionalArguments();
  QTimer::singleShot(0, &window, [&window, files] { files.isEmpty() ? window.welcome() : window.take(files); });
  return QApplication::exec();
}
