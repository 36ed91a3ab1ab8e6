#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Gets what a build needs: set_up.sh sweep|tests
# On Debian and Ubuntu it asks dpkg which packages are missing, prints them, and installs only these with apt-get. On other
# systems it names the packages and goes on if the tools are there. `sweep` also gets the sources of the report's charts
# and of real bodies; without those a sweep still runs. All messages go to stderr.
set -eu

needed='g++ zlib1g-dev cmake ninja-build git ca-certificates libeigen3-dev libqhull-dev libassimp-dev libgmp-dev libsqlite3-dev
nlohmann-json3-dev libcli11-dev libfmt-dev libtbb-dev libjemalloc-dev libpfm4-dev libgtest-dev libgmock-dev'
# Formatting, linting, fuzzing; CGAL and Valgrind to check exact distances and modelled caches; a browser for the report's
# page, and nodejs to control it; schedulers for the parts of a campaign; packaging; the page of headers; a compiler cache;
# other processors.
wanted_by_tests='clang clang-format clang-tidy libclang-rt-14-dev libcgal-dev valgrind chromium nodejs sqlite3
parallel slurmctld slurmd slurm-client dpkg-dev lintian doxygen python3 pkgconf ccache g++-aarch64-linux-gnu qemu-user'
[ "${EDGEWISE_FULL_TESTS:-}" != ON ] || wanted_by_tests="$wanted_by_tests g++-riscv64-linux-gnu"
# Other libraries to compare with Edgewise, if EDGEWISE_PEERS=ON is in the environment; and the tool that counts their work.
wanted_by_peers='pkgconf libbullet-dev libfcl-dev libccd-dev valgrind'
# Engines that `edgewise record` runs: all for tests and if EDGEWISE_ENGINES=ON is in the environment; for "bullet", Bullet.
wanted_by_recorders='libmujoco-dev libmujoco-samples libbullet-dev libsdformat-dev'
[ "${EDGEWISE_ENGINES:-}" != bullet ] || wanted_by_recorders=libbullet-dev
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)

say() { printf 'set-up: %s\n' "$*" >&2; }
give_up() {
    say "$*"
    exit 2
}

# For the charts, as PDF too. npm brings hundreds of packages, so it is asked for only while the chart bundles are not there.
names_for_charts() {
    command -v node >/dev/null 2>&1 || echo nodejs
    command -v rsvg-convert >/dev/null 2>&1 || echo librsvg2-bin fonts-dejavu-core
    [ -f "$root/build/release/charts/vega-embed.min.js" ] || command -v npm >/dev/null 2>&1 || echo npm
}

is_installed() {
    # shellcheck disable=SC2016  # dpkg-query expands it
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

missing_of() {
    for package in "$@"; do
        is_installed "$package" || printf '%s ' "$package"
    done
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    else
        sudo "$@"
    fi
}

# Prints why it failed, and what to do.
install() { # PACKAGE...
    by_hand="apt-get update && apt-get install --no-install-recommends $*"
    if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null 2>&1; then
        say "neither root nor sudo; as root: $by_hand"
        return 1
    fi
    say "installing with apt-get: $*"
    # Stale or incomplete lists may be sufficient.
    as_root apt-get update -qq >&2 || say "apt-get update failed; going on with the package lists that are there"
    if ! as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >&2; then
        say "apt-get could not install that (is there a network?); as root: $by_hand"
        return 1
    fi
}

install_missing() { # PACKAGE...
    missing=$(missing_of "$@")
    # shellcheck disable=SC2086  # a list of words
    [ -z "$missing" ] || install $missing
}

check_tools() {
    # shellcheck disable=SC2086  # a list of words
    say "no apt-get here; what is needed, by its Debian names:" $needed
    for tool in cmake ninja git "${CXX:-c++}"; do
        command -v "$tool" >/dev/null 2>&1 || give_up "$tool is missing; install it and try again"
    done
}

case ${1:-} in
sweep | tests) ;;
*) give_up "usage: set_up.sh sweep|tests" ;;
esac
if command -v apt-get >/dev/null 2>&1 && command -v dpkg-query >/dev/null 2>&1; then
    # shellcheck disable=SC2086  # a list of words
    install_missing $needed || exit 2
    if [ "$1" = tests ]; then
        # shellcheck disable=SC2086  # a list of words
        install_missing $wanted_by_tests || say "going on; the tests will leave out what needs those"
    fi
    if [ "${EDGEWISE_PEERS:-}" = ON ]; then
        # shellcheck disable=SC2086  # a list of words
        install_missing $wanted_by_peers || say "going on; what needs those will be left out"
    fi
    if [ -n "${EDGEWISE_ENGINES:-}" ] || [ "$1" = tests ]; then
        # shellcheck disable=SC2086  # a list of words
        install_missing $wanted_by_recorders || say "going on; models of the missing engines will not be recorded"
    fi
    if [ "$1" = sweep ]; then
        # shellcheck disable=SC2046  # a list of words
        install_missing $(names_for_charts) || say "going on; the report will show tables instead of charts"
    fi
else
    check_tools
fi
if [ "$1" = sweep ]; then
    sh "$root/cmake/fetch_meshes.sh" "$root/build/meshes" || true # it said why
fi
