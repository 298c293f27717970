plugins {
    `java-library`
}

dependencies {
    implementation(project(":engine"))
    implementation(libs.jackson.databind)
    implementation(libs.asm)
    implementation(libs.commonmark)
    implementation(libs.jlatexmath)
    runtimeOnly(libs.jlatexmath.font.cyrillic)
    implementation(libs.xmlgraphics.commons)
}

tasks.test {
    maxParallelForks = 2
    // Each class runs code of its own for seconds, in which the second compiler would only cost time.
    jvmArgs("-XX:TieredStopAtLevel=1")
}
