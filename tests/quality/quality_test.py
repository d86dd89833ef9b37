#!/usr/bin/env python3
"""Tests of the judge of the table of quality, of what fetches its meshes, and of its page."""
import copy, gzip, io, json, pathlib, sys, tarfile, tempfile, unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import fetch, page, quality

KEPT = {("cube", "chart"): {"mesh": "cube", "kind": "chart", "coverage": 0.8, "kernels": 2.0, "ms": 30.0}
        | {column: 0.1 for column in quality.ERRORS} | {"stretch50": 1.1, "stretch95": 1.5, "vertices": 1.2}}


def judged(**changes):
    """The columns that are worse where the cube's figures are multiplied by factors."""
    now = copy.deepcopy(KEPT)
    for column, factor in changes.items(): now["cube", "chart"][column] *= factor
    return [worse[2] for worse in quality.judged(KEPT, now)]


class Judge(unittest.TestCase):
    def test_equal_rows_pass(self):
        self.assertEqual(judged(), [])

    def test_every_figure_is_judged(self):
        for column in quality.HIGHER_IS_WORSE:
            self.assertEqual(judged(**{column: 1.04}), [column])
            self.assertEqual(judged(**{column: 1.02}), [])
            self.assertEqual(judged(**{column: 0.5}), [])
        self.assertEqual(judged(coverage=0.96), ["coverage"])
        self.assertEqual(judged(coverage=0.98), [])
        self.assertEqual(judged(coverage=1.2), [])

    def test_times_are_judged_in_kernels(self):
        self.assertEqual(judged(kernels=1.14), [])
        self.assertEqual(judged(kernels=1.16), ["kernels"])
        self.assertEqual(judged(ms=10.0), [])
        self.assertFalse(quality.is_worse("kernels", 0.03, 0.57))
        self.assertTrue(quality.is_worse("kernels", 0.03, 0.58))

    def test_errors_of_nothing_are_not_judged(self):
        kept, now = copy.deepcopy(KEPT), copy.deepcopy(KEPT)
        kept["cube", "chart"]["L0"], now["cube", "chart"]["L0"] = 1e-6, 3e-6
        self.assertEqual(quality.judged(kept, now), [])
        now["cube", "chart"]["L0"] = 1e-4
        self.assertEqual(len(quality.judged(kept, now)), 1)

    def test_an_update_keeps_times_that_did_not_change(self):
        now = copy.deepcopy(KEPT)
        now["cube", "chart"] |= {"kernels": 2.1, "L3": 0.2}
        (row,) = quality.updated(KEPT, now)
        self.assertEqual((row["kernels"], row["L3"]), (2.0, 0.2))
        for time in (1.5, 2.5):
            now["cube", "chart"]["kernels"] = time
            self.assertEqual(quality.updated(KEPT, now)[0]["kernels"], time)
        other = {("ball", "patch"): KEPT["cube", "chart"] | {"mesh": "ball", "kind": "patch"}}
        self.assertEqual([row["mesh"] for row in quality.updated(KEPT, other)], ["ball", "cube"])

    def test_what_is_not_there_is_worse(self):
        now = copy.deepcopy(KEPT)
        del now["cube", "chart"]["L3"]
        self.assertEqual([worse[2] for worse in quality.judged(KEPT, now)], ["L3"])
        self.assertEqual(judged(L2=float("nan")), ["L2"])
        self.assertEqual(len(quality.judged({}, KEPT)), 1)

    def test_the_kernel_is_the_tables(self):
        # Whoever changes the kernel, its comments too, measures the table anew with --update.
        self.assertEqual(fetch.sha256((quality.HERE / "reference_kernel.h").read_bytes()),
                         "2dbb836d7f5d6be30a8e73b1bcbc7a7e92727860254060087689b90b37fda227")

    def test_rows_survive_the_table(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "table.csv"
            quality.write_table(path, KEPT.values())
            self.assertEqual(quality.read_table(path), KEPT)
            self.assertEqual(quality.judged(quality.read_table(path), KEPT), [])

    def test_the_committed_table_is_whole(self):
        rows = quality.read_table(quality.TABLE)
        meshes = json.loads((quality.HERE / "meshes.json").read_text())["meshes"]
        self.assertEqual(set(rows), {(mesh, kind) for mesh in meshes for kind in quality.KINDS})
        self.assertEqual(quality.judged(rows, rows), [])

    def test_the_page_has_the_tables_figures(self):
        text, rows = page.PAGE.read_text(), quality.read_table(quality.TABLE)
        self.assertEqual(page.refreshed(rows), text)
        for key in rows: rows[key]["L1"] *= 2.0
        self.assertNotEqual(page.refreshed(rows), text)

    def test_quotients_are_of_the_better_xatlas(self):
        rows = {("a", "chart"): {"L1": 2.0}, ("b", "chart"): {"L1": 1.0}}
        others = [{"mesh": "a", "L1": 4.0}, {"mesh": "a", "L1": 1.0}, {"mesh": "b", "L1": 2.0}, {"mesh": "c", "L1": 1.0}]
        self.assertEqual(page.quotients(rows, others, "chart", "L1"), [0.5, 2.0])


def tar(**files):
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode="w:gz") as archive:
        for name, content in files.items():
            info = tarfile.TarInfo("./" + name)
            info.size = len(content)
            archive.addfile(info, io.BytesIO(content))
    return data.getvalue()


