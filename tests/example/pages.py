#!/usr/bin/env python3
"""Does what a page says, in an empty directory that holds links to the project's files, and fails where it cannot:

  ```sh       runs: every command must succeed
  ```console  runs: `$ command` must print the lines below it, but for times and sizes
  ```python   runs; ```cpp is there to be copied, or is a program that runs. Both are files of tests/example/
              word for word, which are built
  <!-- first: PAGE -->       does the first block of another page first
  <!-- check: COMMAND -->    must succeed as well

  pages.py PAGE LCPBENCH FOLDER   LCPBENCH and the examples' programs in FOLDER are built

A test has seconds: where a command takes minutes or changes the machine, another is run, as listed here.
Called by the name of `lcpbench`, it is the program with cheaper arguments.
"""
import fnmatch
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = pathlib.Path(__file__).resolve().parent
SKIPPED = 77

# What stands on the page, what is run instead, and why.
TEXT = [
    (r"git clone \S+ \S+ && cd \S+", "true", "needs the network"),
    (r"scripts/setup(?= |$)", "scripts/setup --dry-run", "installs packages"),
    (r"scripts/bench\b([^\n#]*)",
     r"bash -n scripts/bench; rm -rf runs/default; lcpbench run --suite default --out runs/default \1",
     "builds, and runs for a minute"),
    (r"scripts/test\b", "bash -n scripts/test", "builds and runs for half an hour"),
    (r"scripts/(paper-why|report-bundle)\b", r"test -x scripts/\1", "takes ten minutes; needs the network"),
    (r"scripts/results-page$", "scripts/results-page --check", "writes the pages"),
    (r"(?:cmake|cmake --build|ctest) --preset (\w+)[^&|#\n]*",
     r"""cmake --list-presets=all . | grep -c '"\1"' """, "builds, or runs every test"),
    (r"cmake (-D \S+ )+[^&|#\n]*", "true", "configures"),
    (r"LCPBENCH_WRITE_\w+=1 \S+/(test_\w+)", r"grep -rq \1 tests --include CMakeLists.txt", "writes what a test compares"),
    (r"build/\w+/tests/\S+/(test_\w+|bench_\w+)[^\n]*", r"grep -rq \1 tests --include CMakeLists.txt", "not built by every build"),
    (r"(\.\.[\d.e-]+)/\d+", r"\1/2", "fewer values of a knob"),
]
# Of a verb: options that are left out, and those that are set instead.
ARGUMENTS = [
    (("run", "sweep", "stability perturb"), ("--every", "--limit", "--timeout", "--jobs"),
     ["--limit", "1", "--timeout", "200ms"], "one instance of each corpus, and no solve that takes long"),
    (("stability perturb",), ("--trials",), ["--trials", "1"], "one changed version of each"),
    (("stability frontier",), ("--count", "--max-count", "--timeout"),
     ["--count", "1", "--max-count", "1", "--timeout", "1s"], "one draw of each cell"),
    (("stability loop",), ("--duration",), ["--duration", "60ms"], "net touches after 50 ms"),
    (("sufficient",), ("--duration", "--rounds"), ["--duration", "5ms", "--rounds", "1"], "a few steps, once"),
    (("paper",), ("--table",), ["--all", "--dry-run"], "takes half an hour"),
]
HOIST = "hoist:links=8,plates=1,lift=0,toss=0,clearance=0"  # in contact from the start, unlike hoist
WHOLE_SCENE = ("squat", "squat:swing=1")  # takes a second; others are cut short


def cheaper(words):
    """The arguments of lcpbench for a test: those above, frames by place, and rows that are built in."""
    verb = " ".join(words[:2]) if words[:1] == ["stability"] else words[0] if words else ""
    if verb == "paper" and "--figure" in words:  # takes seconds
        return words
    words = [word for word in words if verb != "paper" or word not in ("--choices", "--all")]
    for verbs, dropped, added, _ in ARGUMENTS:
        if verb in verbs and "--dry-run" not in words:
            words = without(words, dropped) + added
    if verb == "simulate" and words[1] not in WHOLE_SCENE:
        # hoist lands after 220 ms; frames of a shortened scene are few, and drawn at other times
        words = without(words, ("--duration", "--every", "--at"))
        words += ["--duration", "240ms" if words[1].startswith("hoist") else "60ms", "--every", "10"]
    if verb == "stability loop":
        words = [HOIST if word == "hoist" else word for word in words]
    if verb in ("run", "sweep", "stability perturb"):
        words = [re.sub(r"^(corpora/.*)#.*", r"\1", word) for word in words]  # those frames were not simulated
        words = [word for k, word in enumerate(words)  # two corpora are enough
                 if words[k - 1:k].count("--corpus") + word.count("--corpus") == 0 or words[:k + 1].count("--corpus") <= 2]
    return without_absent_peers(words)


