plugins {
    application
}

dependencies {
    implementation(project(":engine"))
    implementation(project(":app"))
    implementation(project(":exercises"))
    implementation(libs.jackson.databind)
    implementation(libs.picocli)
    implementation(libs.joml)
    implementation(libs.jts.core)
    implementation(libs.lwjgl)
    implementation(libs.lwjgl.egl)
    implementation(libs.lwjgl.opengl)
    runtimeOnly(variantOf(libs.lwjgl) { classifier("natives-linux") })
    runtimeOnly(variantOf(libs.lwjgl.opengl) { classifier("natives-linux") })
    implementation(libs.jmh.core)
    runtimeOnly(libs.postgresql)
    runtimeOnly(libs.sqlite.jdbc)
    annotationProcessor(libs.jmh.generator.annprocess)
    testImplementation(project(":grader"))
    testImplementation(libs.archunit)
    testImplementation(libs.jackson.dataformat.toml)
    testImplementation(libs.assertj.swing.junit)
    testImplementation(libs.selenium.chrome.driver)
    testImplementation(libs.selenium.support)
    testImplementation(libs.axe.core.selenium)
}

application {
    mainClass.set("rasterlab.tests.bench.Bench")
}

tasks.test {
    maxParallelForks = 3
    maxHeapSize = "2g"
    // Each window runs code of its own for seconds, in which the second compiler would only cost time.
    jvmArgs("-XX:TieredStopAtLevel=1")
    // AssertJ Swing reads a field of java.util.TimerTask.
    jvmArgs("--add-opens", "java.base/java.util=ALL-UNNAMED")
}

// Circles of packages are sought among the tests of all modules.
tasks.named("test") {
    dependsOn(":engine:testClasses", ":exercises:testClasses", ":app:testClasses", ":grader:testClasses")
}
