package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.tests.Repository;

class DocOpeningTest {
    @Test
    @DisplayName("a doc comment's first sentence says neither what the thing is nor what it does")
    void everyDocCommentBeginsWithWhatTheThingIsOrDoes() {
        List<DocOpening> all =
                Repository.sources(".java", ".kt").stream()
                        .flatMap(file -> DocOpening.in(file).stream())
                        .toList();
        assertTrue(all.size() > 5_000, "only " + all.size() + " doc comments were found");
        List<DocOpening> fragments = all.stream().filter(DocOpening::isFragment).toList();
        assertTrue(
                fragments.isEmpty(),
                () ->
                        fragments.size()
                                + " of "
                                + all.size()
                                + " doc comments begin with a fragment; begin with a noun that"
                                + " names the thing or with a verb that says what it does:\n"
                                + fragments.stream()
                                        .map(DocOpening::toString)
                                        .collect(Collectors.joining("\n")));
    }

    @ParameterizedTest(name = "{1}: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "Of the plane 2, of space 3. | true",
                "Its first column. | true",
                "They touch. | true",
                "Empty where there is none. | true",
                "Told of each case. | true",
                "Sorted. | true",
                "Pixels. | true",
                "Back to how the lab opens. | true",
                "In pixels. | true",
                "What was done last. | true",
                "The same with another look. | true",
                "Does the same in float. | true",
                "Likewise for rows. | true",
                "Any finite number. | true",
                "Another state of a tab. | true",
                "The sameness of two looks. | false",
                "Does the sum of an array. | false",
                "The step done last. | false",
                "Dimension: 2 or 3. | false",
                "The slope of the edge, in pixels a row. | false",
                "Red, green and blue of each point. | false",
                "Speed of each method, in pixels a second. | false",
                "Reads what was kept. | false",
                "Whether the point lies inside. | false",
                "Back faces are lit by their own material. | false",
                "In-place sums of an array. | false",
                "Called after a run of pixels was filled. | false",
                "Wrong: takes the half vector. | false",
            })
    @DisplayName("the rule does not know a fragment")
    void knowsFragments(String sentence, boolean fragment) {
        assertEquals(fragment, new DocOpening("A.java:1", sentence).isFragment());
    }

    @Test
    @DisplayName("the rule reads another sentence than the first, or names another line")
    void readsTheFirstSentenceOfEachComment() {
        String text =
                """
                /** One {@code a.b} thing. And more. */
                int a;

                /**
                 * Two lines
                 * long, in pixels. And more.
                 *
                 * <p>More.
                 */
                int b;

                /** @return nothing */
                int c;
                """;
        assertEquals(
                "A.java:1: One {@code a.b} thing.\nA.java:4: Two lines long, in pixels.",
                DocOpening.in("A.java", text).stream()
                        .map(DocOpening::toString)
                        .collect(Collectors.joining("\n")));
    }
}
