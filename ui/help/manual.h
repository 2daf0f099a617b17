#pragma once

#include "core/base/result.h"
#include "ui/help/markdown.h"

#include <QString>

#include <vector>

namespace vp::help {

/** A chapter as the contents name it. */
struct Chapter {
  QString file;   ///< without ending: "map"
  QString title;  ///< as in the contents
};

/** The manual as it lies in a folder: index.md, chapters and pictures. Pages are read when they are asked for. */
class Manual {
public:
  /** Reads the contents.
   *  @errors BadFile - no such folder, or no index.md in it; BadFormat - contents that name no chapter */
  static Result<Manual> open(const QString& folder);

  /** The folder of the manual that came with the program, in VOLPLANE_RESOURCES, ../share/volplane beside the program, or the source tree;
   *  empty if there is none. */
  static QString bundledFolder();

  [[nodiscard]] const QString& folder() const { return folder_; }
  [[nodiscard]] const QString& title() const { return title_; }
  /** In the order of the contents; the contents themselves are not among them. */
  [[nodiscard]] const std::vector<Chapter>& chapters() const { return chapters_; }

  /** A chapter, or the contents ("index").
   *  @errors BadFile - there is no such page */
  [[nodiscard]] Result<Page> page(const QString& file) const;

private:
  QString folder_;
  QString title_;
  std::vector<Chapter> chapters_;
};

}  // namespace vp::help
