#!/usr/bin/env python3
"""The page of `lcpbench report` in a browser without network.

report_page_test.py LCPBENCH_WITH_CONTROLS RESULTS: the program with rows that misbehave, and the
directory of committed results. Exits 77 where no browser is installed.
"""

import collections
import json
import lzma
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

sys.path.insert(0, os.path.dirname(__file__))
import webdriver

PROGRAM, RESULTS = sys.argv[1], pathlib.Path(sys.argv[2])
HOSTILE = "</script><script>document.title = 'owned'</script><img src=x onerror=alert(1)>"
LARGEST = 5_000_000  # Bytes of a page.


def lcpbench(*words):
    return subprocess.run([PROGRAM, *words], check=True, capture_output=True, text=True).stdout


def unpacked(name, directory):
    """A copy of a committed run with its rows unpacked."""
    run = directory / name
    run.mkdir()
    for file in RESULTS.joinpath(name).glob("*.json"):
        shutil.copy(file, run)
    run.joinpath("rows.jsonl").write_bytes(
        lzma.decompress(RESULTS.joinpath(name, "rows.jsonl.xz").read_bytes()))
    return run


class ReportPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="lcpbench-")
        cls.directory = pathlib.Path(cls.temporary.name)
        cls.downloads = cls.directory / "downloads"
        cls.downloads.mkdir()
        cls.run_directory = cls.directory / "run"
        solvers = ["lemke", "lexicographic", "best-first", "projected-gauss-seidel", "crasher"]
        lcpbench("run", "--suite", "default", "--limit", "4", "--out", str(cls.run_directory),
                 *[word for solver in solvers for word in ("--solver", solver)])
        rows_file = cls.run_directory / "rows.jsonl"
        cls.rows = [json.loads(line) for line in rows_file.read_text().splitlines()]
        failed = next(row for row in cls.rows if row["corpus"] == "squat-like"
                      and row["verdict"] not in ("solved", "crash"))
        failed["message"] = HOSTILE
        cls.failed = failed
        rows_file.write_text("".join(json.dumps(row) + "\n" for row in cls.rows))
        pictures = cls.run_directory / "pictures"
        pictures.mkdir()
        pictures.joinpath("scene.svg").write_text(
            '<svg xmlns="http://www.w3.org/2000/svg" width="30" height="20">'
            '<rect width="30" height="20"/></svg>')
        lcpbench("report", str(cls.run_directory))
        cls.browser = webdriver.Browser(str(cls.directory / "profile"), str(cls.downloads))

    @classmethod
    def tearDownClass(cls):
        if hasattr(cls, "browser"):
            cls.browser.close()
        cls.temporary.cleanup()

    def setUp(self):
        self.open(self.run_directory)

    def open(self, run):
        self.browser.log("browser"), self.browser.log("performance")
        self.browser.open(run.joinpath("report.html").as_uri())

    def tearDown(self):
        complaints = [entry for entry in self.browser.log("browser") if entry["level"] == "SEVERE"]
        self.assertEqual(complaints, [])
        for entry in self.browser.log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] != "Network.requestWillBeSent":
                continue
            if message["params"]["documentURL"].startswith("file:"):  # Not the browser's own page.
                self.assertRegex(message["params"]["request"]["url"], "^(file|data|blob):")
        self.assertTrue(self.browser.run("return document.title").startswith("lcpbench: "))

    def choose_corpus(self, name):
        place = self.browser.run(
            "return [...document.querySelectorAll('#corpus option')]"
            ".find(o => o.textContent.startsWith(arguments[0] + ' ('))?.value", name)
        self.browser.choose("#corpus", place)

    def cell(self, row):
        """The selector of a row's cell in the matrix."""
        return f"td[data-row='{self.rows.index(row)}']"

    def table_on_page(self):
        return self.browser.run("""
            return [...document.querySelectorAll('#table tr[data-solver]')].map(tr => ({
              solver: tr.dataset.solver, corpus: tr.dataset.corpus, start: tr.dataset.start,
              values: Object.fromEntries([...tr.querySelectorAll('td')].map(
                td => [td.dataset.key, JSON.parse(td.dataset.value)])),
              texts: Object.fromEntries([...tr.querySelectorAll('td')].map(
                td => [td.dataset.key, td.textContent])) }))""")

    def letters_on_page(self):
        """Cells of the matrix by corpus and solver, of a page that shows all corpora."""
        return self.browser.run("""
            const data = JSON.parse(document.getElementById('data').textContent);
            const at = (list, i) => Array.isArray(list) ? list[i] : list.all;
            return [...document.querySelectorAll('#matrix td[data-row]')].map(td => [
              data.instances[at(data.rows.instance, td.dataset.row)].corpus,
              data.variants[at(data.rows.variant, td.dataset.row)].solver, td.textContent])""")

    def check_table(self, tolerance):
        words = [] if tolerance is None else ["--tolerance", tolerance]
        expected = json.loads(lcpbench("table", str(self.run_directory), "--format", "json", *words))
        if tolerance:
            self.browser.choose("#tolerance", str(float(tolerance)).replace("e-0", "e-"))
        self.choose_corpus("all corpora")
        shown = self.table_on_page()
        self.assertEqual(len(shown), len(expected["rows"]))
        for row, true in zip(shown, expected["rows"]):
            self.assertEqual((row["solver"], row["corpus"]), (true["solver"], true["corpus"]))
            for key, value in row["values"].items():
                self.assertEqual(value, true[key], (key, row))
            self.assertEqual(int(row["texts"]["failure"]), true["failure"])
            if true["residual_max"] is not None:
                self.assertEqual(row["texts"]["residual_max"],
                                 "0" if true["residual_max"] == 0 else f"{true['residual_max']:.1e}")
        signs = {"s": "solved", "t": "solved", "W": "wrong", "A": "inaccurate", "R": "ray",
                 "X": "exhausted", "–": "unsupported", "C": "cycle", "L": "limit", "N": "singular", "!": "crash"}
        counted = collections.defaultdict(collections.Counter)
        for corpus, solver, letter in self.letters_on_page():
            counted[corpus, solver][signs[letter.rstrip("*")]] += 1
        for true in expected["rows"]:
            self.assertEqual(counted[true["corpus"], true["solver"]], true["verdicts"])

    def test_numbers_are_those_of_the_table_as_run(self):
        self.check_table(None)

    def test_numbers_and_letters_are_those_of_the_table_at_another_tolerance(self):
        for tolerance in ("1e-03", "1e-09", "1e-12"):
            self.check_table(tolerance)

    def test_every_row_has_a_cell(self):
        self.choose_corpus("all corpora")
        cells = self.browser.run("return document.querySelectorAll('#matrix td[data-row]').length")
        self.assertEqual(cells, len(self.rows))

    def test_a_failed_cell_tells_why_and_how_to_replay_it(self):
        self.choose_corpus("squat-like")
        self.browser.click(self.cell(self.failed))
        panel = self.browser.run("return document.querySelector('.panel').innerText")
        self.assertIn(self.failed["verdict"], panel)
        self.assertIn(HOSTILE, panel)
        self.assertIn("natural residual", panel)
        self.assertIn("pivots", panel)
        command = self.browser.run("return document.querySelector('[data-command=replay]').innerText")
        number = self.failed["instance"].split("/")[1]
        self.assertEqual(
            command,
            "build/release/lcpbench generate 'squat-like' --count 200 --seed 1 --out "
            "replay-squat-like.hdf5 && build/release/lcpbench replay "
            f"'replay-squat-like.hdf5#squat-like/{number}' --solver '{self.failed['solver']}'")

    def test_a_crash_shows_its_signal_and_last_words_to_the_keyboard(self):
        self.choose_corpus("squat-like")
        crash = next(row for row in self.rows
                     if row["verdict"] == "crash" and row["corpus"] == "squat-like")
        before = self.rows[self.rows.index(crash) - 1]
        self.browser.run("document.querySelector(arguments[0]).focus()", self.cell(before))
        self.browser.press(self.cell(before), "\ue014")  # Right,
        self.browser.press(self.cell(crash), "\ue007")   # Enter.
        panel = self.browser.run("return document.querySelector('.panel').innerText")
        self.assertIn("last words", panel)
        self.assertIn(f"ended by signal\n{crash['exit']['signal']}", panel)

    def test_corpus_and_verdict_filter_the_matrix(self):
        self.choose_corpus("stack")
        expected = {row["instance"] for row in self.rows if row["corpus"] == "stack"}
        count = "return document.querySelectorAll('#matrix tbody tr:not(.corpus)').length"
        self.assertEqual(self.browser.run(count), len(expected))
        self.choose_corpus("all corpora")
        verdict = self.failed["verdict"]
        self.browser.click(f"input[name=verdict][value='{verdict}']")
        self.assertEqual(self.browser.run(count),
                         len({row["instance"] for row in self.rows if row["verdict"] == verdict}))

    def profile(self):
        return {row["solver"]: row for row in self.browser.run("""
            return [...document.querySelectorAll('#profile .numbers tr[data-solver]')].map(tr => ({
              solver: tr.dataset.solver, best: +tr.dataset.best, unsolved: +tr.dataset.unsolved,
              counted: +tr.dataset.counted }))""")}

    def expected_profile(self, corpus, hidden):
        counted, best = collections.defaultdict(list), {}
        for row in self.rows:
            if row["corpus"] != corpus or row["solver"] in hidden:
                continue
            if row["verdict"] == "unsupported" or (row["verdict"] == "solved" and row["trivial"]):
                continue
            counted[row["solver"]].append(row)
            if row["verdict"] == "solved":
                old = best.get(row["instance"], float("inf"))
                best[row["instance"]] = min(old, row["median_ns"])
        return {solver: {"solver": solver, "counted": len(rows),
                         "unsolved": sum(row["verdict"] != "solved" for row in rows),
                         "best": sum(row["verdict"] == "solved"
                                     and row["median_ns"] == best[row["instance"]] for row in rows)}
                for solver, rows in counted.items()}

    def test_ratios_are_recomputed_when_a_solver_is_hidden(self):
        self.choose_corpus("squat-like")
        before = self.profile()
        self.assertEqual(before, self.expected_profile("squat-like", set()))
        solvers = list(dict.fromkeys(row["solver"] for row in self.rows))
        winner = max(before.values(), key=lambda row: row["best"])["solver"]
        self.browser.click(f"input[name=solver][value='{solvers.index(winner)}']")
        after = self.profile()
        self.assertNotIn(winner, after)
        self.assertEqual(after, self.expected_profile("squat-like", {winner}))
        self.assertNotEqual({s: row["best"] for s, row in after.items()},
                            {s: before[s]["best"] for s in after})

    def sheet(self, *words):
        """The groups of the sheet by name, with what it says of each solver."""
        sheet = json.loads(lcpbench("sheet", str(self.run_directory), "--format", "json",
                                    "--out", str(self.directory / "sheet"), *words))
        return {group["name"]: {sheet["settings"][row["setting"]]["solver"]: row
                                for row in group["rows"]} for group in sheet["groups"]}

    def test_profiles_are_those_of_the_sheet(self):
        for measure in ("time", "pivots", "nodes"):
            groups = self.sheet("--measure", measure)
            self.browser.choose("#measure", measure)
            for corpus in ("squat-like", "published", "all corpora"):
                self.choose_corpus(corpus)
                shown = {row["solver"]: row for row in self.browser.run("""
                    return [...document.querySelectorAll('#profile .numbers tr[data-solver]')].map(
                      tr => ({ solver: tr.dataset.solver, counted: +tr.dataset.counted,
                               best: +tr.dataset.best, ratios: tr.dataset.ratios }))""")}
                expected = {solver: row for solver, row in groups[corpus].items()
                            if row["profile"]["counted"] > 0}
                self.assertEqual(set(shown), set(expected), (measure, corpus))
                for solver, row in expected.items():
                    self.assertEqual(shown[solver]["counted"], row["profile"]["counted"])
                    self.assertEqual(shown[solver]["best"], row["best"])
                    ratios = [float(f"{float(ratio):.4g}") for ratio in shown[solver]["ratios"].split()]
                    self.assertEqual(len(ratios), len(row["profile"]["reached"]))
                    for ratio, true in zip(ratios, row["profile"]["reached"]):
                        self.assertAlmostEqual(ratio, true, delta=2e-3 * true)

    def test_the_front_is_that_of_the_sheet_at_every_tolerance(self):
        for tolerance in (None, "1e-03", "1e-12"):
            groups = self.sheet(*(["--tolerance", tolerance] if tolerance else []))
            if tolerance:
                self.browser.choose("#tolerance", str(float(tolerance)).replace("e-0", "e-"))
            for corpus in ("squat-like", "published", "stack", "all corpora"):
                self.choose_corpus(corpus)
                shown = dict(self.browser.run("""
                    return [...document.querySelectorAll('#plane .numbers tr[data-solver]')].map(
                      tr => [tr.dataset.solver, tr.dataset.front === 'yes'])"""))
                self.assertEqual(shown, {solver: row["front"]
                                         for solver, row in groups[corpus].items()})

    def test_cumulative_curves_end_at_the_shares_of_the_sheet(self):
        self.choose_corpus("squat-like")
        solvers = list(dict.fromkeys(row["solver"] for row in self.rows))
        self.browser.choose("#cumulative-of", str(solvers.index("best-first")))
        tails = self.browser.run("""
            return [...document.querySelectorAll('#cumulative svg text')].map(t => t.textContent)
              .filter(words => words.startsWith('to 1e-') || words.startsWith('to 0.'))""")
        sheet = json.loads(lcpbench("sheet", str(self.run_directory), "--format", "json", "--out",
                                    str(self.directory / "sheet"), "--corpus", "squat-like"))
        row = next(row for row in sheet["groups"][0]["rows"]
                   if sheet["settings"][row["setting"]]["solver"] == "best-first")
        expected = {float(accuracy): f"{len(curve['reached'])} of {curve['counted']}"
                    for accuracy, curve in zip(sheet["accuracies"], row["within"])}
        shown = {float(tail.split(":")[0].removeprefix("to ")): tail.split(": ")[1] for tail in tails}
        self.assertEqual(shown, expected)

    def test_a_solver_has_the_colour_of_the_other_pictures(self):
        self.choose_corpus("squat-like")
        self.sheet()
        chart = self.directory.joinpath("sheet", "chart.svg").read_text().replace(" ", "")
        looks = self.browser.run(
            "return JSON.parse(document.getElementById('data').textContent).variants.map(v => v.look)")
        self.assertEqual(len({(look["colour"], look["marker"]) for look in looks}), len(looks))
        for look in looks:
            self.assertIn(look["colour"], self.browser.run(
                "return document.querySelector('#plane svg').outerHTML"))
            red, green, blue = (int(look["colour"][i:i + 2], 16) for i in (1, 3, 5))
            written = f"rgb({red},{green},{blue})"  # As gnuplot does.
            self.assertIn(written, chart)

    def test_the_mass_on_the_plane_is_the_corpus(self):
        for corpus in ("squat-like", "published"):
            self.choose_corpus(corpus)
            masses = self.browser.run(
                "return [...document.querySelectorAll('#plane .numbers tr[data-mass]')]"
                ".map(tr => +tr.dataset.mass)")
            size = len({row["instance"] for row in self.rows if row["corpus"] == corpus})
            self.assertEqual(masses, [size] * 5)

    def test_points_on_the_plane_are_the_medians_of_the_table(self):
        self.choose_corpus("squat-like")
        points = self.browser.run("""
            return [...document.querySelectorAll('#plane .numbers tr[data-solver]')].map(tr => [
              tr.dataset.solver, tr.dataset.time, tr.dataset.residual])""")
        table = {row["solver"]: row["values"] for row in self.table_on_page()}
        self.assertEqual(len(points), len(table))
        for solver, milliseconds, residual in points:
            for text, key in ((milliseconds, "time_median_ms"), (residual, "residual_median")):
                value = table[solver][key]
                if value is None:
                    self.assertEqual(text, "")
                else:
                    self.assertAlmostEqual(float(text), value, delta=1e-12 * value)

    def test_every_chart_is_saved_as_svg_that_stands_alone(self):
        self.choose_corpus("squat-like")
        for chart in ("plane", "profile", "cumulative", "accuracy"):
            self.browser.click(f"#{chart} .save")
            file = self.downloads / f"run-{chart}-squat-like.svg"
            for _ in range(200):
                if file.exists():
                    break
                time.sleep(0.05)
            root = xml.etree.ElementTree.fromstring(file.read_text())
            self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
            self.assertGreater(len(list(root.iter("{http://www.w3.org/2000/svg}path"))), 4)
            words = "".join(root.itertext())
            self.assertIn("squat-like", words)
            self.assertIn("best-first", words)

    def test_charts_follow_their_own_choices(self):
        self.choose_corpus("squat-like")
        self.browser.choose("#measure", "pivots")
        self.assertRegex(
            self.browser.run("return document.querySelector('#profile svg').textContent"),
            r"count no pivots:\s*projected-gauss-seidel")
        self.browser.choose("#cumulative-of", "2")
        self.assertIn("to 1e-12",
                      self.browser.run("return document.querySelector('#cumulative svg').textContent"))

    def test_pictures_are_shown(self):
        width = self.browser.run("return document.querySelector('#pictures img').naturalWidth")
        self.assertEqual(width, 30)

    def test_committed_runs_open_whole_and_small(self):
        for name in ("default", "peers"):
            run = unpacked(name, self.directory)
            lcpbench("report", str(run))
            self.assertLess(run.joinpath("report.html").stat().st_size, LARGEST)
            self.open(run)
            self.choose_corpus("all corpora")
            rows = len(run.joinpath("rows.jsonl").read_text().splitlines())
            self.assertEqual(
                self.browser.run("return document.querySelectorAll('#matrix td[data-row]').length"),
                rows)
            self.assertEqual(self.browser.run("return document.querySelectorAll('svg[role=img]').length"),
                             4)


if __name__ == "__main__":
    if not (shutil.which("chromium") and shutil.which("chromedriver")):
        print("skipped: chromium and chromedriver are not installed (scripts/setup --tests)")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
