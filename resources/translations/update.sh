#!/usr/bin/env bash
# Brings texloom_de.ts and texloom_fr.ts up to date with the sources; what is new in them is to be translated.
# --check changes nothing and fails if a text has no translation.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
lupdate=$(command -v lupdate-qt6 || command -v /usr/lib/qt6/bin/lupdate || command -v lupdate)

python3 "$here/collect_core.py" "$root" "$work/core_texts.cpp"
cp "$here"/texloom_*.ts "$work" 2>/dev/null || true
for language in de fr; do
  "$lupdate" -silent -I "$root" -no-obsolete -locations none -source-language en -target-language "$language" \
    "$root/ui" "$root/app/gui" "$work/core_texts.cpp" -ts "$work/texloom_$language.ts"
done
if [[ ${1:-} == --check ]]; then
  status=0
  for file in "$work"/texloom_*.ts; do
    if count=$(grep -c 'type="unfinished"' "$file"); then
      echo "$(basename "$file"): $count texts have no translation; run resources/translations/update.sh" >&2
      grep -B 2 'type="unfinished"' "$file" | grep '<source>' | head -5 >&2
      status=1
    fi
  done
  exit $status
fi
cp "$work"/texloom_*.ts "$here"
