plugins {
    application
}

dependencies {
    implementation(project(":engine"))
    implementation(project(":exercises"))
    implementation(libs.jackson.databind)
    implementation(libs.jackson.datatype.jdk8)
    implementation(libs.rsyntaxtextarea)
    implementation(libs.flatlaf)
    implementation(libs.jsvg)
    implementation(libs.miglayout.swing)
    implementation(libs.picocli)
    implementation(libs.batik.dom)
    implementation(libs.batik.svggen)
    implementation(libs.commonmark)
    implementation(libs.commonmark.ext.gfm.tables)
    implementation(libs.xchart)
    implementation(libs.lwjgl)
    runtimeOnly(variantOf(libs.lwjgl) { classifier("natives-linux") })
    runtimeOnly(variantOf(libs.lwjgl) { classifier("natives-linux-arm64") })
    runtimeOnly(variantOf(libs.lwjgl) { classifier("natives-macos") })
    runtimeOnly(variantOf(libs.lwjgl) { classifier("natives-macos-arm64") })
    runtimeOnly(variantOf(libs.lwjgl) { classifier("natives-windows") })
    runtimeOnly(variantOf(libs.lwjgl) { classifier("natives-windows-arm64") })
    implementation(libs.lwjgl.egl)
    implementation(libs.lwjgl.jawt)
    implementation(libs.lwjgl.opengl)
    runtimeOnly(variantOf(libs.lwjgl.opengl) { classifier("natives-linux") })
    runtimeOnly(variantOf(libs.lwjgl.opengl) { classifier("natives-linux-arm64") })
    runtimeOnly(variantOf(libs.lwjgl.opengl) { classifier("natives-macos") })
    runtimeOnly(variantOf(libs.lwjgl.opengl) { classifier("natives-macos-arm64") })
    runtimeOnly(variantOf(libs.lwjgl.opengl) { classifier("natives-windows") })
    runtimeOnly(variantOf(libs.lwjgl.opengl) { classifier("natives-windows-arm64") })
    implementation(libs.lwjgl3.awt)
    testImplementation(libs.jqwik)
    testImplementation(libs.json.schema.validator)
}

application {
    mainClass.set("rasterlab.app.Main")
}

tasks.test {
    maxParallelForks = 2
    // Each class runs code of its own for seconds, in which the second compiler would only cost time.
    jvmArgs("-XX:TieredStopAtLevel=1")
}
