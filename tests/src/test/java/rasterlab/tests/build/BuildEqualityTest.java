package rasterlab.tests.build;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.tests.Repository;

class BuildEqualityTest {
    @Test
    void mavenAndGradleDescribeTheSameBuild() throws Exception {
        var maven = MavenBuild.read(Repository.root());
        assertEquals(Repository.MODULES.size(), maven.modules().size());
        assertEquals(List.of(), maven.differencesTo(GradleBuild.read(Repository.root())));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void noticesThat(String file, String from, String to, String difference, @TempDir Path copy)
            throws Exception {
        edit(copy, file, from, to);
        var found = MavenBuild.read(copy).differencesTo(GradleBuild.read(copy));
        assertTrue(
                found.stream().anyMatch(line -> line.startsWith(difference)),
                "expected a difference in '" + difference + "', found " + found);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(mistakesInModules(), mistakesInVersions(), mistakesInTests())
                .flatMap(mistakes -> mistakes);
    }

    private static Stream<Arguments> mistakesInModules() {
        var joml =
                "<dependency><groupId>org.joml</groupId><artifactId>joml</artifactId></dependency>";
        return Stream.of(
                argumentSet(
                        "a module is missing in Gradle",
                        "settings.gradle.kts",
                        "\"app\", ",
                        "",
                        "modules"),
                argumentSet(
                        "a module is missing in Maven",
                        "pom.xml",
                        "<module>app</module>",
                        "",
                        "modules"),
                argumentSet(
                        "a dependency is missing in Gradle",
                        "engine/build.gradle.kts",
                        "implementation(libs.joml)",
                        "",
                        "engine: dependency org.joml:joml"),
                argumentSet(
                        "a dependency is missing in Maven",
                        "engine/pom.xml",
                        joml,
                        "",
                        "engine: dependency org.joml:joml"),
                argumentSet(
                        "a library is left out by Maven alone",
                        "build.gradle.kts",
                        "module = \"jlatexmath-font-greek",
                        "module = \"jlatexmath-font-roman",
                        "excluded libraries"),
                argumentSet(
                        "a scope differs",
                        "engine/build.gradle.kts",
                        "implementation(libs.joml)",
                        "testImplementation(libs.joml)",
                        "engine: dependency org.joml:joml"));
    }

    private static Stream<Arguments> mistakesInVersions() {
        var catalogue = "gradle/libs.versions.toml";
        return Stream.of(
                argumentSet(
                        "a version differs",
                        catalogue,
                        "joml = \"1.10",
                        "joml = \"1.9",
                        "engine: dependency org.joml:joml"),
                argumentSet(
                        "the project's version differs",
                        "build.gradle.kts",
                        "version = \"0",
                        "version = \"1",
                        "version of the project"),
                argumentSet(
                        "a main class differs",
                        "app/build.gradle.kts",
                        "app.Main",
                        "app.Start",
                        "app: main class"),
                argumentSet(
                        "the Java level differs",
                        "pom.xml",
                        "<maven.compiler.release>17",
                        "<maven.compiler.release>21",
                        "Java level"),
                argumentSet(
                        "the Kotlin version differs",
                        catalogue,
                        "kotlin = \"2",
                        "kotlin = \"3",
                        "Kotlin version"),
                argumentSet(
                        "the Kotlin target differs",
                        "grader/build.gradle.kts",
                        "JVM_17",
                        "JVM_21",
                        "Kotlin target"));
    }

    private static Stream<Arguments> mistakesInTests() {
        return Stream.of(
                argumentSet(
                        "the processes of tests differ",
                        "exercises/build.gradle.kts",
                        "maxParallelForks = 2",
                        "maxParallelForks = 3",
                        "exercises: test processes"),
                argumentSet(
                        "a quick run leaves out other tests in Gradle",
                        "build.gradle.kts",
                        "excludeTags(\"slow\")",
                        "excludeTags(\"windows\")",
                        "tests left out by -Pquick"),
                argumentSet(
                        "no test is left out of Maven's quick run",
                        "pom.xml",
                        "<excludedGroups>slow</excludedGroups>",
                        "",
                        "tests left out by -Pquick"),
                argumentSet(
                        "tests may take longer in Gradle",
                        "build.gradle.kts",
                        "ofSeconds(3600)",
                        "ofSeconds(2500)",
                        "grader: seconds for tests"),
                argumentSet(
                        "an option of all tests is missing in Gradle",
                        "build.gradle.kts",
                        "jvmArgs(\"-XX:+UseSerialGC\")",
                        "",
                        "engine: option of tests -XX:+UseSerialGC: given against not given"),
                argumentSet(
                        "an option of all tests is missing in Maven",
                        "pom.xml",
                        " -XX:+UseSerialGC -XX:TieredStopAtLevel=1</argLine>",
                        " -XX:TieredStopAtLevel=1</argLine>",
                        "exercises: option of tests -XX:+UseSerialGC: not given"),
                argumentSet(
                        "an option of one module's tests is missing in Gradle",
                        "tests/build.gradle.kts",
                        "jvmArgs(\"--add-opens\", \"java.base/java.util=ALL-UNNAMED\")",
                        "",
                        "tests: option of tests --add-opens=java.base/java.util=ALL-UNNAMED: given"),
                argumentSet(
                        "an option of one module's tests is missing in Maven",
                        "tests/pom.xml",
                        " --add-opens java.base/java.util=ALL-UNNAMED",
                        "",
                        "tests: option of tests --add-opens=java.base/java.util=ALL-UNNAMED: not"),
                argumentSet(
                        "the heap of one module's tests differs",
                        "tests/build.gradle.kts",
                        "\"2g\"",
                        "\"3g\"",
                        "tests: option of tests -Xmx2g"),
                argumentSet(
                        "a system property of tests differs",
                        "pom.xml",
                        "timeout.default>10 m<",
                        "timeout.default>20 m<",
                        "app: option of tests -Djunit.jupiter.execution.timeout.default=10 m"),
                argumentSet(
                        "a variable of the environment is Gradle's alone",
                        "app/build.gradle.kts",
                        "maxParallelForks = 2",
                        "environment(\"LANG\", \"C\")",
                        "app: option of tests LANG=C"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("unreadable")
    void refusesToReadThat(String file, String from, String to, String message, @TempDir Path copy)
            throws Exception {
        edit(copy, file, from, to);
        var error =
                assertThrows(
                        AssertionError.class,
                        () -> MavenBuild.read(copy).differencesTo(GradleBuild.read(copy)));
        assertEquals(message, error.getMessage());
    }

    static Stream<Arguments> unreadable() {
        return Stream.of(
                argumentSet(
                        "an option comes from a variable",
                        "build.gradle.kts",
                        "jvmArgs(\"-XX:+UseSerialGC\")",
                        "jvmArgs(collector)",
                        "cannot read the line of tests 'jvmArgs(collector)'"),
                argumentSet(
                        "an option stands outside of the tests' blocks",
                        "grader/build.gradle.kts",
                        "kotlin {",
                        "tasks.named<Test>(\"test\") { jvmArgs(\"-ea\") }\n\nkotlin {",
                        "'<Test>' outside of the blocks of tests"),
                argumentSet(
                        "Surefire is told something new",
                        "pom.xml",
                        "<runOrder>",
                        "<reuseForks>false</reuseForks><runOrder>",
                        "cannot read <reuseForks> of Surefire"),
                argumentSet(
                        "Surefire runs twice",
                        "tests/pom.xml",
                        "<artifactId>maven-surefire-plugin</artifactId>",
                        "<artifactId>maven-surefire-plugin</artifactId><executions/>",
                        "cannot read <executions> of Surefire"));
    }

    private static void edit(Path copy, String file, String from, String to) throws IOException {
        copyBuildFiles(copy);
        var edited = copy.resolve(file);
        var text = Files.readString(edited);
        int at = text.indexOf(from);
        assertTrue(at >= 0, file + " no longer contains '" + from + "'");
        Files.writeString(edited, text.substring(0, at) + to + text.substring(at + from.length()));
    }

    private static void copyBuildFiles(Path copy) throws IOException {
        var files =
                Stream.of(
                        "pom.xml",
                        "settings.gradle.kts",
                        "build.gradle.kts",
                        "gradle/libs.versions.toml");
        var ofModules =
                Repository.MODULES.stream()
                        .flatMap(m -> Stream.of(m + "/pom.xml", m + "/build.gradle.kts"));
        for (var name : Stream.concat(files, ofModules).toList()) {
            var target = copy.resolve(name);
            Files.createDirectories(target.getParent());
            Files.copy(Repository.root().resolve(name), target);
        }
    }
}
