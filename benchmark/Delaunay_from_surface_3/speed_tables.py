# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Time and memory of insertions beside plain CGAL's, from what measure_single_calls.py, measure_threads,
compare_with_plain, check_meshes and count_instructions.py wrote; inputs that are hard for some order or for arithmetic,
from measure_orders and measure_flat_and_far; weights, by measure_weights; other programs, by measure_threads --peer; and what
tiles keep."""

import math

from manual_tables import cpu_of, geometric_mean, marked, measured, range_of, table, thousands


def surface_of(result):
    """bunny_256k.off: bunny"""
    return result["mesh"].split("_")[0]


def gain(result, name):
    """Time of plain CGAL / time of the call, by wall clock."""
    return result["calls"]["plain"]["median_wall"] / result["calls"][name]["median_wall"]


def two(value):
    return "–" if value is None else f"{value:.2f}"


def means(columns):
    """Of what there is."""
    most = max(map(len, columns.values()))
    columns = {name: [v for v in column if v] for name, column in columns.items()}
    columns = {name + (f" (of {len(column)})" if len(column) < most else ""): column for name, column in columns.items()}
    return ", ".join(f"{name} {two(geometric_mean(column))}" for name, column in columns.items())


def one_thread(report):
    columns = {"faces": "default", "points alone": "points", "arrays": "arrays"}
    def seconds(result, name):
        return f'{two(result["calls"][name]["median_user"])} + {two(result["calls"][name]["median_system"])}'

    rows = [[surface_of(r), seconds(r, "plain"), seconds(r, "default"), *(two(gain(r, name)) for name in columns.values())]
            for r in report["results"]]
    found = means({title: [gain(r, name) for r in report["results"]] for title, name in columns.items()})
    return "\n\n".join([measured(report), table(["surface", "plain %CGAL, s", "faces, s", *columns], marked(rows, 3, 4, 5)),
                        f"Geometric means: {found}."])


def two_threads(calls, threads):
    """Parallel_tag of CGAL was measured beside this package only in the run of `threads`, on another machine."""
    columns = {"plain %CGAL, one / this package, two": ("plain", "default:2"), "this package, one / two": ("default", "default:2"),
               "arrays, one / two": ("arrays", "arrays:2")}
    gains_of = {title: [r["calls"][a]["median_wall"] / r["calls"][b]["median_wall"] for r in calls["results"]]
                for title, (a, b) in columns.items()}
    rows = [[surface_of(r), *map(two, values)] for r, *values in zip(calls["results"], *gains_of.values())]
    parallel = [r["times"]["plain_parallel"]["median_wall"] / r["times"]["threads_2"]["median_wall"] for r in threads["results"]
                if "plain_parallel" in r["times"]]
    return "\n\n".join([
        measured(calls), table(["surface", *columns], marked(rows, 1, 2, 3)), f"Geometric means: {means(gains_of)}.",
        f"%CGAL with `Parallel_tag` and two threads takes {range_of(parallel, '{:.2f}')} times as long as this package with two, on "
        f"{len(parallel)} surfaces in the geometric mean {two(geometric_mean(parallel))} times. {measured(threads)}"])


def more_threads(report):
    """Insertions withdrawn of a thousand, by the number of workers that were simulated."""
    def share(row, workers):
        return 1000 * sum(row["rolled_back"][f"workers_{workers}"]) / row["points"]

    most = {workers: max(share(row, workers) for row in report["results"]) for workers in (2, 8, 64)}
    return (f"On {len(report['results'])} surfaces, of a thousand insertions at most {most[2]:.1f} clashed with two workers, "
            f"{most[8]:.1f} with 8, and {most[64]:.0f} with 64 (`{report['name']}`).")


def critical_path(*reports):
    """By number of points: what one thread executes / what the busiest of many does, in valgrind's turns and if what threads
    share were shared evenly; what all do / one."""
    rows = []
    by_size = {}
    for r in [r for report in reports for r in report["results"]]:
        by_size.setdefault(r["points"], {})[r["threads"]] = r
    for points, of in by_size.items():
        one = of[1]["work"]
        for threads, r in sorted(of.items()):
            alone = sum(longest for part, (longest, _) in r["parts"].items() if part.endswith("alone"))
            evenly = alone + (r["work"] - alone) / threads
            rows.append([thousands(points), str(threads), two(one / r["critical_path"]), two(one / evenly), two(r["work"] / one),
                         f"{100 * alone / one:.1f} %" if threads > 1 else "–"])
    return table(["points", "threads", "one / the busiest", "if shared evenly", "all / one", "what is not shared / one"], rows) + (
        "\n\n<small>Instructions, elephant, arrays, " + ", ".join(f'`{report["name"]}`' for report in reports) + ".</small>")


def sixteen_cores(report):
    """Seconds of one surface by one thread and by 16."""
    (result,) = report["results"]
    times = result["times"]
    rows = [["plain %CGAL, `Parallel_tag`", times["plain"]["median_wall"], times["plain_parallel"]["median_wall"]],
            ["this package, into %CGAL's triangulation", *(times[f"threads_{n}"]["median_wall"] for n in (1, 16))],
            ["this package, arrays", *(times[f"arrays_{n}"]["median_wall"] for n in (1, 16))]]
    of_peers = {}
    for peer in peers_of(result):
        of_peers.setdefault(library_of(peer), {})[peer["threads"]] = peer["median_wall"]
    rows += [[name, of[1], of[16]] for name, of in of_peers.items()]
    return (f'Seconds for {thousands(result["points"])} points of the {result["surface"]}. {measured(report)}\n\n' +
            table(["program", "1 thread", "16 threads", "gain"],
                  [[name, two(one), two(many), two(one / many)] for name, one, many in rows]))


SMALL_SIZES = (10, 100, 1000, 3000)


def sizes(small, demo, threads_64k, calls, large_calls, by_size):
    rows, first = [], 4  # points: fewer have no triangulation in space

    def add(points, what, ratios, report):
        rows.append([points, what, f'`{report["name"]}`', str(len(ratios)), two(geometric_mean(ratios)), two(min(ratios))])

    for end in SMALL_SIZES:
        add(f"{thousands(first)} to {thousands(end - 1)}", "instructions",
            [m["plain"] / m["package"] for m in small["instructions"] if first <= m["vertices"] < end], small)
        first = end
    large = [m for m in demo["meshes"] if m.get("ratio") and m["vertices"] >= first]
    add(f"{thousands(first)} to {thousands(max(m['vertices'] for m in large))}", "CPU time", [m["ratio"] for m in large], demo)
    for report in (threads_64k, calls, large_calls, by_size):
        results = report["results"] if report is not by_size else report["results"][-1:]
        add(thousands(results[0]["points"]), "time",
            [gain(r, "default") if "calls" in r else
             r["times"]["plain"]["median_wall"] / r["times"]["threads_1"]["median_wall"] for r in results], report)
    return "\n\n".join([measured(threads_64k, calls, large_calls, by_size),
                        table(["points", "measured", "JSON", "surfaces", "geometric mean", "least"], rows, 3)])


MEMORY = {"plain": "plain %CGAL", "default": "faces", "points": "points alone", "arrays": "arrays",
          "default:2": "faces, two threads"}


def bytes_per_point(result, name):
    return result["calls"][name]["median_bytes_above"] / result["points"]


def more_memory(results):
    """The peak of a call with faces over that of plain CGAL."""
    return range_of([bytes_per_point(r, "default") / bytes_per_point(r, "plain") for r in results], "{:.2f}")


def memory(calls, large_calls, small_calls, threads):
    rows = [[surface_of(r), *(f"{bytes_per_point(r, name):.0f}" for name in MEMORY)] for r in calls["results"]]
    both = calls["results"] + large_calls["results"]
    of_sixteen = [r["memory"]["threads_16"]["peak_above_input_per_point"] /
                  r["memory"]["threads_1"]["peak_above_input_per_point"] for r in threads["results"]]
    many = {name: range_of([bytes_per_point(r, name) / 100 for r in both], "{:.1f}")
            for name in ("plain", "default", "arrays")}
    return "\n\n".join([
        measured(calls), table(["surface", *MEMORY.values()], rows),
        f"With faces the peak is {more_memory(both)} times that of plain %CGAL, also for a million points (`{large_calls['name']}`), "
        f"and {more_memory(small_calls['results'])} times for {range_of([r['points'] for r in small_calls['results']], '{:,}')} "
        f"points (`{small_calls['name']}`). At these rates ten million points take {many['plain']} GB with plain %CGAL, "
        f"{many['default']} GB with this package, and {many['arrays']} GB with arrays.",
        f"The peak of 16 threads is {range_of(of_sixteen, '{:.2f}')} times that of one (`{threads['name']}`)."])


def gains(report):
    """What the compact triangulation gains alone, the order alone, and the order in addition."""
    rows, shares, destroyed = [], [], {"plain-order": [], "compact-nets": []}
    for result in report["results"]:
        methods = {m["method"]: m for m in result["methods"] if "left_out" not in m}
        methods.setdefault("compact-nets", methods["default"])  # which it was until spaced rounds took its place
        seconds = methods["plain-order"]["phases"]["seconds"]  # makes plain CGAL's insertions
        shares.append(100 * seconds["update"] / sum(seconds.values()))
        for name, cells in destroyed.items():
            cells.append(methods[name]["cells"]["destroyed"])
        if not result["surface"].endswith("-shuffled"):
            rows.append([result["surface"], *(two(methods[a]["median_cpu"] / methods[b]["median_cpu"]) for a, b in
                                              (("plain", "compact-spatial"), ("plain", "nets"), ("compact-spatial", "compact-nets")))])
    cells = [range_of(of, "{:.1f}") for of in destroyed.values()]
    return "\n\n".join([
        measured(report), table(["surface", "compact triangulation alone", "order alone", "order in addition"], rows),
        f"Plain %CGAL spends {range_of(shares, '{:.0f}')} % of its time on updates. An insertion destroys {cells[0]} cells in its "
        f"order, and {cells[1]} in the order of the nets."])


CALLS = {("plain CGAL", 1): "plain", ("this package", 1): "default", ("this package", 2): "default:2",
         ("arrays", 1): "arrays", ("arrays", 2): "arrays:2"}


def times_of_readme(calls, by_size):
    """Of one surface in several sizes; and how much many surfaces of one size gain."""
    columns = by_size["results"]
    rows = [[what, str(threads), *(two(r["calls"][call]["median_wall"]) for r in columns)] for (what, threads), call in CALLS.items()]
    ratios = {name: [gain(r, name) for r in calls["results"]] for name in ("default", "points", "default:2")}
    of_user = [r["calls"]["plain"]["median_user"] / r["calls"]["default"]["median_user"] for r in columns]
    return "\n\n".join([
        table(["points of an elephant", "threads", *(thousands(r["points"]) for r in columns)], rows),
        f"Without the time that the system takes for memory, one thread is {range_of(of_user, '{:.2f}')} times as fast as plain CGAL. "
        f"On {len(calls['results'])} surfaces plain CGAL takes {range_of(ratios['default'], '{:.2f}')} times as long, with "
        f"a geometric mean of {two(geometric_mean(ratios['default']))}; {two(geometric_mean(ratios['points']))} if this "
        f"package gets only the points, and {two(geometric_mean(ratios['default:2']))} if it uses two threads and plain CGAL one.",
        f"<small>{cpu_of(by_size)}, {by_size['machine']['cores']} cores, [{by_size['name']}.json](benchmark/Delaunay_from_surface_3/"
        f"results/{by_size['name']}.json); 11 surfaces: {cpu_of(calls)}, `{calls['name']}`.</small>"])


def collections(orders, orders_200k, demo):
    rows = []
    hard_ones = [r["median_ratio"] for report in (orders, orders_200k) for r in report["results"] if not is_cad(r)]
    for name, ratios in (
            ("meshes of %CGAL's demos, 3,000 vertices and more",
             [m["ratio"] for m in demo["meshes"] if m.get("ratio") and m["vertices"] >= SMALL_SIZES[-1]]),
            ("CAD solids, 200,000 points", [r["median_ratio"] for r in orders_200k["results"] if is_cad(r)]),
            ("other surfaces, chosen to be hard, 3,000 to 200,000 points", hard_ones)):
        rows.append([name, str(len(ratios)), two(geometric_mean(ratios)), two(min(ratios)), two(max(ratios))])
    return table(["", "how many", "geometric mean", "least", "most"], rows) + "\n\n" + measured(orders, orders_200k)


def is_cad(row):
    return row["kind"] in ("by profile", "by ring", "shuffled")


# --- hard inputs, other programs, tiles ---

SIZES = (3000, 20000, 200000)


def size_of(row, sizes):
    return min(sizes, key=lambda n: abs(math.log(n / row["points"])))


def name_of(row):
    parts = [row["family"], row["kind"] if is_cad(row) or row["family"] == "sheet" else "",
             "points alone" if row.get("inserted") == "points" else ""]
    return ", ".join(filter(None, parts))


def line(title, rows):
    ratios = [r["median_ratio"] for r in rows]
    least = min(rows, key=lambda r: r["median_ratio"])
    return [title, name_of(least), str(len(rows)), two(geometric_mean(ratios)), two(min(ratios))]


def hard(orders, orders_200k, walks, flat):
    rows = [r for report in (orders, orders_200k) for r in report["results"]]
    lines = [line(f"{title}, {thousands(n)}", [r for r in rows if size_of(r, SIZES) == n and is_cad(r) == cad])
             for title, cad in (("CAD solids", True), ("other surfaces", False)) for n in SIZES]
    tori = [r for r in walks["results"] if r["family"] == "smooth torus"]
    lines.append(line("smooth tori, 300,000 to 800,000", tori))
    large = [r for r in flat["results"] if r["points"] > 50000]
    for title, families in (("thin sheets, a thin tube, 100,000", ("sheet", "tube")),
                            ("points far away, 100,000", ("every tenth point far away", "sentinels")),
                            ("all equal, or on a line, 100,000", ("all points equal", "collinear")),
                            ("in one plane, 100,000", ("coplanar",))):
        lines.append(line(title, [r for r in large if r["family"] in families]))
    return f"{measured(orders, orders_200k, walks, flat)}\n\n" + table(
        ["surfaces, points", "the hardest", "how many", "geometric mean", "least"], marked(lines, 3, 4), 2)


def boxes(walks):
    """Points at random in boxes that are long, or flat."""
    found = {r["kind"]: r["median_ratio"] for r in walks["results"] if r["family"] == "points alone"}
    rows = [[f"1/{a}", two(found[f"box 1 : 1/{a} : 1/{a}"]), two(found[f"slab 1 : 1 : 1/{a}"])]
            for a in (100, 1000, 10000)]
    return f"{measured(walks)}\n\n" + table(["a", "box 1 : a : a", "slab 1 : 1 : a"], marked(rows, 1, 2))


def weights(report):
    """Time of CGAL's regular triangulation / ours; of another program / of arrays by as many threads; of one thread / of two.
    Set by set for the largest size, and means of all."""
    def beside(threads, library):
        return lambda row: next((peer["ratio_method_to_arrays"] for peer in peers_of(row)
                                 if (peer["threads"], library_of(peer)) == (threads, library)), None)

    results = report["results"]  # each size has the same sets
    number = len({row["set"] for row in results})
    sizes = [results[i:i + number] for i in range(0, len(results), number)]
    ratios = {"filled": lambda row: row["median_ratio_filled"], "arrays": lambda row: row["median_ratio_arrays"]}
    for threads, library in sorted({(peer["threads"], library_of(peer)) for row in results for peer in peers_of(row)}):
        ratios[library + (f" by {threads} threads" if threads > 1 else "")] = beside(threads, library)
    ratios["2 threads"] = lambda row: row["gain_of_two_threads"]
    ratios["2 without weights"] = lambda row: row["gain_of_two_threads_without_weights"]
    rows = [[f'{row["set"]}, {thousands(row["points"])}', thousands(row["hidden"]), two(row["median_plain_cpu"]),
             *(two(ratio(row)) for ratio in ratios.values())] for row in sizes[-1]]
    found = [f"For {thousands(max(row['points'] for row in size))} points geometric means are " +
             means({name: [ratio(row) for row in size] for name, ratio in ratios.items()}) for size in sizes]
    return "\n\n".join([measured(report), table(["points", "hidden", "plain %CGAL, s", *ratios], marked(rows, 3, 4)),
                        f"{'. '.join(found)}.", other_tetrahedra(results)])


def periodic(report):
    """Time of CGAL's periodic triangulation, and of another program, / of arrays: all rows beside CGAL, and the largest of each
    set that has none."""
    def beside(row):
        return next((peer["ratio_method_to_arrays"] for peer in peers_of(row)), None)

    beside_plain = {row["set"] for row in report["results"] if "median_ratio" in row}
    last = {row["set"]: row for row in report["results"]}
    rows = [[f'{row["set"]}, {thousands(row["points"])}', two(row["median_arrays_cpu"]), two(row.get("median_ratio")), two(beside(row)),
             two(row["gain_of_two_threads"]), two(row["copies_per_point"]), two(row["peak_to_that_in_space"])]
            for row in report["results"] if "median_ratio" in row or row["set"] not in beside_plain and row is last[row["set"]]]
    return f"{measured(report)}\n\n" + table(
        ["points", "arrays, s", "plain %CGAL", "Geogram", "2 threads", "copies per point", "memory"], marked(rows, 2, 3))


def other_tetrahedra(results):
    found = []
    for row in results:
        others = sorted({peer["tetrahedra"] for peer in peers_of(row)} - {row["tetrahedra"]})
        if others:
            found.append(f'{" or ".join(map(thousands, others))}, not {thousands(row["tetrahedra"])} ({row["set"]}, '
                         f'{thousands(row["points"])})')
    return f"Numbers of tetrahedra that differ: {'; '.join(found) or 'none'}."


def library_of(peer):
    """TetGen 1.5: TetGen"""
    return peer.get("library", peer["method"]).split(",")[0].split()[0]


def peers_of(result):
    """Those that ran."""
    return [peer for peer in result.get("peers", []) if "left_out" not in peer and "median_wall" in peer]


def beside_peers(report, key):
    """{(threads, program): {surface: its time / that of arrays by as many threads}}; first plain CGAL / this package, into
    CGAL's triangulation."""
    ratios = {(1, "plain %CGAL"): {}, (2, "plain %CGAL"): {}}
    for result in report["results"]:
        calls, surface = result["calls"], surface_of(result)
        for threads, plain, ours in ((1, "plain", "default"), (2, "parallel:2", "default:2")):
            ratios[threads, "plain %CGAL"][surface] = calls[plain][key] / calls[ours][key]
        for peer in calls.values():
            if "library" in peer:
                ours = calls["arrays" if peer["threads"] == 1 else f'arrays:{peer["threads"]}']
                ratios.setdefault((peer["threads"], peer["library"].split()[0]), {})[surface] = peer[key] / ours[key]
    return ratios


