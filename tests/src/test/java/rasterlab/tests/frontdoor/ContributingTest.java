package rasterlab.tests.frontdoor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.tests.Repository;
import rasterlab.tests.bench.pipeline.PipelineBench;

/** Checks what CONTRIBUTING.md says: its map, the files of its examples, its commands. */
class ContributingTest {
    private static final int MOST_LINES = 150;

    private static final Path FILE = Repository.root().resolve("CONTRIBUTING.md");
    private static final Path MAP = Repository.root().resolve("app/pictures/house.svg");
    private static final Pattern SECTION =
            Pattern.compile(
                    "(?ms)^## (Add an? [a-z]+)\\n\\nFor example ([^`]*)`([^`]+)`(.*?)(?=^## )");
    private static final Pattern CODE = Pattern.compile("`([^`\\n]+)`");
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)]+)\\)");
    private static final Pattern ONLY =
            Pattern.compile("\\./lab bench pipeline .*--only \"([^\"]+)\"");
    private static final Pattern TEST = Pattern.compile("-pl (\\w+) -am test -Dtest=(\\w+)");

    @Test
    void theMapIsWhatTheClassesUse() throws IOException {
        String drawn = HouseMap.svg();
        if ("write".equals(System.getProperty("rasterlab.golden"))) Files.writeString(MAP, drawn);
        assertEquals(
                drawn, Repository.text(MAP), "write the map anew with -Drasterlab.golden=write");
        assertTrue(
                Repository.text(FILE).contains("](app/pictures/house.svg)"),
                "the map is not shown");
    }

    @Test
    void isReadInOneSitting() {
        long lines = Repository.text(FILE).lines().count();
        assertTrue(lines <= MOST_LINES, "CONTRIBUTING.md has " + lines + " lines");
    }

    @Test
    void everyFileThatIsNamedIsThere() {
        var missing = new ArrayList<String>();
        for (String name : codes(Repository.text(FILE)))
            if (isPath(name) && !Files.exists(Repository.root().resolve(name))) missing.add(name);
        assertEquals(List.of(), missing);
    }

    @Test
    @DisplayName("a file of a list has nothing to do with the list's example")
    void everyListFollowsItsExample() {
        var sections = SECTION.matcher(Repository.text(FILE));
        var found = new ArrayList<String>();
        var strange = new ArrayList<String>();
        while (sections.find()) {
            found.add(sections.group(1));
            for (String path : codes(sections.group(4)))
                if (isPath(path) && path.contains(".") && !tellsOf(path, sections.group(3)))
                    strange.add(path + " has no " + sections.group(3));
        }
        assertEquals(
                List.of(
                        "Add a method",
                        "Add a topic",
                        "Add a lab",
                        "Add an exercise",
                        "Add a command"),
                found);
        assertEquals(List.of(), strange, "CONTRIBUTING.md: name files of the list's example");
    }

    /** Whether a file's name or text has the example's words, in any of their spellings. */
    private static boolean tellsOf(String path, String example) {
        String words = example.replace("-", "").toLowerCase(Locale.ROOT);
        String text = path + Repository.text(Repository.root().resolve(path));
        return text.replace("-", "").toLowerCase(Locale.ROOT).contains(words);
    }

    @Test
    void theTestsThatAreRunAreThere() throws IOException {
        var tests = TEST.matcher(Repository.text(FILE));
        int found = 0;
        for (; tests.find(); found++) {
            Path folder = Repository.root().resolve(tests.group(1)).resolve("src/test/java");
            String name = tests.group(2) + ".java";
            try (Stream<Path> files = Files.walk(folder)) {
                assertTrue(
                        files.anyMatch(file -> file.getFileName().toString().equals(name)),
                        "no " + name + " below " + folder);
            }
        }
        assertTrue(found >= 3, found + " commands run one test");
    }

    @Test
    void theBenchKnowsTheWorkThatIsMeasured() {
        var only = ONLY.matcher(Repository.text(FILE));
        assertTrue(only.find(), "no command measures one work");
        String wanted = only.group(1);
        List<String> works = PipelineBench.works();
        assertTrue(
                works.stream().anyMatch(work -> work.contains(wanted)),
                wanted + " is no work of " + works);
    }

    @Test
    void everyLinkLeadsSomewhere() {
        var broken = new ArrayList<String>();
        var links = LINK.matcher(Repository.text(FILE));
        while (links.find())
            if (!Files.exists(Repository.root().resolve(links.group(1))))
                broken.add(links.group(1));
        assertEquals(List.of(), broken, "CONTRIBUTING.md: no file is there; mend the link");
    }

    private static List<String> codes(String text) {
        var codes = new ArrayList<String>();
        var matcher = CODE.matcher(text);
        while (matcher.find()) codes.add(matcher.group(1));
        return codes;
    }

    private static boolean isPath(String code) {
        return !code.contains(" ")
                && Repository.MODULES.stream().anyMatch(module -> code.startsWith(module + "/"));
    }
}
