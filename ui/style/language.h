#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>

namespace vp::style {

/** Languages that the window can speak, as ISO 639-1 codes; English, which the sources are written in, is the first. */
QStringList languages();

/** Its name in itself, "Deutsch"; the code where it is none of languages(). */
QString languageName(const QString& code);

/** Which language to speak.
 *  @param wanted  a code of languages(); anything else, such as nothing, asks for the first language of the system that is there
 *  @param system  languages of the user in order of preference, as QLocale::uiLanguages gives them ("de-CH", "de", "en")
 *  @return a code of languages(), English where no language of the user is there */
QString languageFor(const QString& wanted, const QStringList& system);

/** Makes the program speak a language from here on: windows made before keep theirs. Qt's own texts come along where
 *  they are installed. Numbers are written with a point and without groups in every language, as in aviation, and a comma
 *  typed into a number field counts as a point. Not for tests' or command-line programs' own texts, which stay English.
 *  @param code  of languages()   @pre a QCoreApplication lives   @threads GUI */
void useLanguage(const QString& code);

/** The language that is spoken, for names of months and weekdays. */
QLocale languageLocale();

}  // namespace vp::style
