package rasterlab.tests.build;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.dataformat.toml.TomlMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import rasterlab.tests.Repository;

/**
 * Reads the build as the Gradle scripts and the version catalogue describe it.
 *
 * <p>The scripts are kept so plain that lines of the form {@code configuration(notation)} say
 * everything; a dependency line of any other form is an error here, and a line of tests in {@link
 * GradleProcesses}.
 */
final class GradleBuild {
    /** Which tests {@code -Pquick} leaves out. */
    static final String QUICK =
            "if \\(project\\.hasProperty\\(\"quick\"\\)\\)"
                    + " useJUnitPlatform \\{ excludeTags\\(\"(\\w+)\"\\) }";

    private static final Pattern INCLUDE = Pattern.compile("include\\(([^)]*)\\)");
    private static final Pattern QUOTED = Pattern.compile("\"([^\"]+)\"");
    private static final Pattern DEPENDENCIES =
            Pattern.compile("(?m)^( *)dependencies \\{\\R(.*?)^\\1}", Pattern.DOTALL);
    private static final Pattern DEPENDENCY =
            Pattern.compile(
                    "\"?(\\w+)\"?\\((?:project\\(\":([a-z]+)\"\\)|(?:rootProject\\.)?libs\\.([\\w.]+))\\)");
    private static final Pattern NATIVE =
            Pattern.compile(
                    "(\\w+)\\(variantOf\\(libs\\.([\\w.]+)\\) \\{ classifier\\(\"([\\w-]+)\"\\) }\\)");
    private static final Pattern EXCLUDED =
            Pattern.compile("exclude\\(group = \"([^\"]+)\", module = \"([^\"]+)\"\\)");

    private static final Map<String, String> SCOPES =
            Map.of(
                    "annotationProcessor", "provided",
                    "api", "compile",
                    "implementation", "compile",
                    "runtimeOnly", "runtime",
                    "testImplementation", "test",
                    "testRuntimeOnly", "test");

    private final Path root;
    private final JsonNode catalogue;
    private final String common;
    private final String project;

    private GradleBuild(Path root) throws Exception {
        this.root = root;
        catalogue = new TomlMapper().readTree(root.resolve("gradle/libs.versions.toml").toFile());
        common = Repository.text(root.resolve("build.gradle.kts"));
        project = find("version = \"([^\"]+)\"", common);
    }

    static BuildDescription read(Path root) throws Exception {
        var build = new GradleBuild(root);
        var settings = Repository.text(root.resolve("settings.gradle.kts"));
        var modules = new TreeMap<String, BuildDescription.Module>();
        INCLUDE.matcher(settings)
                .results()
                .flatMap(include -> QUOTED.matcher(include.group(1)).results())
                .map(match -> match.group(1))
                .forEach(name -> modules.put(name, build.module(name)));
        var scripts = new StringBuilder(build.common);
        for (var name : modules.keySet()) scripts.append(build.script(name));
        return new BuildDescription(
                modules,
                excluded(scripts),
                build.project,
                find("options\\.release\\.set\\((\\d+)\\)", scripts),
                build.catalogue.at("/versions/kotlin").asText(),
                find("JvmTarget\\.JVM_(\\d+)", scripts),
                find(QUICK, build.common));
    }

    private static Set<String> excluded(CharSequence scripts) {
        var found = new TreeSet<String>();
        EXCLUDED.matcher(scripts)
                .results()
                .forEach(match -> found.add(match.group(1) + ":" + match.group(2)));
        return found;
    }

    private String script(String module) {
        var file = root.resolve(module).resolve("build.gradle.kts");
        return Files.exists(file) ? Repository.text(file) : "";
    }

    private BuildDescription.Module module(String name) {
        var dependencies = new TreeMap<String, BuildDescription.Dependency>();
        addDependencies(common, dependencies);
        addDependencies(script(name), dependencies);
        return new BuildDescription.Module(
                dependencies,
                find("mainClass\\.set\\(\"([^\"]+)\"\\)", script(name)),
                GradleProcesses.read(List.of(common, script(name))));
    }

    private void addDependencies(
            String script, Map<String, BuildDescription.Dependency> dependencies) {
        var blocks = DEPENDENCIES.matcher(script);
        while (blocks.find())
            for (var line : blocks.group(2).strip().split("\\R")) addDependency(line, dependencies);
    }

    private void addDependency(String line, Map<String, BuildDescription.Dependency> dependencies) {
        if (line.isBlank() || line.strip().startsWith("//")) return;
        var variant = NATIVE.matcher(line.strip());
        if (variant.matches()) {
            var scope = SCOPES.get(variant.group(1));
            addLibrary(variant.group(2), ":" + variant.group(3), scope, dependencies);
            return;
        }
        var match = DEPENDENCY.matcher(line.strip());
        if (!match.matches() || !SCOPES.containsKey(match.group(1)))
            throw new AssertionError("cannot read the dependency line '" + line.strip() + "'");
        var scope = SCOPES.get(match.group(1));
        if (match.group(2) != null)
            dependencies.put(match.group(2), new BuildDescription.Dependency(project, scope));
        else addLibrary(match.group(3), "", scope, dependencies);
    }

    private void addLibrary(
            String name,
            String classifier,
            String scope,
            Map<String, BuildDescription.Dependency> dependencies) {
        var alias = name.replace('.', '-');
        var library = catalogue.path("libraries").path(alias);
        if (library.isMissingNode())
            throw new AssertionError("libs.versions.toml has no library '" + alias + "'");
        var version = library.at("/version/ref").asText();
        dependencies.put(
                library.path("module").asText() + classifier,
                new BuildDescription.Dependency(
                        catalogue.path("versions").path(version).asText(), scope));
    }

    private static String find(String pattern, CharSequence text) {
        var match = Pattern.compile(pattern).matcher(text);
        return match.find() ? match.group(1) : "";
    }
}
