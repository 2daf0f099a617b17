#include "ui/help/manual_window.h"

#include "ui/style/core_text.h"
#include "ui/style/icons.h"

#include <QAction>
#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QShortcut>
#include <QSplitter>
#include <QTextBrowser>
#include <QTextDocument>
#include <QToolBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace vp::help {
namespace {

constexpr QSize kSize{1060, 760};
constexpr int kContentsWidth = 250;
constexpr int kTextMargin = 16;
constexpr int kAnchorRole = Qt::UserRole;
constexpr int kRim = 2 * kTextMargin + 8;  // beside pictures: margins and what the frame takes

/// Colours come from the palette, so that the page follows the theme.
const QString kStyle = QStringLiteral(
    "h1 { font-size: xx-large; margin-bottom: 8px; } h2 { font-size: x-large; margin-top: 18px; } h3 { font-size: large; margin-top: 12px; } "
    "p, li { margin-top: 4px; margin-bottom: 4px; } table { border-collapse: collapse; margin-top: 6px; margin-bottom: 8px; } "
    "th, td { border: 1px solid #8b94a3; padding: 3px 7px; } code, pre { font-family: \"DejaVu Sans Mono\", monospace; } ");

/// Pages are made from Markdown when they are shown, pictures are fitted to the width of the view.
class Text : public QTextBrowser {
public:
  explicit Text(const Manual* manual) : manual_(manual) {
    document()->setDefaultStyleSheet(kStyle);
    document()->setDocumentMargin(kTextMargin);
    setOpenLinks(false);
    setFrameShape(QFrame::NoFrame);
  }

  QVariant loadResource(int type, const QUrl& name) override {
    if (manual_ == nullptr) {
      return {};
    }
    if (type == QTextDocument::HtmlResource) {
      QString file = name.path();
      file.remove(QStringLiteral(".html"));
      const Result<Page> page = manual_->page(file);
      return page ? fitted(page->body) : style::coreText(page.error()).toHtmlEscaped();
    }
    if (type == QTextDocument::ImageResource) {
      return QImage(QDir(manual_->folder()).filePath(name.path()));
    }
    return {};
  }

private:
  [[nodiscard]] QString fitted(const QString& body) const {
    static const QRegularExpression image(QStringLiteral("<img src=\"([^\"]+)\""));
    QString result;
    qsizetype done = 0;
    for (auto found = image.globalMatch(body); found.hasNext();) {
      const QRegularExpressionMatch match = found.next();
      const QSize size = QImage(QDir(manual_->folder()).filePath(match.captured(1))).size();
      const int width = std::min(size.width(), std::max(240, viewport()->width() - kRim));
      result += body.mid(done, match.capturedEnd() - done) + QStringLiteral(" width=\"%1\"").arg(width);
      done = match.capturedEnd();
    }
    return result + body.mid(done);
  }

  const Manual* manual_;
};

QUrl urlOf(const QString& page) {
  QUrl url;
  url.setPath((page.section(QLatin1Char('#'), 0, 0).isEmpty() ? QStringLiteral("index") : page.section(QLatin1Char('#'), 0, 0)) +
              QStringLiteral(".html"));
  if (const QString anchor = page.section(QLatin1Char('#'), 1); !anchor.isEmpty()) {
    url.setFragment(anchor);
  }
  return url;
}

QString pageOf(const QUrl& url) {
  QString page = url.path();
  page.remove(QStringLiteral(".html"));
  return url.hasFragment() ? page + QLatin1Char('#') + url.fragment() : page;
}

}  // namespace

ManualWindow::ManualWindow(const QString& folder, style::Theme theme, QWidget* parent) : QWidget(parent, Qt::Window) {
  setObjectName(QStringLiteral("manualWindow"));
  setWindowTitle(tr("Volplane manual"));
  Result<Manual> opened = Manual::open(folder);
  if (opened) {
    manual_ = std::move(*opened);
  }
  text_ = new Text(manual_ ? &*manual_ : nullptr);
  text_->setObjectName(QStringLiteral("manualText"));
  text_->setAccessibleName(tr("Page of the manual"));
  contents_ = new QTreeWidget;
  contents_->setObjectName(QStringLiteral("manualContents"));
  contents_->setAccessibleName(tr("Contents of the manual"));
  contents_->setHeaderHidden(true);
  contents_->setFrameShape(QFrame::NoFrame);
  auto* split = new QSplitter(Qt::Horizontal);
  split->addWidget(contents_);
  split->addWidget(text_);
  split->setStretchFactor(1, 1);
  split->setSizes({kContentsWidth, kSize.width() - kContentsWidth});
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(buildTools(theme));
  column->addWidget(split, 1);
  resize(kSize);
  text_->setFocus();
  connect(text_, &QTextBrowser::anchorClicked, this, &ManualWindow::follow);
  connect(text_, &QTextBrowser::sourceChanged, this, &ManualWindow::markInContents);
  connect(contents_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) { showPage(item->data(0, kAnchorRole).toString()); });
  connect(contents_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) { showPage(item->data(0, kAnchorRole).toString()); });
  if (manual_) {
    fillContents();
  } else {
    text_->setPlainText(tr("The manual was not found: %1. Install Volplane again, or set VOLPLANE_RESOURCES to the folder that holds it.")
                            .arg(style::coreText(opened.error())));
  }
}

