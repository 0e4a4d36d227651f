"""A signed debug APK of what `build.py` compiled: D8, the linked resources, JNA's own libraries, apksig.

The library's native code for a phone needs an NDK (android/README.md): where it is not in `app/src/main/jniLibs`, the APK's name
says that it is not inside.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

from catalog import ANDROID

STORE_PASSWORD = "android"
NATIVE = ANDROID / "app/src/main/jniLibs"


class Pack:
    """Makes one APK in a folder."""

    def __init__(self, out: Path, d8: Path, apksig: Path, framework: Path, min_sdk: str) -> None:
        self.out = out
        self.d8 = d8
        self.apksig = apksig
        self.framework = framework
        self.min_sdk = min_sdk

    def apk(self, jna: Path) -> Path:
        """Packs and signs what `dex` and `Resources` made."""
        has_core = any(NATIVE.rglob("libgyradius_ffi.so"))
        whole = self.out / "unsigned.apk"
        with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED) as packed:
            self._copy_resources(packed)
            for one in sorted((self.out / "dex").glob("*.dex")):
                packed.write(one, one.name)
            for folder in [jna / "jni", NATIVE]:
                for one in sorted(folder.rglob("*.so")):
                    packed.write(one, f"lib/{one.relative_to(folder).as_posix()}")
        name = "gyradius-debug.apk" if has_core else "gyradius-debug-without-native-core.apk"
        self._sign(whole, self.out / name)
        whole.unlink()
        return self.out / name

    def dex(self, classes: list[Path], jars: list[Path]) -> None:
        """Compiles classes for the phone, into the folder `dex`."""
        own = self.out / "app.jar"
        with zipfile.ZipFile(own, "w") as jar:
            for folder in classes:
                for one in sorted(folder.rglob("*.class")):
                    jar.write(one, one.relative_to(folder))
        dex = self.out / "dex"
        shutil.rmtree(dex, ignore_errors=True)
        dex.mkdir()
        command = ["java", "-Xmx2g", "-cp", str(self.d8), "com.android.tools.r8.D8", "--debug", "--min-api", self.min_sdk]
        command += ["--lib", str(self.framework), "--output", str(dex), str(own)]
        self._run([*command, *map(str, jars)])

    def _copy_resources(self, packed: zipfile.ZipFile) -> None:
        """Each file as aapt2 packed it: Android maps `resources.arsc` as it stands."""
        with zipfile.ZipFile(self.out / "resources.apk") as resources:
            for one in resources.infolist():
                packed.writestr(one, resources.read(one), compress_type=one.compress_type)

    def _sign(self, unsigned: Path, signed: Path) -> None:
        store = self.out / "debug.p12"
        if not store.exists():
            command = ["keytool", "-genkeypair", "-keystore", str(store), "-storetype", "PKCS12", "-storepass", STORE_PASSWORD]
            command += ["-alias", "debug", "-keyalg", "RSA", "-keysize", "2048", "-validity", "10000", "-dname", "CN=gyradius debug"]
            self._run(command)
        program = Path(__file__).with_name("Sign.java")
        self._run(["java", "-cp", str(self.apksig), str(program), str(store), STORE_PASSWORD, self.min_sdk, str(unsigned), str(signed)])

    def _run(self, command: list[str]) -> None:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            sys.exit(f"{Path(command[0]).name} failed with {done.returncode}:\n{done.stdout}{done.stderr}")
