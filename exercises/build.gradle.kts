plugins {
    `java-library`
}

dependencies {
    implementation(project(":engine"))
    implementation(libs.jackson.databind)
    implementation(libs.asm)
}
