plugins {
    application
}

dependencies {
    implementation(project(":engine"))
    implementation(project(":exercises"))
    implementation(libs.jackson.databind)
    implementation(libs.flatlaf)
    implementation(libs.miglayout.swing)
    implementation(libs.picocli)
    implementation(libs.batik.dom)
    implementation(libs.batik.svggen)
    implementation(libs.xchart)
    testImplementation(libs.jqwik)
}

application {
    mainClass.set("rasterlab.app.Main")
}
