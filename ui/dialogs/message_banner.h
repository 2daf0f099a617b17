#pragma once

#include "ui/style/chart_colors.h"

#include <QFrame>
#include <QString>

#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace vp::dialogs {

/** A strip above the map that says in plain words what happened and offers what to do; it never blocks. One message at a
 *  time: a new one replaces the old. */
class MessageBanner : public QFrame {
  Q_OBJECT

public:
  enum class Kind { Hint, Success, Warning, Failure };
  struct Action {
    QString text;
    std::function<void()> run;  ///< the banner hides first
  };

  explicit MessageBanner(QWidget* parent = nullptr);

  void show(Kind kind, const QString& text, const std::vector<Action>& actions = {});
  void setTheme(style::Theme theme);
  [[nodiscard]] QString text() const;
  [[nodiscard]] Kind kind() const { return kind_; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  void showKind();
  void offer(const std::vector<Action>& actions);

  Kind kind_ = Kind::Hint;
  style::Theme theme_ = style::Theme::Light;
  QLabel* icon_ = nullptr;
  QLabel* text_ = nullptr;
  QHBoxLayout* buttonRow_ = nullptr;
  std::vector<QPushButton*> buttons_;  ///< used again by the next message; those that it does not need are hidden
  QToolButton* close_ = nullptr;
};

}  // namespace vp::dialogs
