#!/usr/bin/env bash
# Installs what Texloom needs, builds it and opens it; without a display it synthesises a sample instead.
#     packaging/run.sh [--without-networks] [FILE...]
# --without-networks leaves out the methods that train or use networks; files are opened.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

networks=ON
if [[ ${1:-} == --without-networks ]]; then
  networks=OFF
  shift
fi

installPackages
(buildPreset release -D "TEXLOOM_NETWORKS=$networks")

bin=$root/build/release/bin
if [[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
  exec "$bin/texloom" "$@"
fi
out=$PWD/texloom_result.png
"$bin/texloom-cli" synth quilting "$root/resources/exemplars/crazy_paving.png" --size 768x768 --seed 1 -o "$out"
echo "There is no display to open a window on, so Texloom synthesised a sample: $out"
