#pragma once

#include "ui/briefing/briefing_options.h"
#include "ui/briefing/briefing_source.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <vector>

namespace vp::briefing {

/** A column of a table. Text is set flush left and may be broken into lines, numbers are set flush right and never broken. */
struct Column {
  QString head;  ///< lines separated by newlines
  bool isText = false;
  bool isWhole = false;  ///< text that is never broken
};

struct Row {
  QStringList cells;
  bool startsGroup = false;  ///< a rule above it
  bool isStrong = false;
};

struct Table {
  QString title;
  QString note;  ///< below the title; may be empty
  std::vector<Column> columns;
  std::vector<Row> rows;
};

/** A name and what is said about it. */
struct Fact {
  QString name;
  QString value;
};

/** A glide that is drawn: from the worst place of a diversion. */
struct GlideCaption {
  double distance = 0.0;  ///< m along the tour
  QString title;
  std::vector<Fact> facts;
};

/** All that a briefing says, in order, as text and rows. Independent of paper and drawing.
 *  Runways in use are called by letters in the order in which the tour first needs them. */
struct BriefingContent {
  bool isVerified = false;
  bool isCalm = true;  ///< no wind in the plan
  QString title;
  QString date;       ///< "24 Nov 2026"
  QString verdict;    ///< "VERIFIED SAFE" or why not
  QString statement;  ///< of the certificate, or what is wrong
  std::vector<Fact> facts;
  Table sources;
  Table runways;
  Table targets;
  Table legs;
  Table engineOut;
  Table margins;
  Table findings;   ///< no rows: nothing to say
  Table airspaces;  ///< the same
  std::vector<GlideCaption> glides;
  QStringList assumptions;
  std::vector<Fact> abbreviations;
  std::vector<int> letterOf;  ///< by site; -1: not used
};

BriefingContent briefingContent(const BriefingSource& source, const BriefingOptions& options);

/** Parts of briefingContent(): the tables that come from the figures. */
void addTables(BriefingContent& content, const BriefingSource& source, const BriefingOptions& options);

}  // namespace vp::briefing
