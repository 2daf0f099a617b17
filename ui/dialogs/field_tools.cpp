#include "ui/dialogs/field_tools.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include <cmath>

namespace vp::dialogs {

void addField(QFormLayout* form, const QString& label, QWidget* field, const QString& explanation, QWidget* focus) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 6);
  column->setSpacing(2);
  column->addWidget(field);
  auto* text = new QLabel(explanation);
  text->setWordWrap(true);
  text->setForegroundRole(QPalette::PlaceholderText);
  column->addWidget(text);
  auto* name = new QLabel(label);
  QWidget* buddy = focus != nullptr ? focus : field;
  name->setBuddy(buddy);
  QString plain = label;
  buddy->setAccessibleName(plain.remove(QLatin1Char('&')));
  buddy->setAccessibleDescription(explanation);
  form->addRow(name, box);
}

QWidget* scrolled(QWidget* page) {
  auto* area = new QScrollArea;
  area->setWidget(page);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->viewport()->setAutoFillBackground(false);  // it lies on the pane of the tab
  page->setAutoFillBackground(false);
  return area;
}

bool isUntouched(double shown, const QDoubleSpinBox* box) {
  return std::abs(box->value() - shown) <= 0.5 * std::pow(10.0, -box->decimals());
}

void choose(QComboBox* box, int data) {
  box->setCurrentIndex(box->findData(data));
}

}  // namespace vp::dialogs
