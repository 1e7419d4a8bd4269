#!/usr/bin/env bash
# Does what the README says of one's own problems: write a corpus, run it, read the rows.
#   bring_your_own.sh LCPBENCH WRITER     WRITER, a program or a .py, writes mine.hdf5
set -euo pipefail
examples=$(cd "$(dirname "$0")" && pwd)
lcpbench=$1
writer=$2
python=
for each in python3 /usr/bin/python3; do  # a python that hides Debian's may lack its packages
  if "$each" -c 'import h5py, pandas' 2>/dev/null; then python=$each; break; fi
done
if [ -z "$python" ]; then
  echo "skipped: python3-h5py and python3-pandas are not installed (scripts/setup installs them)"
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
if [[ $writer == *.py ]]; then "$python" "$writer"; else "$writer"; fi
"$lcpbench" run --corpus mine.hdf5 --solver best-first --solver lemke --out runs/mine >/dev/null
printed=$("$python" "$examples/read_run.py")
echo "$printed"
[ "$(wc -l <runs/mine/rows.jsonl)" = 20 ]
grep -Eq 'best-first +solved +10' <<<"$printed"
