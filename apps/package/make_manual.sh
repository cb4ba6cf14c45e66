#!/usr/bin/env bash
# make_manual.sh HELP2MAN VERSION FOLDER PROGRAM...: FOLDER/*.1.gz from what the programs say of themselves.
set -euo pipefail
help2man=$1 version=$2 folder=$3
shift 3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
rm -rf "$folder"
mkdir -p "$folder"

# page NAME COMMAND: the page NAME(1) of a command and its subcommand.
page()
{
	local summary
	summary=$($2 --help | head -n 1 | sed 's/\. .*//; s/\.$//')
	"$help2man" --no-info --no-discard-stderr --section 1 --manual "explore-mrpt" --source "explore-mrpt $version" \
		--version-string "$1 $version" --name "${summary,}" --include "$here/manual.inc" "$2" |
		sed "s|$(dirname "${2%% *}")/||g" | gzip -9n >"$folder/$1.1.gz"
}

for program in "$@"; do
	name=$(basename "$program")
	page "$name" "$program"
	"$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p' | while read -r subcommand; do
		page "$name-$subcommand" "$program $subcommand"
	done
done
