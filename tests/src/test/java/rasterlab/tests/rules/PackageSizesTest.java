package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.tests.Repository;

/** A package is small enough to be looked over; the larger ones of today may only shrink. */
class PackageSizesTest {
    private static final int MOST_FILES = 40;

    /** Packages with more files, and how many: no line is added, and no number is raised. */
    private static final Map<String, Integer> LARGER =
            Map.of(
                    // What students import stays together: one line imports all of it.
                    "engine/src/main/java/rasterlab/contract", 56);

    @Test
    @DisplayName("a package has more files than allowed")
    void packagesAreSmall() {
        var sizes = new TreeMap<String, Integer>();
        for (Path file : Repository.sources(".java", ".kt")) {
            String folder = Repository.root().relativize(file.getParent()).toString();
            if (!folder.contains("/resources/"))
                sizes.merge(folder.replace('\\', '/'), 1, Integer::sum);
        }
        assertTrue(sizes.size() > 100, "only " + sizes.size() + " packages were found to count");
        assertEquals(List.of(), wrong(sizes, LARGER));
    }

    static Stream<Arguments> sizes() {
        return Stream.of(
                argumentSet(
                        "a new large package is not seen",
                        Map.of("a", 41),
                        Map.of(),
                        List.of("a has 41 files, at most 40 are allowed: split it")),
                argumentSet("the largest size is refused", Map.of("a", 40), Map.of(), List.of()),
                argumentSet(
                        "a package as large as listed is refused",
                        Map.of("a", 50),
                        Map.of("a", 50),
                        List.of()),
                argumentSet(
                        "a listed package grows unseen",
                        Map.of("a", 51),
                        Map.of("a", 50),
                        List.of("a has 51 files, at most 50 are allowed: split it")),
                argumentSet(
                        "a package that shrank may grow back",
                        Map.of("a", 49),
                        Map.of("a", 50),
                        List.of("a has 49 files, no longer 50: lower its number in LARGER")),
                argumentSet(
                        "a small package stays on the list",
                        Map.of("a", 40),
                        Map.of("a", 50),
                        List.of("a has 40 files, no longer 50: take it off LARGER")),
                argumentSet(
                        "a package that is gone stays on the list",
                        Map.of(),
                        Map.of("a", 50),
                        List.of("a has 0 files, no longer 50: take it off LARGER")));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("sizes")
    void tellsWhatToDo(
            Map<String, Integer> sizes, Map<String, Integer> larger, List<String> expected) {
        assertEquals(expected, wrong(sizes, larger));
    }

    private static List<String> wrong(Map<String, Integer> sizes, Map<String, Integer> larger) {
        var wrong = new ArrayList<String>();
        sizes.forEach(
                (folder, size) -> {
                    int most = larger.getOrDefault(folder, MOST_FILES);
                    if (size > most)
                        wrong.add(
                                "%s has %d files, at most %d are allowed: split it"
                                        .formatted(folder, size, most));
                });
        new TreeMap<>(larger)
                .forEach(
                        (folder, listed) -> {
                            int size = sizes.getOrDefault(folder, 0);
                            if (size < listed)
                                wrong.add(
                                        "%s has %d files, no longer %d: %s LARGER"
                                                .formatted(
                                                        folder,
                                                        size,
                                                        listed,
                                                        size > MOST_FILES
                                                                ? "lower its number in"
                                                                : "take it off"));
                        });
        return wrong;
    }
}
