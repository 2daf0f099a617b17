#pragma once

#include "app/gui/main_window.h"

#include <QDialog>
#include <QDir>
#include <QString>

#include <functional>

/** Waits up to half a minute, with events running. @return the condition at the end */
bool waitFor(const std::function<bool()>& condition);

/** Lets timers and tiles finish: until the map is complete and nothing has happened for a while. */
void settle(vp::gui::MainWindow& window);

/** Writes a PNG and says so. */
void write(const QPixmap& picture, const QDir& folder, const QString& name);

/** The whole window, or a part of it as large as a widget in it; with the OpenGL view where there is a screen. */
void shoot(QWidget& window, const QDir& folder, const QString& name, const QWidget* part = nullptr);

/** Triggers an action that opens a dialog which blocks, hands that to `look` and closes it. */
void inModal(vp::gui::MainWindow& window, const char* action, const std::function<void(QDialog&)>& look);

/** Three cells of weather and a census of people, as one edit of the mission. @param peopleFile  is written */
void addWeatherAndPeople(vp::gui::MainWindow& window, const QString& peopleFile);

/** The dialog of a file of targets, which a menu opens only after a file has been chosen. @param longNames  as in the worst of files */
void shootImport(vp::gui::MainWindow& window, const QDir& folder, const QString& name, bool longNames);

/** One picture of each view and dialog that the manual shows; the plan of the bundled mission is open. @return the program's exit status */
int shootManual(vp::gui::MainWindow& window, const QDir& folder, const QString& scratch);
