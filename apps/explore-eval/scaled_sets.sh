#!/bin/sh
# Writes the runs of a sensitivity table for compare_sets.sh: each threshold of [perception] times 0.8 and times 1.2.
set -eu

usage() {
	cat >&2 <<-END
	Usage: scaled_sets.sh INI [FACTOR]...
	  INI      configuration, as for explore-mrpt --ini
	  FACTOR   what each threshold is multiplied with (default: 0.8 1.2)
	Keys that are no thresholds are passed over: seed, those that only method = paper uses, and what is 0. Values are kept
	within their bounds, whole numbers stay whole. The environment variable EXPLORE_MRPT names the program (default:
	explore-mrpt on the PATH).
	END
	exit 2
}

[ $# -ge 1 ] || usage
ini=$1
shift
[ $# -ge 1 ] || set -- 0.8 1.2
program=${EXPLORE_MRPT:-explore-mrpt}

"$program" --ini "$ini" --dump-config | awk -v factors="$*" '
	function bounded(value) {
		if (value < low) value = low
		if (value > high) value = high
		return whole ? int(value + 0.5) : value
	}
	BEGIN {
		count = split(factors, factor, " ")
		# Those of the paper'"'"'s Algorithm 1 and of nothing else.
		split("voxel_size plane_tolerance alpha min_inliers max_iterations wall_tilt_deg scan_height " \
		      "second_scan_height scan_band min_gap max_gap gap_agreement parallel_deg", paper, " ")
		for (i in paper) passed_over[paper[i]] = 1
		passed_over["seed"] = 1
		print "base"
	}
	/^\[/ { inside = $0 == "[perception]"; comment = ""; next }
	!inside { next }
	/^#/ { comment = comment substr($0, 2); next }
	/^$/ { comment = ""; next }
	{
		key = $1
		value = $3
		accepted = comment
		comment = ""
		if (key in passed_over || accepted ~ /method = paper/) next
		if (accepted !~ /Accepted: a (whole )?number from /) next
		whole = accepted ~ /Accepted: a whole number/
		sub(/.*Accepted: a (whole )?number from +/, "", accepted)
		split(accepted, word, / +/)
		low = word[1] + 0
		high = word[3] + 0
		if (value + 0 == 0) next
		for (i = 1; i <= count; ++i) {
			scaled = bounded(value * factor[i])
			if (scaled == value + 0) continue
			printf "%s_x%s perception.%s=%.6g\n", key, factor[i], key, scaled
		}
	}'
