plugins {
    java
}

dependencies {
    testImplementation(project(":engine"))
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
