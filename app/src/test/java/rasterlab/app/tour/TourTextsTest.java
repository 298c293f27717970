package rasterlab.app.tour;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.List;
import java.util.Properties;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.exercises.score.GradingVerdict;

class TourTextsTest {
    @ParameterizedTest
    @ValueSource(strings = {"rasterlab.app.tour.messages", "rasterlab.app.cli.report"})
    void bothLanguagesHaveTheSameKeys(String bundle) {
        assertEquals(ownKeys(bundle, "en"), ownKeys(bundle, "ru"));
    }

    @ParameterizedTest(name = "{0} has a list of verdicts of its own")
    @ValueSource(
            strings = {
                "rasterlab.app.tour.messages",
                "rasterlab.app.cli.report",
                "rasterlab.app.exercise.messages"
            })
    void verdictsAreKeptOnce(String bundle) {
        List<String> verdicts =
                Stream.of(GradingVerdict.values()).map(GradingVerdict::code).toList();
        assertEquals(
                List.of(),
                ownKeys(bundle, "en").stream()
                        .filter(
                                key ->
                                        verdicts.contains(
                                                key.replaceFirst("^(verdict|graded)\\.", "")))
                        .toList());
    }

    /** Keys of the language's own file; a missing one is not filled in from the English file. */
    private static Set<String> ownKeys(String bundle, String language) {
        String file = "/" + bundle.replace('.', '/') + (language.equals("en") ? "" : "_ru");
        try (var in = TourTextsTest.class.getResourceAsStream(file + ".properties")) {
            var keys = new Properties();
            keys.load(in);
            return keys.stringPropertyNames();
        } catch (IOException e) {
            throw new AssertionError(file, e);
        }
    }
}
