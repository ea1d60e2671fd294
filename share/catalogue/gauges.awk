# SPDX-License-Identifier: Apache-2.0
# The gauges of a run against measured ones, for share/catalogue/run: root mean square and mean of the differences,
# computed minus measured. Before its wave arrives a gauge of the experiment shows 0: those rows, and those
# after the end of the run, are left out.
#     awk -v end=SECONDS -f gauges.awk RESULT/gauges.csv building_gauges_h.txt building_gauges_uv.txt
FNR == 1 { file++ }
{ sub(/\r$/, "") }
file == 1 && FNR > 1 {
    split($0, cell, ",")
    name = cell[2]
    n = ++rows[name]
    time[name, n] = cell[1]; depth[name, n] = cell[3]; speed[name, n] = cell[4]
}
# The computed value of a gauge at a time, linear between rows; the rows of a gauge are asked for in rising order.
function computed(values, name, t,    i, w) {
    i = last[name] ? last[name] : 1
    while (i + 1 < rows[name] && time[name, i + 1] < t) ++i
    last[name] = i
    w = (t - time[name, i]) / (time[name, i + 1] - time[name, i])
    w = w < 0 ? 0 : w > 1 ? 1 : w
    return (1 - w) * values[name, i] + w * values[name, i + 1]
}
function add(what, name, difference) {
    key = what SUBSEP name
    count[key]++; sum[key] += difference; square[key] += difference * difference
}
file > 1 { n = split($0, cell, "\t") }
file == 2 && FNR == 1 || file == 3 && FNR == 1 { split("", last); for (i = 2; i <= n; ++i) gauge[i] = cell[i]; next }
file > 1 && (FNR == 2 || cell[1] > end) { next }
file == 2 {
    for (i = 2; i <= n; ++i) if (cell[i] != "") {
        if (cell[i] > 0) wet[gauge[i]] = 1
        if (wet[gauge[i]]) add("depth_m", gauge[i], computed(depth, gauge[i], cell[1]) - cell[i])
    }
}
file == 3 {
    for (i = 2; i < n; i += 2) if (cell[i] != "" && cell[i + 1] != "")
        add("speed_ms", gauge[i], computed(speed, gauge[i], cell[1]) - sqrt(cell[i] ^ 2 + cell[i + 1] ^ 2))
}
END {
    for (w = 1; w <= 2; ++w) for (g = 1; g <= 6; ++g) {
        key = (w == 1 ? "depth_m" : "speed_ms") SUBSEP "G" g
        if (!count[key]) continue
        split(key, part, SUBSEP)
        printf "  %-48s %.4g\n", part[2] "." part[1] ".rmse", sqrt(square[key] / count[key])
        printf "  %-48s %.4g\n", part[2] "." part[1] ".bias", sum[key] / count[key]
    }
}
