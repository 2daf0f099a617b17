// The targets of a file to choose from: check boxes, search, options that read the file again, and what stands in the way of importing.
#include "ui/dialogs/import_targets_dialog.h"
#include "ui/dialogs/target_choice_model.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTest>

#include <memory>

using namespace vp;
using dialogs::ImportTargetsDialog;
using dialogs::TargetChoiceModel;
using formats::ImportedTargets;
using formats::TargetImportOptions;

namespace {

mission::Target targetOf(const std::string& name, int number) {
  return {name, {46.0 + number * 1e-4, 9.5}, 100.0 + number, number % 2 == 0 ? mission::HeightReference::AboveGround : mission::HeightReference::Msl};
}

ImportedTargets manyTargets(int count) {
  ImportedTargets found;
  for (int i = 0; i < count; ++i) {
    found.targets.push_back(targetOf("W" + std::to_string(i), i));
  }
  return found;
}

QStringList namesOf(const std::vector<mission::Target>& targets) {
  QStringList names;
  for (const mission::Target& target : targets) {
    names << QString::fromStdString(target.name);
  }
  return names;
}

}  // namespace

class TestImportDialogs : public QObject {
  Q_OBJECT

private slots:
  void init() {
    readings_.clear();
    answer_ = [](const TargetImportOptions&) -> Result<ImportedTargets> {
      ImportedTargets found;
      found.targets = {targetOf("Hut", 0), targetOf("Dam", 1), targetOf("Hutwil", 2), targetOf("Top", 3)};
      found.notes = {"row 7 was left out"};
      return found;
    };
  }

  void targets_areListedWithPlaceAndHeight_allChosen() {
    open(style::UnitSystem::Metric);
    QCOMPARE(rows(), (QStringList{"Hut", "Dam", "Hutwil", "Top"}));
    QCOMPARE(text(1, TargetChoiceModel::Position), style::Units::position({46.0001, 9.5}));
    const style::Units units(style::UnitSystem::Metric);
    QCOMPARE(text(0, TargetChoiceModel::Height), units.heightAboveGround(100.0));
    QCOMPARE(text(1, TargetChoiceModel::Height), units.altitudeMsl(101.0));
    QCOMPARE(label("importCount"), QStringLiteral("4 of 4 chosen"));
    QVERIFY(button().isEnabled() && label("importProblem").isEmpty());
    QCOMPARE(dialog_->chosen().notes, std::vector<std::string>{"row 7 was left out"});
    QCOMPARE(namesOf(dialog_->chosen().targets), rows());
  }

  void checkBoxes_leaveOutTargets() {
    open();
    dialog_->show();
    QVERIFY(QTest::qWaitForWindowExposed(dialog_.get()));
    table().setCurrentIndex(table().model()->index(1, 0));
    QTest::keyClick(&table(), Qt::Key_Space);
    QCOMPARE(namesOf(dialog_->chosen().targets), (QStringList{"Hut", "Hutwil", "Top"}));
    QCOMPARE(label("importCount"), QStringLiteral("3 of 4 chosen"));
    QTest::keyClick(&table(), Qt::Key_Space);
    QCOMPARE(dialog_->chosen().targets.size(), std::size_t(4));
  }

  void search_narrowsWhatAllAndNoneAreAbout() {
    open();
    find<QPushButton>("importNone").click();
    find<QLineEdit>("importSearch").setText("hut");
    QCOMPARE(rows(), (QStringList{"Hut", "Hutwil"}));
    QCOMPARE(label("importCount"), QStringLiteral("0 of 4 chosen; the search shows 2"));
    find<QPushButton>("importAll").click();
    QCOMPARE(namesOf(dialog_->chosen().targets), (QStringList{"Hut", "Hutwil"}));
    find<QLineEdit>("importSearch").setText("WIL");
    find<QPushButton>("importNone").click();
    find<QLineEdit>("importSearch").setText("no such name");
    QCOMPARE(rows(), QStringList());
    find<QPushButton>("importAll").click();  // of nothing
    find<QLineEdit>("importSearch").clear();
    QCOMPARE(namesOf(dialog_->chosen().targets), QStringList{"Hut"});
    QCOMPARE(rows().size(), 4);
  }

  void enterInTheSearch_importsNothing() {
    open();
    dialog_->show();
    QVERIFY(QTest::qWaitForWindowActive(dialog_.get()));
    auto& search = find<QLineEdit>("importSearch");
    search.setFocus();
    QTest::keyClicks(&search, "hut");
    QTest::keyClick(&search, Qt::Key_Return);
    QVERIFY(dialog_->isVisible());
    table().setFocus();
    QTest::keyClick(&table(), Qt::Key_Return);
    QVERIFY(!dialog_->isVisible());
    QCOMPARE(dialog_->result(), static_cast<int>(QDialog::Accepted));
  }

