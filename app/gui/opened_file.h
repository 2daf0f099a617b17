#pragma once

#include "core/base/result.h"
#include "ui/document/document_files.h"
#include "ui/document/document_lock.h"
#include "ui/jobs/file_stamp.h"

#include <QString>

#include <memory>
#include <vector>

namespace vp::gui {

/** A document that a worker has read, with the lock that it has taken for it. */
struct OpenedFile {
  document::DocumentContents contents;
  std::shared_ptr<document::DocumentLock> lock;  ///< never null
  document::DocumentLock::Outcome outcome = document::DocumentLock::Outcome::Without;
  std::vector<jobs::FileStamp> stamps;  ///< of the mission file and its plan before they were read
};

/** Reads a .vpm or .vpp and locks its mission file. @errors of the readers  @threads pure */
Result<OpenedFile> openFile(const QString& path);

/** What is to be saved where, and what must not be run over. */
struct SaveOrder {
  document::DocumentContents snapshot;
  QString path;  ///< absolute
  bool withPlan = false;
  bool evenIfOpenElsewhere = false;
  bool evenIfChanged = false;
  std::shared_ptr<document::DocumentLock> lock;  ///< of the document shown; may be null
  std::vector<jobs::FileStamp> expected;         ///< mission file and plan as they were last read or written here; empty: neither was
};

/** Saved, or why the operator has to be asked first. */
struct WrittenFile {
  bool isWritten = false;
  std::shared_ptr<document::DocumentLock> lock;  ///< of `path`; its owner if the mission is open elsewhere
  bool isOpenElsewhere = false;                  ///< else it was changed on disk
  std::vector<jobs::FileStamp> stamps;           ///< after writing
};

/** Locks and writes. Nothing is written if the operator has to be asked. @errors as document::writeDocument()  @threads pure */
Result<WrittenFile> saveFile(const SaveOrder& order);

}  // namespace vp::gui
