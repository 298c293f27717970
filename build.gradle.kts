plugins {
    alias(libs.plugins.kotlin.jvm) apply false
    alias(libs.plugins.kotlin.serialization) apply false
}

allprojects {
    group = "rasterlab"
    version = "0.1.0"
}

subprojects {
    apply(plugin = "java")

    dependencies {
        "testImplementation"(rootProject.libs.junit.jupiter)
        "testRuntimeOnly"(rootProject.libs.junit.platform.launcher)
    }

    // The floor is language level 17; any newer JDK builds it too, so no toolchain is asked for.
    tasks.withType<JavaCompile>().configureEach {
        options.release.set(17)
        options.encoding = "UTF-8"
        options.compilerArgs.addAll(
            listOf(
                "-Xlint:cast,deprecation,divzero,empty,fallthrough,finally,overrides,rawtypes,removal,static,try," +
                    "unchecked,varargs",
                "-parameters",
                "-Werror",
            ),
        )
    }

    tasks.withType<Test>().configureEach {
        useJUnitPlatform()
        maxHeapSize = "1g"
        systemProperty("file.encoding", "UTF-8")
        // Without this module the engine computes one number at a time, with it eight.
        jvmArgs("--add-modules", "jdk.incubator.vector")
    }
}