  void noneChosen_cannotBeImported() {
    open();
    find<QPushButton>("importNone").click();
    QVERIFY(!button().isEnabled());
    QCOMPARE(label("importProblem"), QStringLiteral("Choose at least one target to import."));
    QVERIFY(table().model()->setData(table().model()->index(2, 0), Qt::Checked, Qt::CheckStateRole));
    QVERIFY(button().isEnabled() && label("importProblem").isEmpty());
    QVERIFY(!table().model()->setData(table().model()->index(2, 1), Qt::Checked, Qt::CheckStateRole));  // only the name has a box
  }

  void tenThousand_haveToBeNarrowedDown() {
    answer_ = [](const TargetImportOptions&) -> Result<ImportedTargets> { return manyTargets(10000); };
    open();
    dialog_->show();
    QVERIFY(QTest::qWaitForWindowExposed(dialog_.get()));
    QCOMPARE(table().model()->rowCount(), 10000);
    QCOMPARE(label("importCount"), QStringLiteral("0 of 10000 chosen"));
    QVERIFY(!button().isEnabled());
    find<QPushButton>("importAll").click();
    QVERIFY(!button().isEnabled());
    QCOMPARE(label("importProblem"), QStringLiteral("At most 5000 targets are imported at once; choose fewer."));
    find<QPushButton>("importNone").click();
    find<QLineEdit>("importSearch").setText("W999");
    QCOMPARE(table().model()->rowCount(), 11);
    find<QPushButton>("importAll").click();
    QVERIFY(button().isEnabled());
    QCOMPARE(dialog_->chosen().targets.size(), std::size_t(11));
    QCOMPARE(QString::fromStdString(dialog_->chosen().targets.back().name), QStringLiteral("W9999"));
  }

  void fiveThousand_areTheMost() {
    answer_ = [](const TargetImportOptions&) -> Result<ImportedTargets> { return manyTargets(5000); };
    open();
    QVERIFY(button().isEnabled());
    QCOMPARE(dialog_->chosen().targets.size(), std::size_t(5000));
  }

  void changedOptions_readAgainOnceAndKeepTheChoice() {
    answer_ = [](const TargetImportOptions& options) -> Result<ImportedTargets> {
      ImportedTargets found = manyTargets(3);
      for (mission::Target& target : found.targets) {
        target.height_m = options.heightMsl_m.value_or(target.height_m);
        target.reference = options.heightMsl_m ? mission::HeightReference::Msl : target.reference;
      }
      return found;
    };
    open(style::UnitSystem::Metric);
    QVERIFY(table().model()->setData(table().model()->index(1, 0), Qt::Unchecked, Qt::CheckStateRole));
    find<QComboBox>("importHeights").setCurrentIndex(3);
    QVERIFY(!button().isEnabled());  // at once: the table is of other heights
    QVERIFY(label("importProblem").startsWith(QStringLiteral("Reading")));
    find<QDoubleSpinBox>("importHeight").setValue(2000.0);
    find<QDoubleSpinBox>("importHeight").setValue(2500.0);
    QTRY_VERIFY(button().isEnabled());
    QCOMPARE(readings_.size(), std::size_t(1));
    QCOMPARE(*readings_[0].heightMsl_m, 2500.0);
    QCOMPARE(text(0, TargetChoiceModel::Height), style::Units(style::UnitSystem::Metric).altitudeMsl(2500.0));
    QCOMPARE(namesOf(dialog_->chosen().targets), (QStringList{"W0", "W2"}));
    QCOMPARE(dialog_->chosen().targets[0].height_m, 2500.0);
  }

  void newTargets_areChosenOnlyIfAllWere() {
    answer_ = [](const TargetImportOptions& options) -> Result<ImportedTargets> { return manyTargets(options.tracks ? 5 : 3); };
    open();
    find<QCheckBox>("importTracks").setChecked(true);
    QTRY_VERIFY(button().isEnabled());
    QCOMPARE(dialog_->chosen().targets.size(), std::size_t(5));
    open();
    QVERIFY(table().model()->setData(table().model()->index(0, 0), Qt::Unchecked, Qt::CheckStateRole));
    find<QCheckBox>("importTracks").setChecked(true);
    QTRY_VERIFY(button().isEnabled());
    QCOMPARE(label("importCount"), QStringLiteral("2 of 5 chosen"));
  }

  void errorOfTheReading_isToldAndCuredByOtherOptions() {
    answer_ = [](const TargetImportOptions& options) -> Result<ImportedTargets> {
      if (options.spacing.si() < 900.0) {
        return fail(Errc::OutOfRange, "gives 400000 targets; choose a wider spacing", "/some/folder/places.csv, Wood");
      }
      return manyTargets(3);
    };
    open(style::UnitSystem::Metric);
    QVERIFY(!button().isEnabled());
    QCOMPARE(label("importProblem"), QStringLiteral("places.csv, Wood: gives 400000 targets; choose a wider spacing."));
    find<QDoubleSpinBox>("importSpacing").setValue(1000.0);
    QTRY_VERIFY(button().isEnabled());
    QCOMPARE(dialog_->chosen().targets.size(), std::size_t(3));
    find<QDoubleSpinBox>("importSpacing").setValue(100.0);
    QTRY_VERIFY(label("importProblem").contains(QStringLiteral("wider spacing")));
    QVERIFY(!button().isEnabled());
  }

