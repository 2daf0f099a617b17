#pragma once

class QCoreApplication;

namespace vp::style {

/** From now on every label, message box and tool tip of the program shows its text as it is, unless it was given Qt::RichText explicitly.
 *
 *  Names come from files that others wrote, and Qt takes a text with tags for HTML: a target called `<img src="/some/pipe">` would have the label
 * read that file, and wait for it for ever. To be called once the application is there; a second call does nothing.
 *  @threads GUI thread */
void keepTextPlain(QCoreApplication& application);

}  // namespace vp::style
