#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Real bodies for the sweep: fetch_meshes.sh DIRECTORY
# Four parts of robots from Debian's dart-doc (BSD-2-Clause), which is downloaded with apt-get and unpacked, not
# installed. It fetches nothing if they are there already. A failure prints one line and ends with exit code 1; the sweep then
# shows their cells as unavailable.
set -eu

directory=${1:?usage: fetch_meshes.sh DIRECTORY}
package=dart-doc
# name here, path below the package's data folder
meshes='atlas_foot.stl sdf/atlas/l_foot.stl
atlas_hand.stl sdf/atlas/l_hand.stl
hubo_foot.stl urdf/drchubo/meshes/convhull_LAR_merged.stl
wam_wrist.stl urdf/wam/meshes/wam/wam6.STL'

say() { printf 'meshes: %s\n' "$*" >&2; }
give_up() {
    say "$1; the sweep will show the real bodies as unavailable"
    exit 1
}

all_there() {
    while read -r name source; do
        [ -s "$directory/$name" ] || return 1
    done <<LIST
$meshes
LIST
}

download() { (cd "$scratch" && apt-get download -qq "$package") >"$scratch/log" 2>&1; }

# A machine without package lists cannot download. Root can fetch the lists; other users have already seen a message.
download_with_lists() {
    download && return 0
    [ "$(id -u)" -eq 0 ] && apt-get update -qq >"$scratch/log" 2>&1 && download
}

if all_there; then exit 0; fi
for tool in apt-get dpkg-deb; do
    command -v "$tool" >/dev/null 2>&1 || give_up "they come from the Debian package $package, and there is no $tool"
done
scratch=$(mktemp -d) || give_up "cannot create a temporary folder"
trap 'rm -rf "$scratch"' EXIT
chmod 755 "$scratch" # apt-get downloads as a user of its own
say "downloading the Debian package $package (9 MB, unpacked but not installed)"
download_with_lists || give_up "apt-get could not download $package: $(tail -n 1 "$scratch/log")"
dpkg-deb -x "$scratch/$package"_*.deb "$scratch/unpacked" || give_up "$package cannot be unpacked"
mkdir -p "$directory" || give_up "cannot create $directory"
while read -r name source; do
    # Copied under another name first, so that an interrupted copy leaves no partial mesh.
    cp "$scratch/unpacked/usr/share/doc/dart/data/$source" "$directory/$name.part" ||
        give_up "$package holds no $source"
    mv "$directory/$name.part" "$directory/$name"
done <<LIST
$meshes
LIST
say "$(printf '%s\n' "$meshes" | wc -l) meshes are in $directory"
