# The table of what was asked of the planner's speed and quality, in markdown, from the result lines of packaging/bench
# (flat JSON objects, one a line; tests/bench/README.md). A figure that no line gives stands there as "not measured".

function field(name,   text) {
  if (!match($0, "\"" name "\"[ ]*:[ ]*(\"([^\"\\\\]|\\\\.)*\"|[^,}]*)")) return ""
  text = substr($0, RSTART, RLENGTH)
  sub("^\"" name "\"[ ]*:[ ]*", "", text)
  gsub(/^"|"$/, "", text)
  return text
}

{
  value[field("bench") SUBSEP field("metric")] = field("value")
  reference[field("bench") SUBSEP field("metric")] = field("reference")
}

# v("bench", "metric", "%.2f s"): the measured value, so written
function v(bench, metric, form,   key) {
  key = bench SUBSEP metric
  return key in value && value[key] != "" ? sprintf(form, value[key]) : "not measured"
}
function r(bench, metric, form,   key) {
  key = bench SUBSEP metric
  return key in reference && reference[key] != "" ? sprintf(form, reference[key]) : "not measured"
}
function row(what, papers, asked, measured) {
  gsub(/not measured( \([^)]*\))?/, "not measured", measured)
  print "| " what " | " papers " | " asked " | " measured " |"
}
function lazy(bench, what, papers, asked) {
  row(what, papers, asked, v(bench, "total", "%.3g s") " (processor time " v(bench, "total, processor time", "%.3g s") "); " v(bench, "tour solutions", "%d") \
    " tour solutions, " v(bench, "safe-altitude queries", "%d") " queries")
}
function tours(kind, what, papers, asked) {
  row(what, papers, asked, v("tour solver, " kind, "instances", "%d instances") ", worst " v("tour solver, " kind, "worst above best known", "%+.2f %%") \
    " against best known, longest " v("tour solver, " kind, "longest time", "%.3g s"))
}

