package rasterlab.tests.build;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

/** Reads the build as the {@code pom.xml} files describe it. */
final class MavenBuild {
    private static final Pattern PLACEHOLDER = Pattern.compile("\\$\\{([^}]+)}");

    private final Path root;
    private final Element parent;
    private final Map<String, String> properties = new TreeMap<>();
    private final Map<String, String> managedVersions = new TreeMap<>();
    private final Set<String> excluded = new TreeSet<>();

    private MavenBuild(Path root) throws Exception {
        this.root = root;
        parent = parse(root.resolve("pom.xml"));
        properties.put("project.version", text(parent, "version"));
        for (var property : children(only(parent, "properties")))
            properties.put(property.getTagName(), property.getTextContent().strip());
        var managed = only(only(parent, "dependencyManagement"), "dependencies");
        for (var dependency : children(managed)) {
            managedVersions.put(key(dependency), resolve(text(dependency, "version")));
            children(dependency).stream()
                    .filter(element -> element.getTagName().equals("exclusions"))
                    .flatMap(exclusions -> children(exclusions).stream())
                    .forEach(exclusion -> excluded.add(key(exclusion)));
        }
    }

    static BuildDescription read(Path root) throws Exception {
        var build = new MavenBuild(root);
        var modules = new TreeMap<String, BuildDescription.Module>();
        for (var module : children(only(build.parent, "modules")))
            modules.put(module.getTextContent().strip(), build.module(module.getTextContent()));
        return new BuildDescription(
                modules,
                build.excluded,
                build.properties.get("project.version"),
                build.properties.get("maven.compiler.release"),
                build.properties.get("kotlin.version"),
                build.properties.get("kotlin.compiler.jvmTarget"),
                build.slow());
    }

    private String slow() {
        return children(only(parent, "profiles")).stream()
                .filter(profile -> text(profile, "id").equals("quick"))
                .map(profile -> text(only(profile, "properties"), "excludedGroups"))
                .findFirst()
                .orElse("");
    }

    private BuildDescription.Module module(String name) throws Exception {
        var pom = parse(root.resolve(name.strip()).resolve("pom.xml"));
        var dependencies = new TreeMap<String, BuildDescription.Dependency>();
        for (var holder : List.of(parent, pom))
            for (var dependency : children(only(holder, "dependencies")))
                dependencies.put(key(dependency), dependency(dependency));
        var tests = SurefireProcesses.read(List.of(parent, pom), text -> resolve(pom, text));
        return new BuildDescription.Module(dependencies, property(pom, "main.class"), tests);
    }

    /** The module's own value, else that of all modules. */
    private String property(Element pom, String name) {
        return children(pom).stream()
                .filter(e -> e.getTagName().equals("properties"))
                .flatMap(e -> children(e).stream())
                .filter(e -> e.getTagName().equals(name))
                .map(Element::getTextContent)
                .findFirst()
                .orElse(properties.get(name));
    }

    private BuildDescription.Dependency dependency(Element element) {
        var version = text(element, "version");
        var scope = text(element, "scope");
        return new BuildDescription.Dependency(
                version.isEmpty() ? managedVersions.get(key(element)) : resolve(version),
                scope.isEmpty() ? "compile" : scope);
    }

    private String resolve(String value) {
        return resolve(parent, value);
    }

    /** A name that is no property of these files stays as it stands. */
    private String resolve(Element pom, String value) {
        return PLACEHOLDER
                .matcher(value)
                .replaceAll(
                        match -> {
                            var found = property(pom, match.group(1));
                            return Matcher.quoteReplacement(
                                    found == null ? match.group() : resolve(pom, found));
                        });
    }

    private static String key(Element dependency) {
        var group = text(dependency, "groupId");
        var artifact = text(dependency, "artifactId");
        var classifier = text(dependency, "classifier");
        if (group.equals("rasterlab")) return artifact;
        return group + ":" + artifact + (classifier.isEmpty() ? "" : ":" + classifier);
    }

    private static Element parse(Path file) throws Exception {
        var factory = DocumentBuilderFactory.newInstance();
        factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
        return factory.newDocumentBuilder().parse(file.toFile()).getDocumentElement();
    }

    private static Element only(Element parent, String name) {
        return children(parent).stream()
                .filter(element -> element.getTagName().equals(name))
                .findFirst()
                .orElseThrow(() -> new AssertionError("no <" + name + "> in " + parent));
    }

    static String text(Element parent, String name) {
        return children(parent).stream()
                .filter(element -> element.getTagName().equals(name))
                .map(element -> element.getTextContent().strip())
                .findFirst()
                .orElse("");
    }

    static List<Element> children(Node parent) {
        var elements = new ArrayList<Element>();
        for (var node = parent.getFirstChild(); node != null; node = node.getNextSibling())
            if (node instanceof Element element) elements.add(element);
        return elements;
    }
}
