#!/usr/bin/env bash
# Makes the samples' pictures for the start page anew: resources/samples/remake.sh build/release/app/knotspan
set -euo pipefail
program=$(realpath -- "${1:?which program}")
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
"$program" sample | while read -r name _; do
    "$program" sample "$name" -o "$folder/$name.knotspan" </dev/null
    "$program" render "$folder/$name.knotspan" -o "$name.png" --size 320x200 </dev/null
done
