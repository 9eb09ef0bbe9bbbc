#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"
#include "core/render/camera.h"
#include "core/render/environment.h"
#include "core/render/material.h"
#include "core/render/render_mesh.h"

namespace texloom {

/// What of a material is shown: lit, or one of its maps alone.
enum class Shown { Lit, Color, Normal, Roughness, Metallic, Occlusion, Height, Opacity };

/// What is seen beside the mesh and through it.
enum class Backdrop { Environment, Grey, Nothing };

/// How a material is looked at.
struct Look {
    Camera camera;
    float repeat = 1;    ///< how often the maps lie where they lie once
    float relief = 0;    ///< from the lowest height to the highest, as a share of the maps' side; 0 to 0.3
    float lightTurn = 0; ///< of the environment around the vertical axis, in radians
    float exposure = 0;  ///< in stops
    Shown shown = Shown::Lit;
    Backdrop backdrop = Backdrop::Grey;
    int samples = 1; ///< along each side of a pixel; 1 to 4
};

/// A mesh with a material, lit from all around: red, green and blue, linear in the working space and not
/// premultiplied, and opacity. Surfaces are those of GGX, lit by the split sum with the energy of several
/// bounces (Karis 2013; Fdez-Agüera 2019); what lies in the height map is met along the line of sight
/// (Policarpo et al. 2005). The same bits for any number of threads. @param size at least 1 × 1 px. @throws
/// Cancelled
Image rendered(const RenderMesh& mesh, const MaterialTexture& material, const Environment& light,
               const Look& look, Size size, JobContext& context);

} // namespace texloom
