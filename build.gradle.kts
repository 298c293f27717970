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
        "testImplementation"(rootProject.libs.junit.platform.launcher)
    }

    // Letters that are typed in Greek script; \alpha and the like need none of it, and its fonts are not free.
    configurations.all { exclude(group = "org.scilab.forge", module = "jlatexmath-font-greek") }
    // axe-core brings a loader of drivers and all of Selenium; the driver that is installed is used.
    configurations.all { exclude(group = "io.github.bonigarcia", module = "webdrivermanager") }
    configurations.all { exclude(group = "org.seleniumhq.selenium", module = "selenium-java") }

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
        // For a change in hand: without what starts programs, opens windows or computes for long.
        if (project.hasProperty("quick")) useJUnitPlatform { excludeTags("slow") }
        maxHeapSize = "1g"
        systemProperty("file.encoding", "UTF-8")
        // A test that hangs fails with the stacks of all threads; one that cannot be interrupted ends its module.
        systemProperty("junit.jupiter.execution.timeout.default", "10 m")
        systemProperty("junit.jupiter.execution.timeout.threaddump.enabled", "true")
        timeout = java.time.Duration.ofSeconds(3600)
        // One thread is enough to collect what tests leave.
        jvmArgs("-XX:+UseSerialGC")
    }
}
