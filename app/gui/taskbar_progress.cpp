#include "app/gui/taskbar_progress.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QGuiApplication>
#include <QVariantMap>

namespace vp::gui {

void TaskbarProgress::show(double fraction) {
  send(fraction, true);
}

void TaskbarProgress::hide() {
  send(0.0, false);
}

void TaskbarProgress::send(double fraction, bool visible) const {
  if (qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS") || QGuiApplication::platformName() == QLatin1String("offscreen")) {
    return;  // asking for the bus where there is none waits for a timeout
  }
  QDBusMessage message = QDBusMessage::createSignal(QStringLiteral("/org/volplane/Volplane"), QStringLiteral("com.canonical.Unity.LauncherEntry"),
                                                    QStringLiteral("Update"));
  message << QStringLiteral("application://volplane.desktop")
          << QVariantMap{{QStringLiteral("progress"), fraction}, {QStringLiteral("progress-visible"), visible}};
  QDBusConnection::sessionBus().send(message);
}

}  // namespace vp::gui
