#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Fetches the accessibility rules for the page's test: fetch_axe.sh DIRECTORY
# npm's axe-core (MPL-2.0) by name and pinned version, packed, not installed, its SHA-256 checked; nothing of it is kept but
# axe.min.js. No network when it is there already. Without it the test checks its own rules alone, and says so.
set -u

directory=${1:?usage: fetch_axe.sh DIRECTORY}
version=4.10.3
tarball=0f2b4d7dcdf7d1219df8d1959ad68e565f51d14c3f0d88bb71cd59abeb956292
script=880970c081707360e64f34cea25ff91892f5bc95675b0776925b9709dd8a68bb

holds() { # FILE SHA256
    [ -f "$1" ] && printf '%s  %s\n' "$2" "$1" | sha256sum --check --status 2>/dev/null
}
give_up() {
    echo "axe-core: $1; the page's test checks its own rules alone" >&2
    exit 1
}

holds "$directory/axe.min.js" "$script" && exit 0
mkdir -p "$directory" || give_up "cannot create $directory"
scratch=$(mktemp -d "$directory/fetch.XXXXXX") || give_up "cannot write $directory"
trap 'rm -rf "$scratch"' EXIT
command -v npm >/dev/null 2>&1 || give_up "npm is not installed (Debian: npm)"
(cd "$scratch" && npm pack --silent --fetch-retries=1 --fetch-retry-mintimeout=1000 "axe-core@$version") >/dev/null 2>&1 ||
    give_up "npm could not fetch it (is there a network?)"
holds "$scratch/axe-core-$version.tgz" "$tarball" || give_up "it does not have the expected SHA-256"
tar -xzf "$scratch/axe-core-$version.tgz" -C "$scratch" package/axe.min.js || give_up "it lacks its script"
mv "$scratch/package/axe.min.js" "$directory/axe.min.js" || give_up "cannot write $directory"
