package rasterlab.tests.build;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import org.w3c.dom.Element;

/**
 * Reads how Surefire starts the processes of a module's tests, by profiles too. What it is told in
 * any other way is an error here.
 */
final class SurefireProcesses {
    private static final Set<String> READ =
            Set.of("groupId", "artifactId", "version", "configuration");

    /** The form of the reports, and the order of classes, which Gradle lets nobody choose. */
    private static final Set<String> UNSEEN = Set.of("statelessTestsetReporter", "runOrder");

    /** Gradle has no small numbers for processes: they share a display, and windows take turns. */
    private static final String DISPLAY = "DISPLAY=";

    private final UnaryOperator<String> resolve;
    private final Map<String, String> words = new TreeMap<>();
    private final Map<String, String> variables = new TreeMap<>();

    private SurefireProcesses(UnaryOperator<String> resolve) {
        this.resolve = resolve;
    }

    /**
     * @param poms the parent's before the module's, which counts where both say something
     * @param resolve puts the module's properties into a text
     */
    static Processes read(List<Element> poms, UnaryOperator<String> resolve) {
        var read = new SurefireProcesses(resolve);
        poms.forEach(read::addPlugins);
        return read.processes();
    }

    private void addPlugins(Element pom) {
        var plugins = pom.getElementsByTagName("plugin");
        for (int i = 0; i < plugins.getLength(); i++) {
            var plugin = (Element) plugins.item(i);
            if (!MavenBuild.text(plugin, "artifactId").equals("maven-surefire-plugin")) continue;
            for (var part : MavenBuild.children(plugin)) {
                if (!READ.contains(part.getTagName())) throw unreadable(part);
                if (part.getTagName().equals("configuration"))
                    MavenBuild.children(part).forEach(this::add);
            }
        }
    }

    private void add(Element setting) {
        switch (setting.getTagName()) {
            case "argLine", "forkCount", "forkedProcessTimeoutInSeconds" ->
                    words.put(setting.getTagName(), resolved(setting));
            case "systemPropertyVariables" -> addVariables("-D", setting);
            case "environmentVariables" -> addVariables("", setting);
            default -> {
                if (!UNSEEN.contains(setting.getTagName())) throw unreadable(setting);
            }
        }
    }

    private void addVariables(String prefix, Element holder) {
        for (var variable : MavenBuild.children(holder))
            variables.put(prefix + variable.getTagName() + "=", resolved(variable));
    }

    private String resolved(Element element) {
        return resolve.apply(element.getTextContent().strip());
    }

    private static AssertionError unreadable(Element element) {
        return new AssertionError("cannot read <" + element.getTagName() + "> of Surefire");
    }

    private Processes processes() {
        var options = new TreeSet<>(javaOptions());
        variables.forEach(
                (name, value) -> {
                    if (!name.equals(DISPLAY)) options.add(name + value);
                });
        return new Processes(
                words.getOrDefault("forkCount", "1"),
                words.getOrDefault("forkedProcessTimeoutInSeconds", ""),
                options);
    }

    private List<String> javaOptions() {
        var given =
                words.getOrDefault("argLine", "")
                        .replace("\"", "")
                        .replace("${maven.multiModuleProjectDirectory}", Processes.ROOT);
        return given.isBlank() ? List.of() : Processes.options(List.of(given.split("\\s+")));
    }
}
