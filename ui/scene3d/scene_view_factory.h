#pragma once

#include "ui/scene3d/scene_view.h"

#include <QSurfaceFormat>

namespace vp::scene3d {

/** How 3D can be drawn here. */
enum class SceneHost { OpenGlWidget, Images };

/** What this platform bears: an OpenGL widget needs a windowing system on which Qt composes them, and a context with fixed
 *  functions. Everywhere else pictures are drawn off screen; where that fails too the view says why.
 *  The environment variable VOLPLANE_3D (widget, images) overrides, for machines whose drivers lie.
 *  @param isSoftware  receives whether the processor draws; may be null */
SceneHost sceneHost(bool* isSoftware = nullptr);

/** The 3D view that this machine can show. Never fails, never ends the process. */
SceneView* createSceneView(document::ViewState& state, QWidget* parent);

/** The format that a context for the scene needs: 2.1 without a profile, which has the fixed functions. */
QSurfaceFormat sceneFormat(bool isSoftware);

}  // namespace vp::scene3d
