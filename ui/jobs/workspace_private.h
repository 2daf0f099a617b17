#pragma once

#include "core/formats/mission_loader.h"
#include "core/tour/replan.h"
#include "ui/document/mailbox.h"
#include "ui/jobs/file_stamp.h"
#include "ui/jobs/job_runner.h"
#include "ui/jobs/workspace.h"

#include <QTimer>

#include <array>

namespace vp::jobs {

/** The desk's jobs and what they brought; one runner for each kind of work. Of workspace*.cpp only. */
class Workspace::Private {
public:
  explicit Private(Workspace& workspace);

  // workspace.cpp
  void documentReplaced();
  void missionChanged();
  void publish();
  void refreshActivity();
  [[nodiscard]] tour::PlanInput planInput() const;
  [[nodiscard]] Result<void> readyToPlan();
  void planned(const Result<struct PlannedTour>& result, double seconds);
  [[nodiscard]] std::array<JobRunner*, 7> jobs();

  // workspace_loading.cpp
  void loadTerrain();
  void terrainLoaded(struct TerrainResult result);
  void clearGround();
  void loadSites();
  void sitesLoaded(Result<struct GroundResult> ground);
  void airspacesLoaded(formats::LoadedAirspaces loaded);
  void placeTargets();
  void placeWeather();
  void loadPopulation();
  void viewPlan();
  void refreshPlanState();
  void tellNotes();

  // workspace_glides.cpp
  void dropGlides();
  void planRoadmap();
  void buildRoadmap();
  void buildField(int cells);
  void pauseGlides();

  Workspace& self;
  document::MissionDocument document;
  document::ViewState view;
  document::Situation situation;
  Activity activity = Activity::Idle;
  QStringList notes;

  mission::Mission shown;  ///< what the loaded parts belong to
  bool isReplaced = false;
  formats::LoadedTerrain terrain;
  std::vector<FileStamp> terrainStamps;  ///< of the files as they were read
  std::optional<Error> terrainError;
  std::optional<Error> sitesError;
  std::vector<mission::SiteInFrame> usable;
  QStringList siteNotes;
  QStringList populationNotes;
  std::shared_ptr<const mission::Plan> viewedPlan;  ///< that situation.plan was made from
  std::shared_ptr<const document::TerrainData> viewedTerrain;

  std::shared_ptr<const landing::World> world;
  std::shared_ptr<const landing::Roadmap> roadmap;
  geo::Box roadmapArea;  ///< of the roadmap that is there or being built
  QTimer roadmapDelay;   ///< gathers edits that follow each other
  mutable landing::QueryScratch scratch;
  bool fieldWanted = false;
  int fieldCells = 0;  ///< fineness of situation.safeAltitudes
  bool planStopped = false;
  std::shared_ptr<tour::Planner> planner = std::make_shared<tour::Planner>();  ///< of planJob alone; a forgotten job keeps its own

  JobRunner terrainJob;
  JobRunner sitesJob;
  JobRunner populationJob;
  JobRunner viewJob;
  JobRunner roadmapJob;
  JobRunner fieldJob;
  document::Mailbox mailbox;  ///< of planJob, which ends before it does
  JobRunner planJob;
};

}  // namespace vp::jobs
