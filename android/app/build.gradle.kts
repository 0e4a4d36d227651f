plugins {
    alias(libs.plugins.android.application)
    alias(libs.plugins.kotlin.compose)
}

android {
    namespace = "org.gyradius.app"
    compileSdk = libs.versions.compileSdk.get().toInt()

    defaultConfig {
        applicationId = "org.gyradius.app"
        minSdk = libs.versions.minSdk.get().toInt()
        targetSdk = libs.versions.targetSdk.get().toInt()
        versionCode = libs.versions.appCode.get().toInt()
        versionName = libs.versions.appVersion.get()
    }
    sourceSets["main"].kotlin.srcDirs(
        "src/main/kotlin",
        // The Kotlin package is compiled in: one source, one version.
        "../../bindings/kotlin/src/main/kotlin",
    )
    // The practice hull, and its like.
    sourceSets["main"].assets.srcDirs("../../python/gyradius/rigs")
    buildFeatures { compose = true }
    testOptions { unitTests.isIncludeAndroidResources = true }
    compileOptions {
        sourceCompatibility = JavaVersion.VERSION_11
        targetCompatibility = JavaVersion.VERSION_11
    }
}

val repository: File = rootDir.parentFile
val facade = repository.resolve("target/debug/" + System.mapLibraryName("gyradius_ffi"))

// The facade for this machine: what is to be generated is read from its library. Cargo knows whether it is up to date.
val buildFacade by tasks.registering(Exec::class) {
    workingDir = repository
    commandLine("cargo", "build", "--package", "gyradius-ffi")
}

// Writes the facade's Kotlin classes (bindings/README.md).
abstract class GenerateBindings : Exec() {
    @get:OutputDirectory
    abstract val folder: DirectoryProperty
}

androidComponents.onVariants { variant ->
    // A task for each variant: the plugin sets its folder.
    val generate = tasks.register<GenerateBindings>("generate${variant.name.replaceFirstChar(Char::uppercase)}Bindings") {
        dependsOn(buildFacade)
        inputs.file(facade)
        inputs.file(repository.resolve("bindings/generate"))
        inputs.files(fileTree(repository.resolve("bindings/generator")) { exclude("target") })
        workingDir = repository
        executable = repository.resolve("bindings/generate").path
        val out = folder
        argumentProviders.add(CommandLineArgumentProvider { listOf("kotlin", out.get().asFile.path) })
    }
    variant.sources.kotlin?.addGeneratedSourceDirectory(generate, GenerateBindings::folder)
}

dependencies {
    implementation(platform(libs.compose.bom))
    implementation(libs.compose.ui)
    implementation(libs.compose.foundation)
    implementation(libs.compose.material3)
    implementation(libs.activity.compose)
    implementation(libs.lifecycle.viewmodel.compose)
    implementation(libs.lifecycle.runtime.compose)
    implementation(libs.core.ktx)
    implementation(libs.kotlin.stdlib)
    implementation(libs.coroutines.android)
    implementation(variantOf(libs.jna) { artifactType("aar") })
    testImplementation(libs.bundles.test)
    testImplementation(variantOf(libs.jna) { artifactType("jar") })
}
