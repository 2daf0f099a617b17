#include "ui/style/plain_labels.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLabel>

namespace vp::style {
namespace {

/// Sees every widget before it is measured or shown for the first time: that is when a label begins to read what its HTML names.
class PlainLabels : public QObject {
public:
  using QObject::QObject;

  bool eventFilter(QObject* object, QEvent* event) override {
    if (event->type() == QEvent::Polish) {
      if (auto* label = qobject_cast<QLabel*>(object); label != nullptr && label->textFormat() == Qt::AutoText) {
        label->setTextFormat(Qt::PlainText);
      }
    }
    return QObject::eventFilter(object, event);
  }
};

}  // namespace

void keepTextPlain(QCoreApplication& application) {
  const QString name = QStringLiteral("plainLabels");
  if (application.findChild<QObject*>(name, Qt::FindDirectChildrenOnly) == nullptr) {
    auto* filter = new PlainLabels(&application);
    filter->setObjectName(name);
    application.installEventFilter(filter);
  }
}

}  // namespace vp::style
