#!/usr/bin/env bash
# Installs what is missing (Debian 12, apt) and builds the program into build/. Safe to run again.
# setup.sh PACKAGE...: installs these packages, too.
set -euo pipefail
cd "$(dirname "$0")"

packages=(g++ cmake ninja-build libdeal.ii-dev gmsh libopenblas0-pthread numdiff gnuplot-nox python3 dpkg-dev file "$@")
missing=()
start=$SECONDS
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
  sudo=""
  [ "$(id -u)" = 0 ] || sudo=sudo
  $sudo apt-get update
  DEBIAN_FRONTEND=noninteractive $sudo apt-get install -y --no-install-recommends "${missing[@]}"
fi

installed=$SECONDS
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release >build-configure.log 2>&1 || { cat build-configure.log; exit 1; }
rm -f build-configure.log
cmake --build build
echo "installed in $((installed - start)) s, built in $((SECONDS - installed)) s"
