#include "tests/architecture/translation_file.h"

#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <algorithm>

namespace vp::test {
namespace {

QStringList matches(const QString& text, const char* pattern) {
  QStringList found;
  const QRegularExpression expression(QString::fromUtf8(pattern));
  for (auto it = expression.globalMatch(text); it.hasNext();) {
    found << it.next().captured();
  }
  std::sort(found.begin(), found.end());
  return found;
}

QString endsOf(const QString& text) {
  const QString core = text.trimmed();
  const qsizetype start = text.indexOf(core);
  return text.left(start) + QLatin1Char('|') + text.mid(start + core.size());
}

/// The numbers that the translation of a pattern of fmt has for its placeholders: %1, %2 ...
QStringList numbersOf(QString pattern) {
  pattern.remove(QStringLiteral("{{")).remove(QStringLiteral("}}"));
  QStringList numbers;
  for (qsizetype i = 1; i <= matches(pattern, "\\{[^{}]*\\}").size(); ++i) {
    numbers << QStringLiteral("%%1").arg(i);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// Those of a translation, which may say one twice.
QStringList numbersIn(const QString& form) {
  QStringList numbers = matches(form, "%[0-9]+");
  numbers.removeDuplicates();
  return numbers;
}

QStringList faultsOfForm(const TranslatedText& text, const QString& form) {
  QStringList faults;
  const auto same = [&](const char* what, const QStringList& wanted, const QStringList& found) {
    if (wanted != found) {
      faults << QStringLiteral("%1: %2 [%3] instead of [%4] in “%5”")
                    .arg(text.name(), QLatin1String(what), found.join(QLatin1Char(' ')), wanted.join(QLatin1Char(' ')), form);
    }
  };
  const auto compare = [&](const char* what, const char* pattern) { same(what, matches(text.source, pattern), matches(form, pattern)); };
  if (text.context == QStringLiteral("Core")) {
    same("placeholders", numbersOf(text.source), numbersIn(form));
  } else {
    compare("placeholders", "%(L?[0-9]+|n)|\\{[a-z]+\\}");
  }
  compare("mnemonics", "&(?=[^&\\s])");
  compare("line ends", "\n");
  compare("tags", "</?[a-z]+>");
  compare("file patterns", "\\*\\.[a-z0-9.]+");
  compare("ellipsis", "…$");
  same("outer spaces", {endsOf(text.source)}, {endsOf(form)});
  return faults;
}

TranslatedText readMessage(QXmlStreamReader& xml, const QString& context) {
  TranslatedText text;
  text.context = context;
  text.isCounted = xml.attributes().value(QStringLiteral("numerus")) == QStringLiteral("yes");
  while (xml.readNextStartElement()) {
    if (xml.name() == QStringLiteral("source")) {
      text.source = xml.readElementText();
    } else if (xml.name() == QStringLiteral("comment")) {
      text.comment = xml.readElementText();
    } else if (xml.name() == QStringLiteral("translation")) {
      text.isFinished = !xml.attributes().hasAttribute(QStringLiteral("type"));
      if (!text.isCounted) {
        text.forms << xml.readElementText();
        continue;
      }
      while (xml.readNextStartElement()) {
        text.forms << xml.readElementText();
      }
    } else {
      xml.skipCurrentElement();
    }
  }
  return text;
}

}  // namespace

QVector<TranslatedText> readTranslations(const QString& path) {
  QVector<TranslatedText> texts;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    return texts;
  }
  QXmlStreamReader xml(&file);
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) {
      continue;
    }
    if (xml.name() == QStringLiteral("name")) {
      context = xml.readElementText();
    } else if (xml.name() == QStringLiteral("message")) {
      texts << readMessage(xml, context);
    }
  }
  return xml.hasError() ? QVector<TranslatedText>() : texts;
}

QStringList faultsOf(const TranslatedText& text, int plurals) {
  QStringList faults;
  if (!text.isFinished) {
    faults << QStringLiteral("%1: unfinished").arg(text.name());
  }
  const qsizetype wanted = text.isCounted ? plurals : 1;
  if (text.forms.size() != wanted) {
    faults << QStringLiteral("%1: %2 forms instead of %3").arg(text.name()).arg(text.forms.size()).arg(wanted);
  }
  for (const QString& form : text.forms) {
    if (form.isEmpty()) {
      faults << QStringLiteral("%1: no translation").arg(text.name());
    } else {
      faults << faultsOfForm(text, form);
    }
  }
  return faults;
}

}  // namespace vp::test
