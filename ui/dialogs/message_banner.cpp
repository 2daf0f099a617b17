#include "ui/dialogs/message_banner.h"

#include "ui/style/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

namespace vp::dialogs {
namespace {
constexpr int kIconSide = 22;
constexpr int kEdge = 5;  // px of the colour on the left
}  // namespace

MessageBanner::MessageBanner(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("messageBanner"));
  setAccessibleName(tr("Message"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kEdge + 12, 8, 8, 9);
  row->setSpacing(10);
  icon_ = new QLabel(this);
  text_ = new QLabel(this);
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  buttonRow_ = new QHBoxLayout;
  buttonRow_->setSpacing(6);
  close_ = new QToolButton(this);
  close_->setToolTip(tr("Close this message"));
  close_->setAccessibleName(close_->toolTip());
  connect(close_, &QToolButton::clicked, this, &QWidget::hide);
  row->addWidget(icon_, 0, Qt::AlignTop);
  row->addWidget(text_, 1);
  row->addLayout(buttonRow_);
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
  offer(actions);
  showKind();
  setVisible(true);
}

// Each new button would have a palette of its own, and Qt's cache of pixmaps a picture of each.
void MessageBanner::offer(const std::vector<Action>& actions) {
  while (buttons_.size() < actions.size()) {
    buttons_.push_back(new QPushButton(this));
    buttonRow_->addWidget(buttons_.back());
  }
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    QPushButton* button = buttons_[i];
    button->disconnect(this);
    button->setVisible(i < actions.size());
    button->setText(i < actions.size() ? actions[i].text : QString());
    if (i < actions.size()) {
      connect(button, &QPushButton::clicked, this, [this, run = actions[i].run] {
        hide();
        run();
      });
    }
  }
}

void MessageBanner::setTheme(style::Theme theme) {
  theme_ = theme;
  showKind();
}

void MessageBanner::showKind() {
  const QString icon = kind_ == Kind::Success ? QStringLiteral("verified") : kind_ == Kind::Hint ? QStringLiteral("info") : QStringLiteral("worst");
  icon_->setPixmap(style::icon(icon, theme_).pixmap(QSize(kIconSide, kIconSide), devicePixelRatioF()));
  close_->setIcon(style::icon(QStringLiteral("close"), theme_));
  update();
}

// Not by a style sheet: setting one gives the buttons new palettes, see offer().
void MessageBanner::paintEvent(QPaintEvent* /*event*/) {
  const style::ChartColors& c = style::ChartColors::of(theme_);
  const QColor edge = kind_ == Kind::Failure   ? c.violation
                      : kind_ == Kind::Warning ? c.glideTight
                      : kind_ == Kind::Success ? c.glideAmple
                                               : c.selection;
  QPainter painter(this);
  painter.fillRect(rect(), c.panel);
  painter.fillRect(QRect(0, height() - 1, width(), 1), c.panelBorder);
  painter.fillRect(QRect(0, 0, kEdge, height()), edge);
}

}  // namespace vp::dialogs
