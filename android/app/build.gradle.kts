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
        "../../bindings/kotlin/src/main/kotlin-generated",
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