def without(words, options):
    kept = []
    for word in words:
        if not (kept and kept[-1] in options):
            kept.append(word)
        else:
            kept.pop()
    return kept


def without_absent_peers(words):
    if not any(re.match("(siconos|bullet|dart)-", word) for word in words):
        return words
    listed = json.loads(subprocess.check_output([os.environ["LCPBENCH"], "list", "solvers", "--json"]))
    names = [row["name"] for row in listed["solvers"]]
    kept = []
    for word in words:
        name = word.split(":")[0]
        if kept and kept[-1] in ("--solver", "--add") and re.match("(siconos|bullet|dart)-", name) \
                and not fnmatch.filter(names, name):
            kept.pop()
        else:
            kept.append(word)
    return kept


def program(words):
    words = cheaper(words)
    status = subprocess.run([os.environ["LCPBENCH"], *words]).returncode
    return 0 if words[:1] == ["compare"] and status == 1 else status  # runs of one instance differ


def blocks(page):
    """(kind, text) of what a page has to do."""
    return [(match[1] or match[3], (match[2] or match[4]).strip("\n"))
            for match in re.finditer(r"^```(\w+)\n(.*?)^```$|<!-- (first|check): (.*?) -->", page, re.S | re.M)]


def cheap_text(text):
    for pattern, instead, _ in TEXT:
        text = re.sub(pattern, instead, text, flags=re.M)
    return text


def masked(printed):
    return [re.sub(r"[\d.,]+ (ms|us|s|MB|kB|min)\b", r"# \1", line).rstrip() for line in printed.strip().splitlines()]


class Page:
    def __init__(self, lcpbench, built, folder):
        self.built = pathlib.Path(built).resolve()
        self.environment = {**os.environ, "LCPBENCH": str(pathlib.Path(lcpbench).resolve())}
        for each in ROOT.iterdir():
            if each.name not in ("build", "runs", ".git"):
                (folder / each.name).symlink_to(each)
        programs = folder / "build/release"
        programs.mkdir(parents=True)
        (programs / "lcpbench").symlink_to(__file__)
        self.environment["PATH"] = f"{programs}:{os.environ['PATH']}"
        self.folder = folder
        (folder / "runs").mkdir()

    def ran(self, command, **changes):
        done = subprocess.run(command, cwd=self.folder, env={**self.environment, **changes}, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            words = command[-1] if isinstance(command, list) else command
            sys.exit(f"{done.stdout}\nstatus {done.returncode} of\n{words}")
        return done.stdout

    def sh(self, text, **_):
        print(self.ran(["bash", "-euo", "pipefail", "-c", cheap_text(text)]))

    check = sh

    def console(self, text, **_):
        """Without cheaper arguments, since what is printed stands below."""
        path = self.folder / "as-it-is"
        path.mkdir(exist_ok=True)
        if not (path / "lcpbench").exists():
            (path / "lcpbench").symlink_to(self.environment["LCPBENCH"])
        for part in re.split(r"^\$ ", text, flags=re.M)[1:]:
            command, _, expected = part.partition("\n")
            printed = self.ran(["bash", "-c", command], PATH=f"{path}:{self.environment['PATH']}")
            if masked(printed) != masked(expected):
                sys.exit(f"$ {command}\nprints\n{printed}\nand not\n{expected}")

    def example(self, text, ending):
        for file in EXAMPLES.glob("*." + ending):
            if file.read_text().strip("\n") == text:
                return file
        sys.exit(f"no file of tests/example/ is\n{text}")

    def cpp(self, text, **_):
        runs = self.built / self.example(text, "cpp").stem
        if runs.exists():
            self.ran([str(runs)])

    def python(self, text, **_):
        file = self.example(text, "py")
        for each in ("python3", "/usr/bin/python3"):  # a python that hides Debian's may lack its packages
            if subprocess.run([each, "-c", "import h5py, pandas"], stderr=subprocess.DEVNULL).returncode == 0:
                print(self.ran([each, str(file)]))
                return
        print("skipped: python3-h5py and python3-pandas are not installed (scripts/setup installs them)")
        sys.exit(SKIPPED)

    def do(self, page, most=None):
        for kind, text in blocks(page.read_text())[:most]:
            if kind == "first":
                self.do(page.parent / text, most=1)
                continue
            if not hasattr(self, kind):
                sys.exit(f"{page}: a block of '{kind}', known are sh, console, python, cpp")
            getattr(self, kind)(text)


def main():
    if pathlib.Path(sys.argv[0]).name == "lcpbench":
        sys.exit(program(sys.argv[1:]))
    page, lcpbench, built = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        Page(lcpbench, built, pathlib.Path(folder)).do(pathlib.Path(page).resolve())


if __name__ == "__main__":
    main()
