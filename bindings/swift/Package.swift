// swift-tools-version: 6.0
import PackageDescription

// On Apple's systems the library is in an xcframework that `tools/xcframework` makes. On Linux, where the tests run, it is the
// shared library of the tree's debug build; its flags bar nobody, since nobody depends on a package of a tree on Linux.
#if os(Linux)
  let library = Context.packageDirectory + "/../../target/debug"
  let core = Target.systemLibrary(name: "GyradiusFFI")
  let linked: [LinkerSetting] = [
    .linkedLibrary("gyradius_ffi"),
    .unsafeFlags(["-L", library, "-Xlinker", "-rpath", "-Xlinker", library]),
  ]
  // Swift's own libswiftObservation of Linux leaves a name unresolved that it needs in a crash only.
  let observed: [LinkerSetting] = [.unsafeFlags(["-Xlinker", "--allow-shlib-undefined"])]
#else
  let core = Target.binaryTarget(name: "GyradiusFFI", path: "GyradiusFFI.xcframework")
  let linked: [LinkerSetting] = []
  let observed: [LinkerSetting] = []
#endif

let package = Package(
  name: "GyradiusKit",
  defaultLocalization: "en",
  platforms: [.iOS(.v17), .macOS(.v14)],
  products: [
    .library(name: "GyradiusKit", targets: ["GyradiusKit"]),
    .library(name: "GyradiusApp", targets: ["GyradiusApp"]),
  ],
  targets: [
    core,
    .target(name: "GyradiusKit", dependencies: ["GyradiusFFI"], linkerSettings: linked),
    .target(name: "GyradiusApp", dependencies: ["GyradiusKit"], linkerSettings: observed),
    .target(name: "TestSupport", path: "Tests/Support"),
    .testTarget(name: "GyradiusKitTests", dependencies: ["GyradiusKit", "TestSupport"]),
    .testTarget(name: "GyradiusAppTests", dependencies: ["GyradiusApp", "TestSupport"]),
  ],
  swiftLanguageModes: [.v6]
)
