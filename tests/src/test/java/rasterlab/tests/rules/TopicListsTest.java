package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.Topics;
import rasterlab.tests.Repository;

/**
 * One list of topics is kept by hand. A file is a list where it names more than three topics that
 * not all belong to one lab: a lab may name its own.
 */
class TopicListsTest {
    private static final int MOST = 3;

    /** A test may name some as examples, but not so many that a new one has to be added. */
    private static final int MOST_IN_TESTS = Topics.names().size() * 2 / 3;

    private static final Pattern QUOTED = Pattern.compile("\"([a-z-]+)\"");

    /** Some topics are also usual words, such as {@code view}. */
    private static final int MOST_IN_BUNDLES = 10;

    /** A key of a bundle, such as {@code title.line}. */
    private static final Pattern KEY = Pattern.compile("(?m)^[^=#\\n]+(?==)");

    private static final Pattern WORD = Pattern.compile("[a-z-]+");

    @Test
    void theOnlyListInTheProgramIsThatOfTopics() {
        assertEquals(
                List.of("engine/src/main/java/rasterlab/engine/Topics.java"),
                lists(Repository.sources(".java", ".kt"), "/src/main/", MOST),
                "ask Topics, or a topic's lab, instead of naming more than %d topics"
                        .formatted(MOST));
    }

    @Test
    @DisplayName("a test has a line for each topic")
    void noTestListsTheTopics() {
        assertEquals(
                List.of(),
                lists(Repository.sources(".java", ".kt"), "/src/test/", MOST_IN_TESTS),
                "ask Topics instead of naming more than %d topics".formatted(MOST_IN_TESTS));
    }

    @Test
    @DisplayName("a bundle has a text for each topic, which belongs into the topic's own words")
    void noBundleListsTheTopics() {
        var lists = new ArrayList<String>();
        for (Path file : Repository.sources(".properties"))
            if (file.toString().contains("/src/main/") && isList(keysOf(file), MOST_IN_BUNDLES))
                lists.add(Repository.root().relativize(file).toString());
        assertEquals(List.of(), lists, "move texts of topics to exercises/words/TOPIC.properties");
    }

    private static List<String> lists(List<Path> sources, String folder, int most) {
        return sources.stream()
                .filter(file -> file.toString().contains(folder))
                .filter(file -> isList(quoted(Repository.text(file)), most))
                .map(file -> Repository.root().relativize(file).toString())
                .toList();
    }

    private static boolean isList(Set<String> named, int most) {
        named.retainAll(Topics.names());
        Set<String> labs =
                named.stream().map(topic -> Topics.named(topic).lab()).collect(Collectors.toSet());
        return named.size() > most && labs.size() > 1;
    }

    private static Set<String> quoted(String source) {
        return QUOTED.matcher(source)
                .results()
                .map(found -> found.group(1))
                .collect(Collectors.toCollection(HashSet::new));
    }

    private static Set<String> keysOf(Path file) {
        return KEY.matcher(Repository.text(file))
                .results()
                .flatMap(key -> WORD.matcher(key.group()).results())
                .map(word -> word.group())
                .collect(Collectors.toCollection(HashSet::new));
    }
}
