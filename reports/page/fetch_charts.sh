#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Fetches the chart engine for the report's page: fetch_charts.sh DIRECTORY
# Three npm packages by name and pinned version, packed, not installed; each tarball's SHA-256 is checked and only the
# browser bundle and the licence are kept. No network when they are there already. vega-embed's bundle carries the
# expression interpreter (vega-interpreter 2.3.2), so the page needs no eval. A failure is one line and exit 1: the
# report then shows tables instead of charts.
set -u

directory=${1:?usage: fetch_charts.sh DIRECTORY}
# name, version, SHA-256 of the tarball, SHA-256 of the bundle inside
packages='vega 6.4.0 3521fb6ff68a94a40323954f0ba4484ba4014b157bfd37f89a3b063082320c42 8f6a3587cf8d4f42c7e08120e3eb05d067e746d554e39d2dcf52acc0bd5ba28f
vega-lite 6.4.3 24260f85e6f5bfe1069505f7c5c2b9863181ac413ef1030746f0a80c93991ce5 35a9821df838825b05a6a73e9414b58747a1b18321583858ed903c66393a5c7e
vega-embed 7.3.0 d9a958ced3240f0418df7d5e12e97dba6e63cecda15b8403e47a0db7eb6ea859 b1455caba2fb1a72fb46025ba0ba1316e2dbc7f0dd40a3f6040172bf9c08ba91'

give_up() {
    echo "charts: $1; the report will show tables instead of charts" >&2
    exit 1
}

holds() { # FILE SHA256
    [ -f "$1" ] && printf '%s  %s\n' "$2" "$1" | sha256sum --check --status 2>/dev/null
}

fetch() { # NAME VERSION SHA256 BUNDLE_SHA256
    holds "$directory/$1.min.js" "$4" && [ -f "$directory/$1.LICENSE" ] && return 0
    rm -f "$directory/$1.min.js"
    command -v npm >/dev/null 2>&1 || give_up "npm is not installed (Debian: apt-get install npm)"
    # npm's own patience without a network is more than a minute.
    (cd "$scratch" && npm pack --silent --fetch-retries=1 --fetch-retry-mintimeout=1000 "$1@$2") >/dev/null 2>&1 ||
        give_up "npm could not fetch $1@$2 (is there a network?)"
    holds "$scratch/$1-$2.tgz" "$3" || give_up "$1@$2 does not have the expected SHA-256"
    tar -xzf "$scratch/$1-$2.tgz" -C "$scratch" "package/build/$1.min.js" package/LICENSE ||
        give_up "$1@$2 lacks its bundle or licence"
    mv "$scratch/package/LICENSE" "$directory/$1.LICENSE" &&
        mv "$scratch/package/build/$1.min.js" "$directory/$1.min.js" || give_up "cannot write $directory"
}

mkdir -p "$directory" || give_up "cannot create $directory"
scratch=$(mktemp -d "$directory/fetch.XXXXXX") || give_up "cannot write $directory"
trap 'rm -rf "$scratch"' EXIT
while read -r name version tarball bundle; do
    fetch "$name" "$version" "$tarball" "$bundle"
done <<LIST
$packages
LIST
