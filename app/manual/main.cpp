// volplane-manual MARKDOWN_FOLDER OUTPUT_FOLDER: writes the manual as web pages (html/) and as volplane-manual.pdf.
#include "ui/help/manual_html.h"
#include "ui/help/manual_pdf.h"

#include <QDir>
#include <QGuiApplication>

#include <cstdio>

int main(int argc, char** argv) {
  const QGuiApplication application(argc, argv);
  const QStringList arguments = QCoreApplication::arguments();
  if (arguments.size() != 3) {
    std::fprintf(stderr, "usage: volplane-manual MARKDOWN_FOLDER OUTPUT_FOLDER\n");
    return 2;
  }
  const QDir output(arguments[2]);
  const QString version = QStringLiteral("Volplane " VOLPLANE_VERSION);
  const auto written = vp::help::Manual::open(arguments[1]).and_then([&](const vp::help::Manual& manual) -> vp::Result<void> {
    if (const vp::Result<void> html = vp::help::writeManualHtml(manual, output.filePath(QStringLiteral("html")), version); !html) {
      return html;
    }
    return vp::help::writeManualPdf(manual, output.filePath(QStringLiteral("volplane-manual.pdf")), version);
  });
  if (!written) {
    std::fprintf(stderr, "volplane-manual: %s\n", written.error().message().c_str());
    return 2;
  }
  return 0;
}