def peers(report):
    """One thread by user time, and with the system's; two by the clock."""
    surfaces = [surface_of(result) for result in report["results"]]
    rows = []
    for threads, key, what in ((1, "median_user", "user"), (1, "median_cpu", "user + system"), (2, "median_wall", "clock")):
        rows += [[program, str(threads), what, *(two(of.get(surface)) for surface in surfaces), two(geometric_mean(of.values()))]
                 for (of_threads, program), of in beside_peers(report, key).items() if of_threads == threads]
    others = sorted({f'{peer["library"].split()[0]} on {surface_of(result)}' for result in report["results"]
                     for peer in result["calls"].values() if peer.get("tetrahedra", result["tetrahedra"]) != result["tetrahedra"]})
    return "\n\n".join([table(["program", "threads", "time", *surfaces, "geometric mean"], rows),
                        f"Numbers of tetrahedra that differ from plain %CGAL's: {'; '.join(others) or 'none'}.", measured(report)])


def peers_of_readme(report):
    """One sentence, of one thread."""
    found = {program: range_of(of.values(), "{:.1f}") for (threads, program), of in beside_peers(report, "median_cpu").items()
             if threads == 1 and program != "plain %CGAL"}
    times = ", ".join(f"{name} {times}" for name, times in sorted(found.items()))
    return (f"CPU time of other programs / that of arrays of this package, on {len(report['results'])} sets of points, one thread, "
            f"each call in a process of its own: {times} ({cpu_of(report)}).")


def tiles(report, number=64):
    """What tiles keep and are told, for each point of their own."""
    rows = []
    for result in report["results"]:
        c = next(c for c in result["counts"] if c["tiles"] == number)
        rows.append([result["input"], f'{c["kept"]["mean"]:.1f}', f'{c["kept"]["worst"]:.1f}',
                     f'{c["told"]["mean"]:.1f}'])
    points = thousands(max(result["points"] for result in report["results"]))
    return "\n\n".join([f"{points} points, {number} tiles: `{report['name']}`.",
                        table(["points", "kept", "kept by the worst", "told"], rows)])
