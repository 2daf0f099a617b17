// volplane-cli brief PLAN -o FILE.pdf: the briefing for the kneeboard, from the plan file and the terrain read afresh.
#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "app/cli/verification.h"
#include "core/formats/atomic_file.h"
#include "core/formats/plan_file.h"
#include "core/geo/magnetic_field.h"
#include "ui/briefing/write_briefing.h"

#include <CLI/CLI.hpp>
#include <QFont>
#include <QGuiApplication>
#include <QHashFunctions>
#include <QTemporaryDir>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <clocale>
#include <memory>
#include <optional>
#include <string>

namespace vp::cli {
namespace {

struct BriefArguments {
  std::string plan;
  std::string output;
  std::string paper = "a4";
  std::string units = "aviation";
  std::string date;
  bool monochrome = false;
  bool unverified = false;
};

/// "2026-11-24"; nothing if that is no day.
std::optional<std::chrono::year_month_day> dayOf(const std::string& text) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  const char* const end = text.data() + text.size();
  const auto number = [end](const char* from, std::size_t digits, auto& value) {
    return static_cast<std::size_t>(end - from) >= digits && std::from_chars(from, from + digits, value).ptr == from + digits;
  };
  if (text.size() != 10 || text[4] != '-' || text[7] != '-' || !number(text.data(), 4, year) || !number(text.data() + 5, 2, month) ||
      !number(text.data() + 8, 2, day)) {
    return std::nullopt;
  }
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
  return date.ok() ? std::optional(date) : std::nullopt;
}

/// What the checker refused is not briefed silently.
int refuse(const BriefArguments& arguments, const Common& common, const briefing::BriefingSource& source) {
  if (common.json) {
    fmt::print("{}", reportToJson(*source.plan, source.report));
  } else {
    printReport(*source.plan, source.report);
  }
  fmt::print(
      stderr,
      "volplane-cli: {}: not briefed, because the plan is not safe; plan the mission again (or add --unverified to brief it all the same, marked "
      "on every page)\n",
      arguments.plan);
  return kVerificationFailed;
}

int writeFile(const BriefArguments& arguments, const Common& common, const briefing::BriefingSource& source, const QByteArray& pdf) {
  const std::string_view content(pdf.constData(), static_cast<std::size_t>(pdf.size()));
  if (const Result<void> written = formats::writeFileAtomically(arguments.output, content); !written) {
    return report(written.error(), common.json);
  }
  const int pages = briefing::pageCount(pdf);
  if (common.json) {
    fmt::print("{}", jsonText(nlohmann::ordered_json{
                         {"file", arguments.output}, {"pages", pages}, {"bytes", pdf.size()}, {"verified", source.report.isSafe()}}));
  } else if (!common.quiet) {
    fmt::print("briefing of {} pages written to {}\n", pages, arguments.output);
  }
  return kDone;
}

int runBrief(const BriefArguments& arguments, const Common& common) {
  const std::optional<std::chrono::year_month_day> date = arguments.date.empty() ? geo::today() : dayOf(arguments.date);
  if (!date) {
    return report(Error{Errc::OutOfRange, "is no date; write it as 2026-11-24", arguments.date}, common.json);
  }
  QHashSeed::setDeterministicGlobalSeed();  // Qt writes fonts in the order of a hash: the same plan shall give the same bytes
  qputenv("QT_QPA_PLATFORM", "offscreen");  // no display is needed, and none is asked for
  const QTemporaryDir runtime;
  if (qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR")) {
    qputenv("XDG_RUNTIME_DIR", runtime.path().toLocal8Bit());  // where nobody logged in; Qt would say so on every run
  }
  int argc = 1;
  char name[] = "volplane-cli";
  char* argv[] = {name, nullptr};
  const QGuiApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");  // QGuiApplication has taken the user's; libraries that read and write files want a point
  QGuiApplication::setFont(QFont(QStringLiteral("DejaVu Sans")));
  Console console(!common.quiet && !common.json);
  const Result<mission::Plan> plan = formats::readPlan(arguments.plan);
  if (!plan) {
    return report(plan.error(), common.json);
  }
  const Result<briefing::BriefingSource> source = briefing::briefingSource(*plan, folderOf(arguments.plan), *date, console.job().part(0.0, 0.6));
  if (!source) {
    console.finishProgress();
    return report(source.error(), common.json);
  }
  if (!source->report.isSafe() && !arguments.unverified) {
    console.finishProgress();
    return refuse(arguments, common, *source);
  }
  briefing::BriefingOptions options;
  options.paper = arguments.paper == "letter" ? briefing::Paper::Letter : briefing::Paper::A4;
  options.units = style::Units(arguments.units == "metric" ? style::UnitSystem::Metric : style::UnitSystem::Aviation);
  options.monochrome = arguments.monochrome;
  options.date = *date;
  options.program = QString::fromStdString(programVersion());
  const Result<QByteArray> pdf = briefing::writeBriefing(*source, options, console.job().part(0.6, 1.0));
  console.finishProgress();
  if (!pdf) {
    return report(pdf.error(), common.json);
  }
  if (!source->report.isSafe()) {
    fmt::print(stderr, "volplane-cli: warning: {} is UNVERIFIED: no one has shown that a glide to a runway exists from every point of it\n",
               arguments.plan);
  }
  return writeFile(arguments, common, *source, *pdf);
}

}  // namespace

void addBriefCommand(CLI::App& app, Common& common, int& status) {
  auto arguments = std::make_shared<BriefArguments>();
  CLI::App* command = app.add_subcommand("brief", "Write a briefing for the kneeboard as PDF, after verifying the plan again; needs no display");
  command->add_option("plan", arguments->plan, "Plan file (*.vpp)")->required();
  command->add_option("-o,--output", arguments->output, "PDF file to write")->required();
  command->add_option("--paper", arguments->paper, "a4 or letter")->check(CLI::IsMember({"a4", "letter"}));
  command->add_option("--units", arguments->units, "aviation (feet, nautical miles, knots) or metric")->check(CLI::IsMember({"aviation", "metric"}));
  command->add_option("--date", arguments->date, "Day of the flight, YYYY-MM-DD: printed, and decides the magnetic variation; today if absent");
  command->add_flag("--monochrome", arguments->monochrome, "Pictures in greys, for printers without colour");
  command->add_flag("--unverified", arguments->unverified, "Brief even a plan that cannot be verified, marked on every page");
  command->callback([arguments, &common, &status] { status = runBrief(*arguments, common); });
}

}  // namespace vp::cli
