plugins {
    `java-library`
}

dependencies {
    implementation(libs.joml)
    testImplementation(libs.jqwik)
}

// What needs the Vector API stands apart: the engine compiles and runs without it.
val vector: SourceSet by sourceSets.creating {
    compileClasspath += sourceSets["main"].output + sourceSets["main"].compileClasspath
}

// The module cannot be seen through a release, and that it is an incubating one is a warning nothing can silence.
tasks.named<JavaCompile>(vector.compileJavaTaskName) {
    options.release.set(null as Int?)
    sourceCompatibility = "17"
    targetCompatibility = "17"
    options.compilerArgs = mutableListOf("--add-modules", "jdk.incubator.vector")
}

tasks.jar {
    from(vector.output)
}

tasks.test {
    classpath += vector.output
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
    // Without these the engine computes one number at a time, as in the window, with them eight.
    jvmArgs("@${rootDir}/engine/vector-options")
}
