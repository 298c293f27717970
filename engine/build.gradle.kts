plugins {
    `java-library`
}

dependencies {
    implementation(libs.joml)
    testImplementation(libs.jqwik)
}

tasks.processResources {
    val project = mapOf("version" to version)
    inputs.property("project", project)
    filesMatching("**/version.txt") { expand("project" to project) }
}

// All that a student's method may see, as a jar of its own.
val contractJar by tasks.registering(Jar::class) {
    archiveClassifier.set("contract")
    from(sourceSets.main.get().output)
    include("rasterlab/contract/**")
}

tasks.assemble {
    dependsOn(contractJar)
}

tasks.test {
    maxParallelForks = 2
}
