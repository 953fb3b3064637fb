# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by tests/run and properties/run: what they need of Debian 12, and how they get it.

# The main job: the programs `oplus`, `oplus-check`, `oplus-certified`, `oplus-proved` and `oplus-peer`.
packages=(g++ cmake ninja-build ccache python3
          libcgal-dev libgmp-dev libmpfr-dev libboost-dev libcli11-dev nlohmann-json3-dev rapidjson-dev
          libpolyclipping-dev librapidcheck-dev
          coq ocaml-nox ocaml-findlib libzarith-ocaml-dev
          help2man)  # manual pages
# More for tests/run.
packages_of_tests=(clang libclang-rt-14-dev git clang-format make time libgtest-dev libbenchmark-dev
                   jq parallel zsh fish z3 cvc5 python3-yaml
                   pybind11-dev python3-dev python3-numpy python3-shapely python3-pytest
                   python3-hypothesis python3-matplotlib python3-geopandas python3-tqdm mypy)
# More for tests/run --everything.
packages_of_everything=(gnuplot-nox
                        build-essential pkgconf mmdebstrap debhelper dh-python lintian ruby doxygen python3-sphinx python3-breathe
                        python3-myst-parser furo nodejs python3-pip python3-skbuild python3-venv
                        python3-nbclient python3-ipykernel
                        emscripten js-of-ocaml chromium chromium-driver python3-selenium
                        rustc luajit node-typescript npm)

# Installs what is missing. Asks nothing; says what it installs.
install_missing_packages() {
  if ! command -v dpkg-query >/dev/null; then
    echo "not a Debian system, so nothing is installed; needed: ${packages[*]}" >&2
    return 0
  fi
  local package there missing=()
  # Also what an installed package provides.
  there=$(dpkg-query -W -f '${db:Status-Status} ${Package}, ${Provides},\n' |
            sed -n 's/^installed/,/p' | tr '\n' ' ')
  for package in "${packages[@]}"; do
    [[ $there == *" $package,"* ]] || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0

  local as_root=(env)
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null || ! sudo -n true 2>/dev/null; then
      echo "missing, and neither root nor sudo without a password: ${missing[*]}" >&2
      echo "as root: apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo -n env)
  fi
  echo "installing ${missing[*]}"
  as_root+=(DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0)
  "${as_root[@]}" update &&
    "${as_root[@]}" install --yes --no-install-recommends "${missing[@]}" </dev/null >/dev/null
}

# line_of_sources TYPE [SUITE]: the line of apt's sources.list, with deb or deb-src, for a suite of Debian, by default this
# system's; from where this machine has its packages. A file of sources has one of two forms, and apt reads both.
line_of_sources() {
  local own address
  own=$(. /etc/os-release && echo "${VERSION_CODENAME-}")
  address=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' "Release: $own" 'Component: main' | sed -n 1p)
  [ -n "$address" ] || { echo "apt has no packages of Debian $own" >&2; return 1; }
  echo "$1 [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $address ${2-$own} main"
}

# make_system SUITE FOLDER [OPTION...]: a system of Debian of its own, by mmdebstrap, as root. apt gets a file descriptor in it
# that a shell must name with one digit, so what is open here is closed there: GNU time, for one, leaves its output open.
make_system() {
  local sources
  sources=$(line_of_sources deb "$1") || return
  mmdebstrap --mode=root --variant=apt --dpkgopt=force-unsafe-io --aptopt='Acquire::Languages "none"' "${@:3}" \
    "$1" "$2" "$sources" 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&-
}

# unpack_source PACKAGE FOLDER: what Debian's package is made from, into FOLDER/source. By apt, which checks signatures,
# with lists of its own, since most machines list no sources.
unpack_source() (
  mkdir -p "$2"/{apt/lists/partial,apt/cache/archives/partial,source}
  cd "$2"
  apt=(apt-get -qq -o Dir::Etc::sourcelist="$2/sources.list" -o Dir::Etc::sourceparts=-
       -o Dir::State::lists="$2/apt/lists" -o Dir::Cache="$2/apt/cache"
       -o APT::Sandbox::User="$(id -un)")
  line_of_sources deb-src >sources.list
  "${apt[@]}" update
  "${apt[@]}" source --download-only "$1"
  tar xf "$1"_*.orig.tar.?z -C source --strip-components=1
  # Debian leaves manuals out that are not free; configure asks for them.
  mkdir -p source/doc
  [ -f source/doc/Makefile.in ] || printf 'all install:\n' >source/doc/Makefile.in
)

# Clones in different folders share the cache. Without a writable cache ccache is disabled.
set_up_ccache() {
  command -v ccache >/dev/null || return 0
  export CCACHE_BASEDIR=$1 CCACHE_NOHASHDIR=1
  local cache
  cache=$(ccache --get-config cache_dir 2>/dev/null) && mkdir -p "$cache" 2>/dev/null &&
    [ -w "$cache" ] || export CCACHE_DISABLE=1
}
