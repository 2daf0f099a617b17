#include "ui/dialogs/message_banner.h"

#include "ui/style/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace vp::dialogs {
namespace {
constexpr int kIconSide = 22;
}

MessageBanner::MessageBanner(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("messageBanner"));
  setAccessibleName(tr("Message"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 8, 8, 8);
  row->setSpacing(10);
  icon_ = new QLabel(this);
  text_ = new QLabel(this);
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  buttons_ = new QHBoxLayout;
  buttons_->setSpacing(6);
  close_ = new QToolButton(this);
  close_->setToolTip(tr("Close this message"));
  close_->setAccessibleName(close_->toolTip());
  connect(close_, &QToolButton::clicked, this, &QWidget::hide);
  row->addWidget(icon_, 0, Qt::AlignTop);
  row->addWidget(text_, 1);
  row->addLayout(buttons_);
  row->addWidget(close_, 0, Qt::AlignTop);
  hide();
}

QString MessageBanner::text() const {
  return text_->text();
}

void MessageBanner::show(Kind kind, const QString& text, const std::vector<Action>& actions) {
  kind_ = kind;
  text_->setText(text);
  setAccessibleDescription(text);
  while (QLayoutItem* item = buttons_->takeAt(0)) {
    if (item->widget() != nullptr) {
      item->widget()->deleteLater();
    }
    delete item;
  }
  for (const Action& action : actions) {
    auto* button = new QPushButton(action.text, this);
    connect(button, &QPushButton::clicked, this, [this, run = action.run] {
      hide();
      run();
    });
    buttons_->addWidget(button);
  }
  paintKind();
  setVisible(true);
}

void MessageBanner::setTheme(style::Theme theme) {
  theme_ = theme;
  paintKind();
}

void MessageBanner::paintKind() {
  const style::ChartColors& c = style::ChartColors::of(theme_);
  const QColor edge = kind_ == Kind::Failure   ? c.violation
                      : kind_ == Kind::Warning ? c.glideTight
                      : kind_ == Kind::Success ? c.glideAmple
                                               : c.selection;
  const QString icon = kind_ == Kind::Success ? QStringLiteral("verified") : kind_ == Kind::Hint ? QStringLiteral("info") : QStringLiteral("worst");
  icon_->setPixmap(style::icon(icon, theme_).pixmap(QSize(kIconSide, kIconSide), devicePixelRatioF()));
  close_->setIcon(style::icon(QStringLiteral("close"), theme_));
  setStyleSheet(QStringLiteral("QFrame#messageBanner { background: %1; border: none; border-left: 5px solid %2; border-bottom: 1px solid %3; }")
                    .arg(c.panel.name(), edge.name(), c.panelBorder.name()));
}

}  // namespace vp::dialogs
