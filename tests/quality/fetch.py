"""Public meshes by address and sha256: fetched once, and taken out of the packages that hold them."""
import gzip, hashlib, io, pathlib, tarfile, urllib.request


class Unavailable(Exception):
    """A file that cannot be had, in a sentence."""


def sha256(data):
    return hashlib.sha256(data).hexdigest()


def checked(data, wanted, name):
    if sha256(data) != wanted: raise Unavailable(f"{name} has another sha256 than the table's")
    return data


def downloaded(archive, folder):
    """The bytes of an archive, kept in the folder."""
    kept = folder / archive["address"].rsplit("/", 1)[1]
    if kept.exists() and sha256(kept.read_bytes()) == archive["sha256"]: return kept.read_bytes()
    try:
        with urllib.request.urlopen(archive["address"], timeout=60) as answer: data = answer.read()
    except OSError as error:
        raise Unavailable(f"{archive['address']}: {error}")
    checked(data, archive["sha256"], archive["address"])
    kept.write_bytes(data)
    return data


def package_data(deb):
    """The inner archive of a Debian package's files: a package is an ar archive of three members."""
    at = 8
    while at + 60 <= len(deb):
        name, size = deb[at:at + 16].decode().rstrip(" /"), int(deb[at + 48:at + 58])
        if name.startswith("data.tar"): return deb[at + 60:at + 60 + size]
        at += 60 + size + size % 2
    raise Unavailable("a Debian package holds no files")


def opened(data):
    """The archive's bytes as a tar archive."""
    return tarfile.open(fileobj=io.BytesIO(package_data(data) if data[:8] == b"!<arch>\n" else data))


def member(data, path):
    """A member of an archive; `a!b` is b within the archive a, `a!` the archive a, a single file, uncompressed."""
    for part in path.split("!"):
        if not part: return gzip.decompress(data)
        with opened(data) as tar:
            names = {name.removeprefix("./"): name for name in tar.getnames()}
            if part not in names: raise Unavailable(f"{part} is not in its archive")
            data = tar.extractfile(names[part]).read()
    return data


def fetch(meshes, folder):
    """The paths of the meshes in the folder by name, and for those that cannot be had a sentence why not."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    paths, absent, archives = {}, {}, {}
    for name, mesh in meshes["meshes"].items():
        path = folder / (name + pathlib.Path(mesh["member"].rstrip("!").removesuffix(".gz")).suffix)
        if not (path.exists() and sha256(path.read_bytes()) == mesh["sha256"]):
            try:
                archive = mesh["archive"]
                if archive not in archives: archives[archive] = result_of(downloaded, meshes["archives"][archive], folder)
                if isinstance(archives[archive], Unavailable): raise archives[archive]
                path.write_bytes(checked(member(archives[archive], mesh["member"]), mesh["sha256"], name))
            except Unavailable as error:
                absent[name] = str(error)
                continue
        paths[name] = path
    return paths, absent


def result_of(function, *arguments):
    try:
        return function(*arguments)
    except Unavailable as error:
        return error