QToolBar* ManualWindow::buildTools(style::Theme theme) {
  auto* tools = new QToolBar;
  const auto add = [&](const char* name, const QString& text, const char* iconName, const QKeySequence& key) {
    QAction* made = tools->addAction(style::icon(QLatin1String(iconName), theme), text);
    made->setObjectName(QLatin1String(name));
    made->setShortcut(key);
    made->setToolTip(QStringLiteral("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText)));
    return made;
  };
  QAction* back = add("manualBack", tr("Back"), "previous", QKeySequence(Qt::ALT | Qt::Key_Left));
  QAction* forward = add("manualForward", tr("Forward"), "next", QKeySequence(Qt::ALT | Qt::Key_Right));
  QAction* home = add("manualHome", tr("Contents"), "home", QKeySequence(Qt::ALT | Qt::Key_Home));
  back->setEnabled(false);
  forward->setEnabled(false);
  connect(back, &QAction::triggered, text_, &QTextBrowser::backward);
  connect(forward, &QAction::triggered, text_, &QTextBrowser::forward);
  connect(home, &QAction::triggered, this, [this] { showPage({}); });
  connect(text_, &QTextBrowser::backwardAvailable, back, &QAction::setEnabled);
  connect(text_, &QTextBrowser::forwardAvailable, forward, &QAction::setEnabled);
  tools->addSeparator();
  search_ = new QLineEdit;
  search_->setObjectName(QStringLiteral("manualSearch"));
  search_->setPlaceholderText(tr("Search in this page"));
  search_->setAccessibleName(tr("Search in this page"));
  search_->setClearButtonEnabled(true);
  search_->setMaximumWidth(kContentsWidth);
  tools->addWidget(search_);
  found_ = new QLabel;
  found_->setObjectName(QStringLiteral("manualFound"));
  tools->addWidget(found_);
  connect(search_, &QLineEdit::returnPressed, this, [this] { find(search_->text(), QApplication::keyboardModifiers().testFlag(Qt::ShiftModifier)); });
  const auto key = [this](const QKeySequence& keys, auto what) { connect(new QShortcut(keys, this), &QShortcut::activated, this, what); };
  key(QKeySequence::Find, [this] {
    search_->setFocus();
    search_->selectAll();
  });
  key(QKeySequence(Qt::Key_F3), [this] { find(search_->text()); });
  key(QKeySequence(Qt::SHIFT | Qt::Key_F3), [this] { find(search_->text(), true); });
  key(QKeySequence::ZoomIn, [this] { text_->zoomIn(); });
  key(QKeySequence::ZoomOut, [this] { text_->zoomOut(); });
  key(QKeySequence::Close, [this] { close(); });
  key(QKeySequence(Qt::Key_Escape), [this] { close(); });
  return tools;
}

void ManualWindow::fillContents() {
  for (const Chapter& chapter : manual_->chapters()) {
    auto* item = new QTreeWidgetItem(contents_, {chapter.title});
    item->setData(0, kAnchorRole, chapter.file);
  }
}

/// Sections of the page shown stand below its chapter.
void ManualWindow::markInContents(const QUrl& shown) {
  const QString file = pageOf(shown).section(QLatin1Char('#'), 0, 0);
  for (int i = 0; i < contents_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = contents_->topLevelItem(i);
    if (item->data(0, kAnchorRole).toString() != file) {
      item->setExpanded(false);
      continue;
    }
    if (item->childCount() == 0) {
      if (const Result<Page> page = manual_->page(file)) {
        for (const Heading& heading : page->headings) {
          if (heading.level == 2) {
            auto* section = new QTreeWidgetItem(item, {heading.text});
            section->setData(0, kAnchorRole, file + QLatin1Char('#') + heading.anchor);
          }
        }
      }
    }
    item->setExpanded(true);
    contents_->setCurrentItem(item);
  }
  found_->clear();
}

void ManualWindow::showPage(const QString& page) {
  if (manual_) {
    text_->setSource(urlOf(page), QTextDocument::HtmlResource);
  }
}

QString ManualWindow::shownPage() const {
  return pageOf(text_->source());
}

void ManualWindow::follow(const QUrl& link) {
  if (!link.scheme().isEmpty()) {
    QDesktopServices::openUrl(link);
    return;
  }
  text_->setSource(text_->source().resolved(link), QTextDocument::HtmlResource);
}

bool ManualWindow::find(const QString& text, bool backwards) {
  if (text.isEmpty()) {
    return false;
  }
  const QTextDocument::FindFlags flags = backwards ? QTextDocument::FindBackward : QTextDocument::FindFlags();
  bool isFound = text_->find(text, flags);
  if (!isFound) {
    const QTextCursor before = text_->textCursor();
    text_->moveCursor(backwards ? QTextCursor::End : QTextCursor::Start);
    isFound = text_->find(text, flags);
    if (!isFound) {
      text_->setTextCursor(before);
    }
  }
  found_->setText(isFound ? QString() : tr("Not in this page."));
  return isFound;
}

}  // namespace vp::help
