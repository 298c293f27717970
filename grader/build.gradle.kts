plugins {
    application
    alias(libs.plugins.kotlin.jvm)
    alias(libs.plugins.kotlin.serialization)
}

dependencies {
    implementation(project(":engine"))
    implementation(project(":exercises"))
    implementation(libs.logback.classic)
    implementation(libs.db.scheduler)
    implementation(libs.hikari)
    implementation(libs.jackson.databind)
    implementation(libs.jackson.dataformat.csv)
    implementation(libs.jackson.dataformat.yaml)
    implementation(libs.java.diff.utils)
    implementation(libs.micrometer.registry.prometheus)
    implementation(libs.oauth2.oidc.sdk)
    implementation(libs.picocli)
    implementation(libs.ktor.server.auth)
    implementation(libs.ktor.server.cio)
    implementation(libs.ktor.server.core)
    implementation(libs.ktor.server.html.builder)
    implementation(libs.ktor.server.rate.limit)
    implementation(libs.ktor.server.sse)
    implementation(libs.ktor.server.status.pages)
    runtimeOnly(libs.codemirror)
    implementation(libs.commonmark)
    implementation(libs.commonmark.ext.gfm.tables)
    implementation(libs.flyway.core)
    implementation(libs.flyway.database.postgresql)
    implementation(libs.jdbi3.core)
    implementation(libs.kotlin.stdlib)
    implementation(libs.kotlinx.html)
    implementation(libs.kotlinx.serialization.json)
    implementation(libs.postgresql)
    implementation(libs.sqlite.jdbc)
    implementation(libs.tls.channel)
    testImplementation(libs.json.schema.validator)
    testImplementation(libs.ktor.server.test.host)
}

application {
    mainClass.set("rasterlab.grader.MainKt")
}

kotlin {
    compilerOptions {
        jvmTarget.set(org.jetbrains.kotlin.gradle.dsl.JvmTarget.JVM_17)
        allWarningsAsErrors.set(true)
    }
}

tasks.test {
    // Each class runs code of its own for seconds, in which the second compiler would only cost time.
    jvmArgs("-XX:TieredStopAtLevel=1")
}
