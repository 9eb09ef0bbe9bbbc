#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"
#include "core/render/environment.h"
#include "core/render/look.h"
#include "core/render/material.h"
#include "core/render/render_mesh.h"

namespace texloom {

/// A mesh with a material, lit from all around: red, green and blue, linear in the working space and not
/// premultiplied, and opacity. Surfaces are those of GGX, lit by the split sum with the energy of several
/// bounces (Karis 2013; Fdez-Agüera 2019); what lies in the height map is met along the line of sight
/// (Policarpo et al. 2005). The same bits for any number of threads. @param size at least 1 × 1 px. @throws
/// Cancelled
Image rendered(const RenderMesh& mesh, const MaterialTexture& material, const Environment& light,
               const Look& look, Size size, JobContext& context);

} // namespace texloom
