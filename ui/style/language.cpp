#include "ui/style/language.h"

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLibraryInfo>
#include <QLineEdit>
#include <QTranslator>

#include <array>
#include <clocale>
#include <utility>

// A static library's resources are linked in only if somebody asks for them; the macro must stand outside namespaces.
static void initTranslations() {
  Q_INIT_RESOURCE(translations);
}

namespace vp::style {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Language)
};

constexpr std::array kNames{std::pair{"en", "English"}, std::pair{"de", "Deutsch"}, std::pair{"cs", "\u010Ce\u0161tina"}};

/// German and Czech keyboards have a comma where others have the point of the number pad.
class CommaAsPoint : public QObject {
public:
  using QObject::QObject;

  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::KeyPress || qobject_cast<QLineEdit*>(watched) == nullptr ||
        qobject_cast<QDoubleSpinBox*>(watched->parent()) == nullptr) {
      return false;
    }
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->text() != QStringLiteral(",")) {
      return false;
    }
    QKeyEvent point(QEvent::KeyPress, Qt::Key_Period, key->modifiers(), QStringLiteral("."));
    QCoreApplication::sendEvent(watched, &point);
    return true;
  }
};

/// Takes the place of what an earlier call has installed.
void install(const QString& name, const QString& file, const QString& folder) {
  auto* application = QCoreApplication::instance();
  if (auto* before = application->findChild<QTranslator*>(name)) {
    QCoreApplication::removeTranslator(before);
    delete before;
  }
  auto* translator = new QTranslator(application);
  translator->setObjectName(name);
  if (translator->load(file, folder)) {
    QCoreApplication::installTranslator(translator);
  }
}

}  // namespace

QStringList languages() {
  QStringList codes;
  for (const auto& [code, name] : kNames) {
    codes << QLatin1String(code);
  }
  return codes;
}

QString languageName(const QString& code) {
  for (const auto& [known, name] : kNames) {
    if (code == QLatin1String(known)) {
      return QString::fromUtf8(name);
    }
  }
  return code;
}

QString languageFor(const QString& wanted, const QStringList& system) {
  const QStringList known = languages();
  if (known.contains(wanted)) {
    return wanted;
  }
  for (const QString& language : system) {
    if (const QString code = language.section(QLatin1Char('-'), 0, 0); known.contains(code)) {
      return code;
    }
  }
  return known.front();
}

void useLanguage(const QString& code) {
  initTranslations();
  install(QStringLiteral("qtTranslator"), QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  install(QStringLiteral("translator"), QStringLiteral("volplane_") + code, QStringLiteral(":/translations"));
  QLocale numbers = QLocale::c();
  numbers.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  QLocale::setDefault(numbers);
  std::setlocale(LC_NUMERIC, "C");  // QCoreApplication has taken the user's; libraries that read files by strtod want a point
  static const auto kFilter = QStringLiteral("commaAsPoint");
  if (auto* application = QCoreApplication::instance(); application->findChild<QObject*>(kFilter) == nullptr) {
    auto* filter = new CommaAsPoint(application);
    filter->setObjectName(kFilter);
    application->installEventFilter(filter);
  }
}

QLocale languageLocale() {
  const QString code = Words::tr("en", "code of this language, for the names of months and weekdays");
  return code == QStringLiteral("en") ? QLocale::c() : QLocale(code);
}

}  // namespace vp::style