  void tracksAlone_sayHowToTakeThem() {
    answer_ = [](const TargetImportOptions& options) -> Result<ImportedTargets> { return manyTargets(options.tracks ? 2 : 0); };
    open();
    QVERIFY(!button().isEnabled());
    QVERIFY2(label("importProblem").contains(QStringLiteral("Points of tracks too")), qPrintable(label("importProblem")));
    find<QCheckBox>("importTracks").setChecked(true);
    QTRY_VERIFY(button().isEnabled());
    QCOMPARE(dialog_->chosen().targets.size(), std::size_t(2));
  }

  void longNames_andSmallestWindow_cutNothingOff() {
    const std::string name(60, 'W');
    answer_ = [&name](const TargetImportOptions& options) -> Result<ImportedTargets> {
      if (options.tracks) {
        return fail(Errc::OutOfRange, "gives 400000 targets; at most 5000 are imported at once, so choose a wider spacing",
                    "/some/folder/places.csv, " + name);
      }
      ImportedTargets found = manyTargets(900);
      found.targets[0].name = name;
      return found;
    };
    open();
    QCOMPARE(table().model()->index(0, 0).data(Qt::ToolTipRole).toString(), QString::fromStdString(name));
    QVERIFY(table().textElideMode() == Qt::ElideRight);
    dialog_->show();
    dialog_->resize(1, 1);
    QVERIFY(QTest::qWaitForWindowExposed(dialog_.get()));
    grab("smallest");
    checkNothingIsCutOff();
    QVERIFY(table().viewport()->height() >= 3 * table().rowHeight(0));
    const int columns = table().columnWidth(0) + table().columnWidth(1) + table().columnWidth(2);
    QVERIFY2(columns <= table().viewport()->width(), "a column needs scrolling");
    find<QCheckBox>("importTracks").setChecked(true);
    QTRY_VERIFY(label("importProblem").contains(QStringLiteral("wider spacing")));
    QTest::qWait(50);
    grab("problem");
    checkNothingIsCutOff();
    dialog_->resize(640, 640);
    grab("usual");
  }

private:
  void open(style::UnitSystem system = style::UnitSystem::Aviation) {
    readings_.clear();
    jobs::TargetsOfFile file;
    file.path = QStringLiteral("/some/folder/places.csv");
    file.found = answer_({});
    file.read = [this](const TargetImportOptions& options, const Job&) {
      readings_.push_back(options);
      return answer_(options);
    };
    dialog_ = std::make_unique<ImportTargetsDialog>(std::move(file), style::Units(system));
  }
  template <typename T>
  T& find(const char* name) const {
    T* found = dialog_->findChild<T*>(QLatin1String(name));
    if (found == nullptr) {
      qFatal("there is no %s", name);
    }
    return *found;
  }
  [[nodiscard]] QTableView& table() const { return find<QTableView>("importTable"); }
  [[nodiscard]] QString label(const char* name) const { return find<QLabel>(name).text(); }
  [[nodiscard]] QPushButton& button() const { return *dialog_->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok); }
  [[nodiscard]] QString text(int row, int column) const { return table().model()->index(row, column).data().toString(); }
  [[nodiscard]] QStringList rows() const {
    QStringList names;
    for (int row = 0; row < table().model()->rowCount(); ++row) {
      names << text(row, TargetChoiceModel::Name);
    }
    return names;
  }
  /// For looking at, where VOLPLANE_PICTURES names a folder.
  void grab(const QString& name) const {
    if (const QString folder = qEnvironmentVariable("VOLPLANE_PICTURES"); !folder.isEmpty()) {
      QVERIFY(dialog_->grab().save(folder + "/import-" + name + ".png"));
    }
  }
  void checkNothingIsCutOff() const {
    for (const QWidget* widget : dialog_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
      if (!widget->isVisible()) {
        continue;
      }
      const QString what = QString::fromLatin1(widget->metaObject()->className()) + ' ' + widget->objectName();
      QVERIFY2(dialog_->rect().contains(widget->geometry()), qPrintable(what + " lies outside"));
      QVERIFY2(widget->width() >= widget->minimumSizeHint().width(), qPrintable(what + " is too narrow"));
      const int needed = widget->hasHeightForWidth() ? widget->heightForWidth(widget->width()) : widget->minimumSizeHint().height();
      QVERIFY2(widget->height() >= needed, qPrintable(what + " is too low"));
    }
  }

  std::unique_ptr<ImportTargetsDialog> dialog_;
  std::function<Result<ImportedTargets>(const TargetImportOptions&)> answer_;
  std::vector<TargetImportOptions> readings_;
};

QTEST_MAIN(TestImportDialogs)
#include "tst_import_dialogs.moc"
