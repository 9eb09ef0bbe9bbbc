#!/usr/bin/env bash
# Makes own.safetensors again, bit for bit: learn.sh PATH-TO-texloom-cli [OUTPUT]
# Learned from the bundled exemplars alone, all of which are CC0 or in the public domain.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cli=$1
output=${2:-$here/own.safetensors}
cd "$here/../exemplars"
"$cli" learn-descriptor brick_pavement_gray.png crazy_paving.png grass_dry_gray.png gravel_gray.png \
  herringbone_paving.exr plank_wall_dark.png railway_ballast.png riveted_metal_stained/riveted_metal_stained_albedo.png \
  rock_strata_large.jpg sand_ripples.png soil_clods.png solar_cells_blue.jpg sunrise_meadow.exr \
  --output "$output" --overwrite --seed 1 --name own --licence CC0-1.0 \
  --credit "Learned by Texloom from its bundled exemplars (resources/exemplars/PROVENANCE.tsv)"
