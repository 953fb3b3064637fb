# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the tests of campaigns: a small one with something to find, in an empty folder.

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
programs=$(cd "$(dirname "$1")" && pwd)
PATH=$programs:$PATH
place=$(mktemp -d "${TMPDIR:-/tmp}/oplus_campaign_XXXXXX")
cd "$place"

# Computes closed sums and loses their holes. If there is a file `pause`, it waits after five sums until
# the shard is killed.
cat >loses_holes <<'ENGINE'
#!/usr/bin/env bash
if [ -e pause ]; then
  echo sum >>calls
  if [ "$(wc -l <calls)" -ge 5 ]; then
    echo $$ >waiting.pid
    mv waiting.pid waiting
    exec sleep 600
  fi
fi
oplus sum "$1" "$2" --format wkt | sed 's/), (.*))$/))/'
ENGINE
chmod +x loses_holes
campaign=(oplus-check conformance --engine 'exec:./loses_holes {p} {q}' --time-limit 500
          --part grids --part families --cases 2 --shrink 40)

fail() {
  echo "$*" >&2
  exit 1
}

# one_run FOLDER: writes the reports that all other ways to run it must write, too. They contain the name
# of the folder of counterexamples, which is then moved to `one`.
one_run() {
  "${campaign[@]}" --report one.json --report one.md --report one.xml --out "$1" >one.out ||
    [ $? -eq 1 ] || fail "the campaign in one run"
  grep -q '"kind": "hole lost"' one.json || fail "the campaign finds nothing"
  mv "$1" one
}
