#pragma once

#include <QString>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QWidget;

namespace vp::dialogs {

/** A field of a form with the sentences that explain it underneath; the label becomes its buddy and its accessible name.
 *  @param focus  what the label's mnemonic goes to, if it is not the field itself */
void addField(QFormLayout* form, const QString& label, QWidget* field, const QString& explanation, QWidget* focus = nullptr);

/** A page of a form that scrolls where the screen is too low for it. */
QWidget* scrolled(QWidget* page);

/** True if a box still shows `shown` as it was rounded into it: display must not change a value that nobody touched. */
bool isUntouched(double shown, const QDoubleSpinBox* box);

/** Chooses the entry with this data. */
void choose(QComboBox* box, int data);

}  // namespace vp::dialogs
