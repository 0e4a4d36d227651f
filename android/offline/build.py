"""The offline build, without the Android SDK: build.py compile | test [CLASS…] | shots [CLASS…] | apk.

The same sources, resources, manifest and version catalog as Android Studio's; the frameworks are Robolectric's. What it makes is
in `build/android`, what it fetches in `~/.cache/gyradius-android`. A step whose inputs did not change since its last success is not
compiled again, nor in another clone (`tests/cached.py`); tests always run.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import subprocess
import sys
import time
import zipfile
from pathlib import Path

from catalog import ANDROID, Catalog
from fetch import CACHE, Artifact, fetch
from pack import Pack
from resolve import Resolver
from resources import Resources

sys.path.append(str(ANDROID.parent / "tests"))
from cached import Cache, Step

ROOT = ANDROID.parent
OUT = ROOT / "build" / "android"
PACKAGE = "org.gyradius.app"
# Of `prebuilt/linux/aapt2` in the pinned version of apktool-lib.
AAPT2_SHA256 = "df312db814c018019b2b79a993b041b738d7b76f4a8f28da25bc874a026368cc"
GENERATED = OUT / "generated"
FACE = [ROOT / "bindings/kotlin/src/main/kotlin", GENERATED]
MAIN = [ANDROID / "app/src/main/kotlin"]
TESTS = [ANDROID / "app/src/test/kotlin"]
RIGS = ROOT / "python/gyradius/rigs"
SCRIPTS = sorted(Path(__file__).parent.glob("*.py"))
COMPILER = "org.jetbrains.kotlin.cli.jvm.K2JVMCompiler"


def main(what: str, only: list[str]) -> None:
    """Runs one of the recipes."""
    build = Build()
    build.compile()
    if what in ("test", "shots"):
        build.test(OUT / "shots" if what == "shots" else None, only)
    if what == "apk":
        build.apk()


class Build:
    """Files that the steps share."""

    def __init__(self) -> None:
        self.catalog = Catalog()
        app = self._resolved("android", ["app"], [])
        self.files = self._resolved("android", ["app", "test"], [])
        self.compiler = self._resolved("jvm", [], ["kotlin-compiler"])
        self.plugin = self._alone("kotlin-compose-plugin")
        self.framework = self._alone("android-all")
        self.cache = Cache(ROOT)
        # Versions, and what variables of the environment tell every Java.
        self.java = "".join(printed([tool, "-version"]) for tool in ("java", "javac"))
        self.app_jars = [jar for one in app for jar in jars_of(one)]
        self.jars = [jar for one in self.files for jar in jars_of(one)]

    def _resolved(self, platform: str, bundles: list[str], libraries: list[str]) -> list[Artifact]:
        roots = [one for name in bundles for one in self.catalog.bundle(name)]
        roots += [self.catalog.library(name) for name in libraries]
        key = hashlib.sha256(json.dumps([platform, roots]).encode()).hexdigest()[:16]
        known = CACHE / f"resolved-{key}.json"
        if known.exists():
            files = [Artifact(*one) for one in json.loads(known.read_text(encoding="utf-8"))]
            fetch(files)
            return files
        files = Resolver(platform).resolve(roots)
        listed = [[one.group, one.name, one.version, one.kind] for one in files]
        known.write_text(json.dumps(listed, indent=0), encoding="utf-8")
        return files

    def _alone(self, library: str) -> Path:
        module, version = self.catalog.library(library)
        one = Artifact(*module, version)
        fetch([one])
        return one.path()

    def compile(self) -> None:
        """Resources, R classes, the app and its tests."""
        OUT.mkdir(parents=True, exist_ok=True)
        self._resources()
        # UniFFI's part of the Kotlin package.
        run(["bindings/generate", "kotlin", str(GENERATED)])
        # By itself: it seldom changes, and is most of what there is to compile.
        face, app, tests = OUT / "face-classes", OUT / "classes", OUT / "test-classes"
        self._kotlinc("facade", FACE, face, [*self.app_jars, self.framework])
        self._kotlinc("app", MAIN, app, [face, OUT / "r-classes", *self.app_jars, self.framework])
        path = [app, face, OUT / "r-classes", *self.jars, self.framework]
        self._kotlinc("tests", TESTS, tests, path, f"-Xfriend-paths={relative(app)}")

    def _resources(self) -> None:
        merger = self._resolved("jvm", [], ["manifest-merger"])
        aars = [one for one in self.files if one.kind == "aar"]
        main = ANDROID / "app/src/main"
        resources = Resources(OUT, PACKAGE, self._aapt2(), self.framework, merger, self.catalog.versions)
        tools = [self._aapt2(), self.framework, *(one.path() for one in [*merger, *aars])]
        inputs = [main / "AndroidManifest.xml", main / "res", RIGS, ANDROID / "gradle/libs.versions.toml", *tools]
        made = ["AndroidManifest.xml", "resources.apk", "R.txt", "assets", "r-classes"]
        self._step("resources", inputs, [], made, lambda: resources.link(main, [unpacked(one) for one in aars], [RIGS]))

    def _kotlinc(self, name: str, sources: list[Path], to: Path, path: list[Path], *more: str) -> None:
        compiler = [one.path() for one in self.compiler]
        options = ["-no-stdlib", "-no-reflect", "-jvm-target", "11", "-nowarn", f"-Xplugin={self.plugin}", *more]
        options += ["-d", relative(to), "-cp", os.pathsep.join(map(relative, path))]

        def work() -> None:
            files = sorted(relative(file) for folder in sources for file in folder.rglob("*.kt"))
            arguments = to.with_suffix(".args")
            arguments.write_text("\n".join([*options, *files]), encoding="utf-8")
            run(["java", "-Xmx2g", "-cp", os.pathsep.join(map(str, compiler)), COMPILER, f"@{arguments}"])

        self._step(name, [*sources, *path, *compiler, self.plugin], options, [to.name], work)

    def _step(self, name: str, inputs: list[Path], texts: list[str], made: list[str], work) -> None:
        """Compiles something, or takes it from the cache. Paths in the repository are relative, so that every clone has the same key."""
        outputs = [Path(relative(OUT / one)) for one in made]
        one = Step(f"android-{name}", [*SCRIPTS, *inputs], texts=[self.java, *texts], outputs=outputs)
        step(name, lambda: self.cache.run(one, lambda: work() or ""))

    def test(self, shots: Path | None, only: list[str]) -> None:
        """Runs every test class under Robolectric, or only some."""
        framework = self._alone("android-all-instrumented")
        (OUT / "test-config/com/android/tools").mkdir(parents=True, exist_ok=True)
        config = OUT / "test-config/com/android/tools/test_config.properties"
        config.write_text(test_config(), encoding="utf-8")
        path = [OUT / "test-config", ANDROID / "app/src/test/resources", OUT / "test-classes", OUT / "classes"]
        path += [OUT / "face-classes", OUT / "r-classes", *self.jars, self.framework]
        classes = sorted(str(one.relative_to(TESTS[0]).with_suffix("")).replace("/", ".") for one in TESTS[0].rglob("*Test.kt"))
        classes = [one for one in classes if not only or one.rpartition(".")[2] in only]
        properties = {
            "robolectric.offline": "true",
            "robolectric.dependency.dir": framework.parent,
            "robolectric.pixelCopyRenderMode": "hardware",
            "jna.library.path": ROOT / "target/debug",
            "gyradius.root": ROOT,
            "gyradius.shots": shots or "",
        }
        flags = [f"-D{name}={value}" for name, value in properties.items()]
        # Robolectric closes files by reflection.
        command = ["java", "-Xmx3g", "--add-opens=java.base/java.io=ALL-UNNAMED", *flags, "-cp", os.pathsep.join(map(str, path)), f"{PACKAGE}.EverythingKt", *classes]
        step("robolectric", lambda: run(command))

    def apk(self) -> None:
        """A debug APK, and what Android reads of it."""
        d8 = self._alone("r8")
        pack = Pack(OUT, d8, self._alone("apksig"), self.framework, self.catalog.versions["minSdk"])
        (group, name), version = self.catalog.library("jna")
        jna = Artifact(group, name, version, "aar")
        fetch([jna])
        classes = [OUT / "classes", OUT / "face-classes", OUT / "r-classes"]
        inputs = [*classes, *self.app_jars, d8, self.framework]
        self._step("dex", inputs, [self.catalog.versions["minSdk"]], ["dex"], lambda: pack.dex(classes, self.app_jars))
        apk = pack.apk(unpacked(jna))
        print(apk.relative_to(ROOT), flush=True)
        run([str(self._aapt2()), "dump", "badging", str(apk)])

    def _aapt2(self) -> Path:
        tool = CACHE / f"aapt2-{self.catalog.versions['apktool']}"
        if not tool.exists():
            with zipfile.ZipFile(self._alone("apktool-lib")) as jar:
                tool.write_bytes(jar.read("prebuilt/linux/aapt2"))
            tool.chmod(0o755)
        found = hashlib.sha256(tool.read_bytes()).hexdigest()
        if found != AAPT2_SHA256:
            sys.exit(f"{tool}: expected SHA-256 {AAPT2_SHA256}, found {found}")
        return tool


def unpacked(aar: Artifact) -> Path:
    """The folder that an AAR is unpacked in."""
    folder = CACHE / "aars" / f"{aar.group}-{aar.name}-{aar.version}"
    if not folder.exists():
        partly = folder.with_suffix(".partly")
        shutil.rmtree(partly, ignore_errors=True)
        with zipfile.ZipFile(aar.path()) as packed:
            packed.extractall(partly)
        partly.rename(folder)
    return folder


def jars_of(one: Artifact) -> list[Path]:
    """Its classes."""
    if one.kind != "aar":
        return [one.path()]
    folder = unpacked(one)
    return [jar for jar in [folder / "classes.jar", *sorted(folder.glob("libs/*.jar"))] if jar.exists()]


def test_config() -> str:
    """Where Robolectric finds the app's resources."""
    entries = {
        "android_custom_package": PACKAGE,
        "android_merged_manifest": OUT / "AndroidManifest.xml",
        "android_resource_apk": OUT / "resources.apk",
        "android_merged_assets": OUT / "assets",
        "android_merged_resources": ANDROID / "app/src/main/res",
    }
    return "".join(f"{name}={value}\n" for name, value in entries.items())


def relative(path: Path) -> str:
    """A path as the tools get it, which run in the repository's root."""
    return str(path.relative_to(ROOT) if path.is_relative_to(ROOT) else path)


def step(name: str, what) -> None:
    """Does one step and says how long it took."""
    start = time.monotonic()
    what()
    print(f"{name}: {time.monotonic() - start:.1f} s", flush=True)


def printed(command: list[str]) -> str:
    """What a command prints, on either stream."""
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=True).stdout


def run(command: list[str]) -> None:
    """Runs a command; its failure is ours."""
    done = subprocess.run(command, cwd=ROOT, check=False)
    if done.returncode:
        sys.exit(f"{Path(command[0]).name} failed with {done.returncode}")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "compile", sys.argv[2:])
