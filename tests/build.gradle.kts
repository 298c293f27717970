plugins {
    application
}

dependencies {
    implementation(project(":engine"))
    implementation(libs.picocli)
    implementation(libs.jts.core)
    implementation(libs.jmh.core)
    annotationProcessor(libs.jmh.generator.annprocess)
    testImplementation(project(":exercises"))
    testImplementation(project(":app"))
    testImplementation(project(":grader"))
    testImplementation(libs.archunit)
    testImplementation(libs.jackson.databind)
    testImplementation(libs.jackson.dataformat.toml)
    testImplementation(libs.assertj.swing.junit)
    testImplementation(libs.selenium.chrome.driver)
    testImplementation(libs.selenium.support)
}

application {
    mainClass.set("rasterlab.tests.bench.Bench")
}
