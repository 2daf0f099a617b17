#include "ui/dialogs/airspace_dialog.h"

#include "ui/dialogs/field_tools.h"
#include "ui/document/airspace_words.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace vp::dialogs {
namespace {

using mission::AirspaceUse;

enum Column { Name, Limits, Use, ColumnCount };
constexpr int kAsClass = -1;  // data of a choice: no rule of its own
constexpr int kKindRole = Qt::UserRole;
constexpr int kNameRole = Qt::UserRole + 1;
constexpr QSize kSize{720, 520};

/// The rule that a class or a name has of its own.
std::optional<AirspaceUse> ruleOf(const mission::AirspaceSettings& settings, const std::string& kind, const std::string& name) {
  const auto found = std::find_if(settings.rules.begin(), settings.rules.end(),
                                  [&](const mission::AirspaceRule& rule) { return rule.name == name && (!name.empty() || rule.kind == kind); });
  return found == settings.rules.end() ? std::nullopt : std::optional(found->use);
}

void fill(QComboBox& box, const QString& inherited) {
  box.addItem(inherited, kAsClass);
  for (const AirspaceUse use : document::kAirspaceUses) {
    box.addItem(document::airspaceUseText(use), static_cast<int>(use));
  }
}

}  // namespace

AirspaceDialog::AirspaceDialog(const std::vector<mission::Airspace>& airspaces, const std::vector<std::string>& kinds,
                               const mission::AirspaceSettings& settings, const style::Units& units, QWidget* parent)
    : QDialog(parent), settings_(settings) {
  setWindowTitle(tr("Airspace"));
  setObjectName(QStringLiteral("airspaceDialog"));
  tree_ = new QTreeWidget;
  tree_->setObjectName(QStringLiteral("airspaceRules"));
  tree_->setAccessibleName(tr("Airspaces by class"));
  tree_->setColumnCount(ColumnCount);
  tree_->setHeaderLabels({tr("Class and name"), tr("Ceiling / floor"), tr("What to do")});
  tree_->setUniformRowHeights(true);
  tree_->header()->setSectionResizeMode(Name, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(Limits, QHeaderView::ResizeToContents);
  tree_->header()->setSectionResizeMode(Use, QHeaderView::ResizeToContents);
  tree_->header()->setStretchLastSection(false);
  hint_ = new QLabel;
  hint_->setWordWrap(true);
  hint_->setForegroundRole(QPalette::PlaceholderText);
  otherwise_ = new QComboBox;
  otherwise_->setObjectName(QStringLiteral("otherwise"));
  for (const AirspaceUse use : document::kAirspaceUses) {
    otherwise_->addItem(document::airspaceUseText(use), static_cast<int>(use));
  }
  choose(otherwise_, static_cast<int>(settings.otherwise));
  connect(otherwise_, &QComboBox::currentIndexChanged, this,
          [this] { settings_.otherwise = static_cast<AirspaceUse>(otherwise_->currentData().toInt()); });
  auto* form = new QFormLayout;
  form->addRow(tr("&All other classes:"), otherwise_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  QPushButton* addFiles = buttons->addButton(tr("Add airspace &files…"), QDialogButtonBox::ActionRole);
  addFiles->setAutoDefault(false);
  auto* column = new QVBoxLayout(this);
  column->addWidget(tree_, 1);
  column->addLayout(form);
  column->addWidget(hint_);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(addFiles, &QPushButton::clicked, this, &AirspaceDialog::addFilesRequested);
  connect(tree_, &QTreeWidget::itemExpanded, this, [this](QTreeWidgetItem* item) { addChoices(*item); });
  addKinds(airspaces, kinds, units);
  showHint(tree_->topLevelItemCount() == 0);
  resize(kSize);
}

void AirspaceDialog::addKinds(const std::vector<mission::Airspace>& airspaces, const std::vector<std::string>& found, const style::Units& units) {
  std::map<std::string, std::vector<const mission::Airspace*>> kinds;
  std::set<std::string> names;
  for (const mission::Airspace& airspace : airspaces) {
    kinds[airspace.kind].push_back(&airspace);
    names.insert(airspace.name);
  }
  for (const mission::AirspaceRule& rule : settings_.rules) {
    if (rule.name.empty()) {
      kinds.try_emplace(rule.kind);
    }
  }
  for (const std::string& kind : found) {
    kinds.try_emplace(kind);
  }
  for (const auto& [kind, members] : kinds) {
    QTreeWidgetItem* item = addKind(kind, static_cast<int>(members.size()));
    for (const mission::Airspace* airspace : members) {
      addAirspace(*item, *airspace, units);
    }
    const auto hasOwnRule = [this](const mission::Airspace* a) { return !a->name.empty() && ruleOf(settings_, {}, a->name); };
    item->setExpanded(std::any_of(members.begin(), members.end(), hasOwnRule));
  }
  for (const mission::AirspaceRule& rule : std::vector<mission::AirspaceRule>(settings_.rules)) {
    if (!rule.name.empty() && names.insert(rule.name).second) {
      auto* item = new QTreeWidgetItem(tree_, {tr("%1 (not shown)").arg(QString::fromStdString(rule.name))});
      addChoice(*item, {}, rule.name);
    }
  }
}

QTreeWidgetItem* AirspaceDialog::addKind(const std::string& kind, int count) {
  const QString title = count == 0 ? tr("Class %1: none near this terrain").arg(QString::fromStdString(kind))
                                   : tr("Class %1: %n airspace(s)", nullptr, count).arg(QString::fromStdString(kind));
  auto* item = new QTreeWidgetItem(tree_, {title});
  addChoice(*item, kind, {});
  return item;
}

void AirspaceDialog::addAirspace(QTreeWidgetItem& parent, const mission::Airspace& airspace, const style::Units& units) {
  const QString name = QString::fromStdString(airspace.name);
  const QString limits = document::airspaceText(airspace, units).back();
  for (int i = 0; i < parent.childCount(); ++i) {
    QTreeWidgetItem* other = parent.child(i);
    if (other->data(Name, kNameRole).toString() == name && !name.isEmpty()) {  // one rule serves all of a name
      other->setText(Limits, other->text(Limits) + QStringLiteral(", ") + limits);
      return;
    }
  }
  auto* item = new QTreeWidgetItem(&parent, {name.isEmpty() ? tr("without a name") : name, limits});
  item->setData(Name, kNameRole, name);
}

/// A choice that shows and changes one rule.
void AirspaceDialog::addChoice(QTreeWidgetItem& item, const std::string& kind, const std::string& name) {
  auto* box = new QComboBox;
  fill(*box, name.empty() ? tr("As all other classes") : tr("As its class"));
  const std::optional<AirspaceUse> use = ruleOf(settings_, kind, name);
  choose(box, use ? static_cast<int>(*use) : kAsClass);
  box->setAccessibleName(name.empty() ? tr("Class %1").arg(QString::fromStdString(kind)) : QString::fromStdString(name));
  item.setData(Name, kKindRole, QString::fromStdString(kind));
  item.setData(Name, kNameRole, QString::fromStdString(name));
  tree_->setItemWidget(&item, Use, box);
  box->setEnabled(!kind.empty() || !name.empty());  // what has neither only goes with the rest
  connect(box, &QComboBox::currentIndexChanged, this, [this, box, kind, name] {
    const int chosen = box->currentData().toInt();
    mission::setRule(settings_, kind, name, chosen == kAsClass ? std::nullopt : std::optional(static_cast<AirspaceUse>(chosen)));
  });
}

/// The choices of a class's airspaces, when they are first looked at: files have thousands.
void AirspaceDialog::addChoices(QTreeWidgetItem& parent) {
  for (int i = 0; i < parent.childCount(); ++i) {
    QTreeWidgetItem* item = parent.child(i);
    const std::string name = item->data(Name, kNameRole).toString().toStdString();
    if (!name.empty() && tree_->itemWidget(item, Use) == nullptr) {
      addChoice(*item, {}, name);
    }
  }
}

QComboBox* AirspaceDialog::choiceOf(const QString& kind, const QString& name) {
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = tree_->topLevelItem(i);
    if (item->data(Name, kKindRole).toString() != kind) {
      continue;
    }
    if (name.isEmpty()) {
      return qobject_cast<QComboBox*>(tree_->itemWidget(item, Use));
    }
    item->setExpanded(true);
    for (int k = 0; k < item->childCount(); ++k) {
      if (item->child(k)->data(Name, kNameRole).toString() == name) {
        return qobject_cast<QComboBox*>(tree_->itemWidget(item->child(k), Use));
      }
    }
  }
  return nullptr;
}

void AirspaceDialog::showHint(bool isEmpty) {
  hint_->setText(
      isEmpty ? tr("No airspaces yet. Add an OpenAir file here, with File > Add airspaces, or drop it on the window.")
              : tr("“Keep the tour out”: planning goes below, above or around, and a plan that enters is refused. “Warn when entered”: the plan "
                   "is made as if it were not there and the entry is named. Engine-out glides are never kept out, only named: an emergency "
                   "may enter. Flight levels count in a standard atmosphere (1013.25 hPa)."));
}

}  // namespace vp::dialogs
