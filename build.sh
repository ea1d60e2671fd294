#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Sets frana up on a bare Debian 12 and builds it: see usage below.
set -euo pipefail
cd "$(dirname "$0")"

# libvtk9-dev depends on VTK's Java and Python bindings (270 MB of Java that frana does not use): Debian has its headers in no
# smaller package. gettext: msgfmt compiles the texts of other languages (share/po).
packages=(
  g++ cmake ninja-build pkg-config ca-certificates gettext
  libgdal-dev libproj-dev proj-data libeigen3-dev
  libosmesa6-dev libvtk9-dev libcairo2-dev libpango1.0-dev libpng-dev fonts-dejavu-core libjs-leaflet
  libavformat-dev libavcodec-dev libswscale-dev libavutil-dev
  libboost-program-options-dev nlohmann-json3-dev zlib1g-dev libxxhash-dev libgtest-dev
  libopenturns-dev
  libopenmpi-dev openmpi-bin
)
# Kernels' instructions (.ci/kernel_instructions); layout of the source; readers of what frana writes;
# the Python module.
test_packages=(valgrind clang-format-14 poppler-utils
  python3-jsonschema zsh man-db mandoc chromium
  pybind11-dev python3-dev python3-numpy python3-gdal qgis python3-qgis qgis-providers)

# To make Debian packages.
package_packages=(dpkg-dev file pybind11-dev python3-dev python3-numpy)

usage() {
  cat <<END
usage: ./build.sh build | demo | test | package
  build     installs what the build needs, builds build/frana
  demo      the same, then computes the sample into results/bindo
  test      installs what tests need, builds everything, runs every test
  package   builds build/packages/*.deb
END
}

say() { printf '== %s\n' "$*"; }

# install_packages NAME...: those that are missing.
install_packages() {
  local missing=() name
  for name in "$@"; do
    dpkg-query -W -f='${Status}' "$name" 2>/dev/null | grep -q 'install ok installed' || missing+=("$name")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    say "all Debian packages are there"
    return
  fi
  local root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "build.sh: run as root or install sudo; missing packages: ${missing[*]}" >&2; exit 4; }
    root=(sudo)
  fi
  say "installing ${missing[*]}"
  "${root[@]}" apt-get update -qq
  # apt tells what it fetches: on a bare machine that takes minutes.
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

# configure_and_build TARGET...: Release, into build/. What a command needs is decided here and not by what an earlier
# command left in build/: tests and python, ON or OFF.
configure_and_build() {
  say "building $* into build/ (Release)"
  cmake --preset release -DFRANA_TESTS="$tests" -DFRANA_PYTHON="$python" >build.log 2>&1 || { cat build.log; exit 1; }
  rm -f build.log
  cmake --build build --target "$@"
}

build() {
  tests=OFF python=OFF configure_and_build frana
  say "built build/frana"
}

demo() {
  tests=OFF python=OFF configure_and_build frana
  say "running the sample scene: a hillside after Bindo-Cortenova 2002, on synthetic terrain"
  build/frana run sample_data/bindo/scene.ini --out results/bindo --overwrite
  say "done; look at results/bindo/maps/max_depth.png, results/bindo/animation.mp4 and, in QGIS, results/bindo/result.qgz"
}

package() {
  tests=OFF python=ON configure_and_build packages
  say "built build/packages/*.deb; install them with apt-get install ./build/packages/*.deb"
}

run_tests() {
  tests=ON python=ON configure_and_build all
  say "running the tests"
  local report=build/test-report.txt status=0
  .ci/kernel_instructions build
  (cd build && ctest --output-on-failure --parallel 2 --timeout 600) >"$report" 2>&1 || status=$?
  # Everything but the thousand lines that say nothing: failures in full, then what was skipped and why.
  grep -vE '^ +Start +[0-9]+:|^ *[0-9]+/[0-9]+ Test .* Passed +[0-9.]+ sec$' "$report" || true
  local total failed skipped
  total=$(grep -cE '^ *[0-9]+/[0-9]+ Test +#' "$report" || true)
  skipped=$(grep -cE '^ *[0-9]+/[0-9]+ Test .*\*\*\*Skipped' "$report" || true)
  failed=$(grep -cE '^ *[0-9]+/[0-9]+ Test .*\*\*\*(Failed|Timeout|Exception|Not Run)' "$report" || true)
  if [ "$total" -eq 0 ]; then
    echo "build.sh: no test was run" >&2
    echo "0 passed, 1 failed"
    exit 1
  fi
  [ "$status" -eq 0 ] || [ "$failed" -gt 0 ] || failed=1
  if [ "$skipped" -gt 0 ]; then
    say "$skipped skipped; how many for which reason:"
    grep -hE -A1 '^left out: |: Skipped$' build/Testing/Temporary/LastTest.log | grep -vE ': Skipped$|^--$|^<end of output>$' |
      sort | uniq -c || true
  fi
  echo "$((total - failed - skipped)) passed, $failed failed"
  [ "$failed" -eq 0 ]
}

case "${1:-}" in
  build) install_packages "${packages[@]}"; build ;;
  demo) install_packages "${packages[@]}"; demo ;;
  test) install_packages "${packages[@]}" "${test_packages[@]}"; run_tests ;;
  package) install_packages "${packages[@]}" "${package_packages[@]}"; package ;;
  -h | --help | help) usage ;;
  *) usage >&2; exit 2 ;;
esac
