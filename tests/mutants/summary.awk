# SPDX-License-Identifier: MIT
# Counts outcomes by place. Fields: outcome, file.

{
    place = $2
    sub(/[^\/]*$/, "", place)
    if ($2 ~ /^host\/[a-z]+_[^\/]*$/) {
        place = $2
        sub(/_.*/, "_*", place)
    }
    if (!(place in is_seen)) {
        is_seen[place] = 1
        places[++place_count] = place
    }
    of[place, $1]++
    all[$1]++
}
END {
    printf "%-24s %6s %8s %10s %8s %5s\n", "place", "caught", "survived", "equivalent", "no code", "open"
    for (i = 1; i <= place_count; i++) {
        place = places[i]
        printf "%-24s %6d %8d %10d %8d %5d\n", place, of[place, "caught"], of[place, "survived"], \
            of[place, "equal"] + of[place, "listed"], of[place, "broken"], of[place, "open"]
    }
    judged = all["caught"] + all["survived"]
    printf "draws %s: %d caught of %d (%.1f %%), %d survived; %d of equal code, %d listed as equivalent, %d that do not compile, %d not settled; %d s\n", \
        draws, all["caught"], judged, (judged > 0 ? 100 * all["caught"] / judged : 0), all["survived"], \
        all["equal"], all["listed"], all["broken"], all["open"], seconds
}
