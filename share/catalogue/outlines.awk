# SPDX-License-Identifier: Apache-2.0
# The spreading of a viscous source against measured outlines, for share/catalogue/run: from the arrival times along the
# axis and along lines across it ("x = 0.20"), the front and the half-widths at the times of the outlines; errors are
# computed minus measured. Outlines after the end of the run, the nose of each and lines beyond it are left out.
#     awk -v end=SECONDS -f outlines.awk RESULT/profiles.csv outlines.csv
BEGIN { FS = "," }
FNR == 1 { file++; next }
{ sub(/\r$/, "") }
file == 1 && $10 != "" { n = ++count[$1]; place[$1, n] = $2; arrival[$1, n] = $10 }
file == 2 && $1 <= end {
    if (!($1 in points)) order[++times] = $1
    n = ++points[$1]; x[$1, n] = $2; half[$1, n] = $3 > 0 ? $3 : 0
    front[$1] = $2
}
# How far along a line the flow has come by a time [m]; -1: not on it.
function reached(line, t,    i, far, a, b) {
    far = -1
    for (i = 1; i <= count[line]; ++i) if (arrival[line, i] <= t) far = i
    if (far < 1) return -1
    if (far == count[line]) return place[line, far]
    a = arrival[line, far]; b = arrival[line, far + 1]
    return place[line, far] + (place[line, far + 1] - place[line, far]) * (t - a) / (b - a)
}
# The measured half-width of an outline at x, between its points; -1: none there.
function width(t, at,    i) {
    for (i = 1; i < points[t]; ++i) if (x[t, i] <= at && at < x[t, i + 1])
        return half[t, i] + (half[t, i + 1] - half[t, i]) * (at - x[t, i]) / (x[t, i + 1] - x[t, i])
    return -1
}
END {
    for (k = 1; k <= times; ++k) {
        t = order[k]; difference = 0; lines = 0
        far = reached("axis", t)
        for (line in count) if (line ~ /^x = /) {
            at = substr(line, 5) + 0
            seen = width(t, at); here = reached(line, t)
            if (seen <= 0 || here < 0 || at > 0.95 * front[t]) continue
            difference += (here - seen) / seen; ++lines
        }
        printf "  %-48s %.4g\n", "front_m.at_" t "_s", far
        printf "  %-48s %.4g\n", "front_m.at_" t "_s.relative_error", (far - front[t]) / front[t]
        if (lines) printf "  %-48s %.4g\n", "half_width.at_" t "_s.relative_error", difference / lines
    }
    first = times > 4 ? order[4] : order[times - 1]; last = order[times]
    printf "  %-48s %.4g\n", "front.exponent", log(reached("axis", last) / reached("axis", first)) / log(last / first)
}
