"""What the tests of faults share: running burl with the library of faults, and judging what it leaves."""
import errno, hashlib, os, pathlib, re, shutil, signal, struct, subprocess, sys, zlib

sys.dont_write_bytecode = True
TIME_LIMIT = 120  # seconds after which a run has hung
EVERY = "BURL_ALL_FAULTS" in os.environ  # every number, not a few of them
RECORD = ".burl.json"
# glibc 2.36: dlopen(), which oneTBB calls once, reads through a null pointer where it can keep no message (dlerror.c:151).
GLIBC_FALLS = 1


class Outcome:
    """How a run ended: its exit code, negative for a signal, and what it said on stderr."""

    def __init__(self, code, err):
        self.code, self.err = code, err


class Burl:
    """The program, run with or without faults."""

    def __init__(self, program, library, folder):
        self.program, self.library = str(pathlib.Path(program).resolve()), str(pathlib.Path(library).resolve())
        self.folder = pathlib.Path(folder).resolve()
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def environment(self, faults):
        """The variables of a run: faults are those of faults.h without BURL_FAULT_."""
        more = {"BURL_FAULT_" + name.upper(): str(value) for name, value in faults.items()}
        if faults: more["LD_PRELOAD"] = self.library
        return os.environ | more

    def run(self, words, cwd=None, env=None, limits=None, stdout=subprocess.DEVNULL, seconds=TIME_LIMIT, **faults):
        try:
            done = subprocess.run([self.program, *map(os.fspath, map(str, words))], cwd=cwd or self.folder, stdin=subprocess.DEVNULL,
                                  stdout=stdout, stderr=subprocess.PIPE, timeout=seconds, preexec_fn=limits,
                                  env=self.environment(faults) if env is None else env)
        except subprocess.TimeoutExpired:
            return Outcome(None, "it hangs")
        return Outcome(done.returncode, done.stderr.decode("utf-8", "backslashreplace"))

    def count(self, words, calls, cwd=None, **more):
        """The number of such calls that the run makes."""
        place = self.folder / "count.txt"
        outcome = self.run(words, cwd, calls=calls, count=place, **more)
        assert outcome.code == 0, outcome.err
        return int(place.read_text())


def contents(folder):
    """Names and bytes of all files in a folder."""
    return {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}


def is_whole_record(data):
    """Whether a record ends with the SHA-256 of all that is before it."""
    match = re.fullmatch(rb'(.*),\n  "sha256": "([0-9a-f]{64})"\n}\n', data, re.S)
    return bool(match) and hashlib.sha256(match[1]).hexdigest().encode() == match[2]


def sentence_problem(err):
    """What is wrong about the messages of a run that failed: one line of burl's must say why, after warnings at most. Beside it
    METIS, whose thread may be another, tells how much memory it has."""
    lines = [line for line in err.splitlines() if not re.fullmatch(r" +(Current|Maximum) memory used: .*", line)]
    if not lines or not lines[-1].startswith("burl: ") or len(lines[-1]) < 20: return f"no sentence: {err!r}"
    if sum(line.startswith("burl: ") for line in lines) != 1: return f"several sentences: {err!r}"
    return ""


def output_problem(found, old, new):
    """What is wrong about a folder, which must be as old or as new but for the record, which must be whole."""
    names = {name for name in {**old, **new, **found} if not name.endswith(RECORD)}
    for name in sorted(set(found) - set(old) - set(new)): return f"{name} is left over"
    changed = {name: found.get(name) for name in names}
    if changed not in ({n: old.get(n) for n in names}, {n: new.get(n) for n in names}):
        return "neither old nor new: " + ", ".join(
            f"{n} {'old' if changed[n] == old.get(n) else 'new' if changed[n] == new.get(n) else 'broken'}" for n in sorted(names))
    for name, data in found.items():
        if name.endswith(RECORD) and data != old.get(name) and not is_whole_record(data): return f"{name} is damaged"
    return ""


def is_new(found, new):
    return all(found.get(name) == data for name, data in new.items() if not name.endswith(RECORD))


def problem(outcome, found, old, new, codes):
    """What is wrong about a run that met a fault; codes are the exit codes that it may fail with."""
    if outcome.code is None: return "it hangs"
    if outcome.code < 0: return f"ended by {signal.Signals(-outcome.code).name}: {outcome.err!r}"
    wrong = output_problem(found, old, new)
    if wrong: return f"exit code {outcome.code}, {outcome.err!r}: {wrong}"
    if outcome.code == 0: return "" if is_new(found, new) else "exit code 0 without the new output"
    if outcome.code not in codes: return f"exit code {outcome.code}: {outcome.err!r}"
    told = RECORD in outcome.err or "out of memory" in outcome.err  # only the record is missing
    if is_new(found, new) and old and not is_new(found, old) and not told:
        return f"failed with the new output in place: {outcome.err!r}"
    return sentence_problem(outcome.err)


def png(width, height, kind, depth=8):
    """A picture of one colour; kind is PNG's type of colour."""
    def chunk(name, data): return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    row = b"\0" + b"\x7f" * (width * {0: 1, 2: 3, 3: 1, 6: 4}[kind] * depth // 8)
    packer = zlib.compressobj(9)
    pixels = b"".join(packer.compress(row) for _ in range(height)) + packer.flush()
    palette = chunk(b"PLTE", b"\x10\x20\x30" * 256) if kind == 3 else b""
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, depth, kind, 0, 0, 0)) + palette + chunk(b"IDAT", pixels) \
        + chunk(b"IEND", b"")


class Stage:
    """An output folder that holds an old bake before every run, and the new bake that it should become."""

    def __init__(self, burl, name, words, out, recipe="marble"):
        self.burl, self.place, self.recipe = burl, burl.folder / name, recipe
        self.out, self.kept = self.place / "out", self.place / "kept"
        self.kept.mkdir(parents=True)
        self.words = ["bake", *words, "--quiet", "-o", f"out/{out}"]
        self.new = self.made(recipe)
        self.old = self.made("wood")
        for path, data in self.old.items(): (self.kept / path).write_bytes(data)

    def made(self, recipe):
        shutil.rmtree(self.out, ignore_errors=True)
        self.out.mkdir()
        outcome = self.burl.run([*self.words, "--recipe", recipe], self.place)
        assert outcome.code == 0, outcome.err
        return contents(self.out)

    def reset(self, empty=False):
        shutil.rmtree(self.out, ignore_errors=True)
        self.out.mkdir()
        if not empty:
            for path in self.kept.iterdir(): shutil.copy2(path, self.out)

    def run(self, **faults):
        """The problem of a bake of the new recipe with these faults, over the old output."""
        codes = faults.pop("codes", (2, 4))
        self.reset()
        outcome = self.burl.run([*self.words, "--recipe", self.recipe], self.place, **faults)
        return problem(outcome, contents(self.out), self.old, self.new, codes), outcome

    def count(self, calls):
        self.reset()
        return self.burl.count([*self.words, "--recipe", self.recipe], calls, self.place)


class Report:
    """Counts what was tried, prints what went wrong, and is the exit code."""

    def __init__(self):
        self.tried, self.failed = 0, 0

    def add(self, what, wrong):
        self.tried += 1
        if not wrong: return
        self.failed += 1
        if self.failed <= 20: print(f"FAILED {what}: {wrong}", flush=True)

    def end(self, name):
        print(f"{name}: {self.tried} tried, {self.failed} failed")
        return 1 if self.failed or not self.tried else 0