def deb(files):
    """A Debian package whose files are that tar archive."""
    members = [("debian-binary", b"2.0\n"), ("control.tar.xz", b"odd"), ("data.tar.gz", files)]
    return b"!<arch>\n" + b"".join(
        f"{name:<16}{0:<12}{0:<6}{0:<6}{100644:<8}{len(data):<10}`\n".encode() + data + b"\n" * (len(data) % 2)
        for name, data in members)


class Fetch(unittest.TestCase):
    def fetched(self, archive, **meshes):
        """The contents that came, and why the others did not."""
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder) / "source.tgz"
            source.write_bytes(archive)
            listed = {"archives": {"a": {"address": source.as_uri(), "sha256": fetch.sha256(archive)},
                                   "none": {"address": source.as_uri() + ".gone", "sha256": ""}}, "meshes": meshes}
            paths, absent = fetch.fetch(listed, pathlib.Path(folder) / "kept")
            return {name: path.read_bytes() for name, path in paths.items()}, absent

    def test_members_of_members(self):
        inner = tar(**{"x.off": b"OFF", "y.ply.gz": gzip.compress(b"ply")})
        mesh = lambda path, data: {"archive": "a", "member": path, "sha256": fetch.sha256(data)}
        got, absent = self.fetched(deb(tar(**{"data.tgz": inner})), x=mesh("data.tgz!x.off", b"OFF"), y=mesh("data.tgz!y.ply.gz!", b"ply"))
        self.assertEqual((got, absent), ({"x": b"OFF", "y": b"ply"}, {}))

    def test_what_is_not_the_mesh_is_refused_by_name(self):
        mesh = lambda archive, path, data: {"archive": archive, "member": path, "sha256": fetch.sha256(data)}
        got, absent = self.fetched(tar(**{"x.off": b"OFF"}), good=mesh("a", "x.off", b"OFF"), other=mesh("a", "x.off", b"PLY"),
                                   gone=mesh("a", "y.off", b"OFF"), far=mesh("none", "x.off", b"OFF"))
        self.assertEqual(list(got), ["good"])
        self.assertEqual(sorted(absent), ["far", "gone", "other"])

    def test_another_archive_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder) / "source.tgz"
            source.write_bytes(tar(x=b"OFF"))
            listed = {"archives": {"a": {"address": source.as_uri(), "sha256": fetch.sha256(b"another")}},
                      "meshes": {"x": {"archive": "a", "member": "x", "sha256": fetch.sha256(b"OFF")}}}
            self.assertEqual(list(fetch.fetch(listed, folder)[1]), ["x"])


if __name__ == "__main__": unittest.main()
