#pragma once

#include <QObject>

namespace vp::gui {

/** Progress in the task bar, for desktops that follow the Unity LauncherEntry protocol (KDE Plasma, Dash to Dock, Unity).
 *  Does nothing where there is no session bus. @source wiki.ubuntu.com/Unity/LauncherAPI, "Low level DBus API" */
class TaskbarProgress : public QObject {
  Q_OBJECT

public:
  explicit TaskbarProgress(QObject* parent = nullptr) : QObject(parent) {}
  void show(double fraction);
  void hide();

private:
  void send(double fraction, bool visible) const;
};

}  // namespace vp::gui
