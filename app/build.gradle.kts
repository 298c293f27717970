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
    implementation(libs.miglayout.swing)
    implementation(libs.picocli)
    implementation(libs.batik.dom)
    implementation(libs.batik.svggen)
    implementation(libs.commonmark)
    implementation(libs.commonmark.ext.gfm.tables)
    implementation(libs.xchart)
    testImplementation(libs.jqwik)
}

application {
    mainClass.set("rasterlab.app.Main")
}
