#!/usr/bin/env bash
# Does what the README says of one's own problems: write a corpus, run it, read the rows.
#   bring_your_own.sh LCPBENCH WRITER...     WRITER writes mine.hdf5 into the current folder
set -euo pipefail
examples=$(cd "$(dirname "$0")" && pwd)
lcpbench=$1
shift
if ! python3 -c 'import h5py, pandas' 2>/dev/null; then
  echo "skipped: python3-h5py and python3-pandas are not installed (scripts/setup installs them)"
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$@"
"$lcpbench" run --corpus mine.hdf5 --solver best-first --solver lemke --out runs/mine >/dev/null
printed=$(python3 "$examples/read_run.py")
echo "$printed"
[ "$(wc -l <runs/mine/rows.jsonl)" = 20 ]
grep -Eq 'best-first +solved +10' <<<"$printed"
