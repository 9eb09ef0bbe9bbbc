#!/usr/bin/env bash
# Builds the programs that pairs.py compares with and that no Debian package has, from checkouts of their sources:
#     tests/bench/rivals/build.sh IPOL_59 RESYNTHESIZER FOLDER
# IPOL_59 is github.com/ipol-journal/59, RESYNTHESIZER github.com/bootchk/resynthesizer; the programs are written to FOLDER.
# Needs gcc, libpng-dev, liblapack-dev.
set -euo pipefail
if (($# != 3)); then
  sed -n '2,5s/^# \?//p' "$0" >&2
  exit 2
fi
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
accelerated=$1/efros_leung_v1.0/efros_leung_accel
engine=$2/lib
mkdir -p "$3"
flags=(-O3 -march=native -w)

gcc "${flags[@]}" -fopenmp -I "$accelerated/inc" "$accelerated"/src/*.c -o "$3/efros_leung" -lpng -llapack -lblas -lm

# One thread, as pairs.py measures: the engine's own switches for threads are turned off in a copy of it.
copy=$(mktemp -d)
trap 'rm -r "$copy"' EXIT
cp "$engine"/*.[ch] "$copy"
sed -i -E 's/^#define (SYNTH_THREADED|SYNTH_USE_GLIB_THREADS)\b.*/#undef \1/' "$copy/buildSwitches.h"
gcc "${flags[@]}" -DSYNTH_LIB_ALONE -I "$copy" "$here/resynthesizer.c" "$copy"/{imageSynth,engine,glibProxy,engineParams,imageFormat,progress}.c \
  -o "$3/resynthesizer" -lm
echo "Built $3/efros_leung and $3/resynthesizer."