END {
  print "| what | papers | to reach | measured |"
  print "|---|---|---|---|"
  row("roadmap, 5 x 5 km", "30 s", "<= 0.1 s", v("lattice mountain-n20", "roadmap", "%.3g s processor time"))
  row("its mean safe altitude over 5,000 fixed queries", "RRT* after 30 s", "no higher", \
    v("lattice mountain-n20, 30 s of RRT*", "mean safe altitude", "%.1f m") " against " r("lattice mountain-n20, 30 s of RRT*", "mean safe altitude", "%.1f m"))
  row("safe-altitude query (one decision point)", "12.7 ms", "<= 5 us median, <= 20 us p99", \
    v("lattice mountain-n20", "query, median", "%.3g us") " median, " v("lattice mountain-n20", "query, 99 %", "%.3g us") " p99")
  lazy("LAZY n=5 k=4", "LAZY n=5 k=4, roadmap included", "142 s", "<= 0.15 s")
  lazy("LAZY n=5 k=8", "LAZY n=5 k=8, roadmap included", "533 s", "<= 0.2 s")
  lazy("LAZY n=20 k=8", "LAZY n=20 k=8, roadmap included", "385 s", "<= 0.25 s")
  lazy("BASE n=20 k=8", "BASE n=20 k=8", "15,044 s", "<= 8 s")
  lazy("LAZY n=100 k=8 d_step=30", "LAZY n=100 k=8 d_step=30 m", "-", "<= 5 s")
  tours("up to 20 sets", "tour solver, up to 20 sets", "-", "known optimum in 50 ms")
  tours("more than 20 sets", "tour solver, the others but Dubins", "-", "best known within 0.1 % in 5 s")
  tours("dubins n=40", "tours of Dubins instances, n=40 k=8", "LKH, ten runs: 5-6 s", "no dearer, <= 0.5 s")
  tours("dubins n=100", "tours of Dubins instances, n=100 k=8", "LKH, ten runs: 54-59 s", "no dearer, <= 3 s")
  row("one target moved, n=20: plan and check", "-", "<= 100 ms", v("replan mountain-n20", "plan and check", "%.0f ms") \
    "; cost " v("replan mountain-n20", "cost of a fresh plan", "%.1f %%") " of a fresh plan's")
  row("roadmap of Davos, 46 x 67 km, as good as a 200 m x 16 headings lattice", "- (plain code 5.3 s)", "<= 1 s", \
    v("roadmap Davos", "roadmap", "%.3g s") "; mean safe altitude " v("roadmap Davos", "mean safe altitude", "%.1f m") " against " \
    r("roadmap Davos", "mean safe altitude", "%.1f m") " of a plain one of 200 m (this builder with 200 m: " \
    r("roadmap Davos", "mean safe altitude, both finer", "%.1f m") "), " v("roadmap Davos", "landing directions", "%d") " landing directions")
  row("roadmap of 20 M cells, 86 airfields", "-", "<= 20 s on two threads, <= 2 GB", v("roadmap 20 M cells", "roadmap", "%.3g s") ", " \
    v("roadmap 20 M cells", "peak memory", "%.0f MiB") ", " v("roadmap 20 M cells", "landing directions", "%d") " landing directions")
  row("tour length against BASE with k=8, median of " v("refine", "missions", "%d") " bundled and real missions", "0 %", ">= 1 % shorter", \
    "cost (length and penalty) " v("refine", "median cost saved", "%.2f %%") ", length alone " v("refine", "median length saved", "%.2f %%") " less")
  row("lattice- against RRT*-planned tours", "-", "no further apart than the stated gaps", \
    v("lattice against RRT*", "missions that agree", "%d") " of " r("lattice against RRT*", "missions that agree", "%d") " missions")
  row("a connection of two poses in wind", "-", "<= 3 us median", v("wind, up to 50 radii", "least loss, median", "%.2g us") " least loss, " \
    v("wind, up to 50 radii", "quickest, median", "%.2g us") " quickest; nearer than 5 radii " v("wind, up to 5 radii", "least loss, median", "%.2g us") " and " \
    v("wind, up to 5 radii", "quickest, median", "%.2g us"))
  row("[4] landing among weather, 616 problems: mean success probability", "DVPRM .42, 8.6 s (other problems)", "the best planner, <= 0.2 s", \
    v("[4] planner, dvprm", "mean success probability", "%.3f dvprm") ", median " v("[4] planner, dvprm", "median time", "%.2g ms") ", longest " \
    v("[4] planner, dvprm", "longest time", "%.0f ms") "; dlvg " v("[4] planner, dlvg", "mean success probability", "%.3f") ", vprm " \
    v("[4] planner, vprm", "mean success probability", "%.3f") ", prm " v("[4] planner, prm", "mean success probability", "%.3f") ", straight " \
    v("[4] planner, straight", "mean success probability", "%.3f"))
  row("[4] paths that the checker refused", "-", "0", v("[4] planner", "paths that the checker refused", "%d"))
  split("mountain-n20 alpine-n10", missions, " ")
  for (m = 1; m in missions; m++) {
    name = "conditions " missions[m]
    row("planning " missions[m] " in wind, against still air", "-", "<= 3 times", v(name ", 10 kt", "times calm", "%.2f") " times with 10 kt, " \
      v(name ", 15 +- 5 kt, +- 20 degrees", "times calm", "%.2f") " uncertain, " v(name ", two layers", "times calm", "%.2f") " with two layers, " \
      v(name ", all of it", "times calm", "%.2f") " with atmosphere, reaction and approach too")
  }
  split("bench_elasp bench_agreement bench_refine bench_figures bench_conditions", programs, " ")
  for (p = 1; p in programs; p++) {
    if ((programs[p] SUBSEP "plans verified") in value) {
      certified += value[programs[p], "plans verified"]
      made += reference[programs[p], "plans verified"]
    }
  }
  row("plans made here that the checker certifies", "-", "all", certified + 0 " of " made + 0)
}
