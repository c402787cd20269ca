#!/usr/bin/env bash
# make.sh <folder> <submission> <raywork-report>: the report of a copy of a submission, in <folder>/<submission>/report.
set -euo pipefail
source=$(dirname "${BASH_SOURCE[0]}")
folder=$1/$2

rm -rf "$folder"
mkdir -p "$folder"
cp -r "$source/../../$2" "$folder/$2"
[[ $2 == student ]] || { mkdir -p "$folder/$2/report" && cp "$source"/results/* "$folder/$2/report"; }
exec "$3" "$folder/$2" -o "$folder/report"
