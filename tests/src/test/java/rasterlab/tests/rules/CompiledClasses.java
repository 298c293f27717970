package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertFalse;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.Location;
import com.tngtech.archunit.core.importer.Locations;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.tests.Repository;

/**
 * The compiled classes of all modules, those of their tests with them, which are not on the class
 * path but lie where the build at work puts the tests of each module.
 */
record CompiledClasses(JavaClasses all, List<Path> testFolders) {
    static CompiledClasses read() {
        List<Path> folders = new ArrayList<>();
        for (String module : Repository.MODULES) folders.addAll(testFolders(module));
        var places = new HashSet<>(Locations.ofPackage("rasterlab"));
        folders.stream().map(Location::of).forEach(places::add);
        JavaClasses all =
                new ClassFileImporter()
                        // What JMH writes around a benchmark while it is compiled.
                        .withImportOption(place -> !place.contains("/jmh_generated/"))
                        .importLocations(places);
        return new CompiledClasses(all, folders);
    }

    /** Both builds have a folder for each module and kind; Gradle has one for each language too. */
    private static List<Path> testFolders(String module) {
        Path own = folder(CompiledClasses.class);
        Path root = Repository.root();
        String below = root.resolve("tests").relativize(own).toString();
        List<Path> found =
                Stream.of(below, below.replace("java", "kotlin"))
                        .distinct()
                        .map(root.resolve(module)::resolve)
                        .filter(Files::isDirectory)
                        .toList();
        assertFalse(
                found.isEmpty(),
                "%s has no %s: compile its tests too, ./mvnw -pl tests -am test-compile"
                        .formatted(module, below));
        return found;
    }

    private static Path folder(Class<?> type) {
        return Path.of(
                URI.create(type.getProtectionDomain().getCodeSource().getLocation().toString()));
    }

    /** Whether the class was written for tests. */
    boolean isTest(JavaClass type) {
        return type.getSource()
                .map(source -> source.getUri())
                .filter(place -> place.getScheme().equals("file"))
                .map(Path::of)
                .filter(file -> testFolders.stream().anyMatch(file::startsWith))
                .isPresent();
    }
}
