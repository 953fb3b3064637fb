# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the tests of campaigns: a small one with something to find, in an empty folder.

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
programs=$(cd "$(dirname "$1")" && pwd)
PATH=$programs:$PATH
place=$(mktemp -d "${TMPDIR:-/tmp}/oplus_campaign_XXXXXX")
cd "$place"

# Closed sums only, and a hole lost where there is one. After five sums it waits where a file `pause`
# says so, until somebody has killed the shard.
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

# What all other ways to run it must come to.
one_run() {
  "${campaign[@]}" --report one.json --report one.md --report one.xml --out one >one.out ||
    [ $? -eq 1 ] || fail "the campaign in one run"
  grep -q '"kind": "hole lost"' one.json || fail "the campaign finds nothing"
}
