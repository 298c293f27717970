package rasterlab.app.tour;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.List;
import java.util.Properties;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.exercises.score.GradingVerdict;

class TourTextsTest {
    @ParameterizedTest
    @ValueSource(strings = {"rasterlab.app.tour.messages", "rasterlab.app.cli.report"})
    void bothLanguagesHaveTheSameKeys(String bundle) {
        assertEquals(ownKeys(bundle, "en"), ownKeys(bundle, "ru"));
    }

    @ParameterizedTest(name = "a server''s verdict is called otherwise than in the lab: {0}")
    @EnumSource(Language.class)
    void verdictsAreCalledAsInTheLabOfExercises(Language language) {
        Texts tour = Texts.of("tour", language);
        Texts lab = Texts.of("exercise", language);
        for (GradingVerdict verdict : GradingVerdict.values())
            assertEquals(
                    verdict == GradingVerdict.INTERNAL
                            ? tour.text("grading.internal")
                            : lab.text("verdict." + verdict.code()),
                    GradingSection.called(verdict.code(), tour));
    }

    @ParameterizedTest(name = "the tour has a list of verdicts of its own: {0}")
    @ValueSource(strings = {"en", "ru"})
    void verdictsAreKeptOnce(String language) {
        assertEquals(
                List.of(),
                ownKeys("rasterlab.app.tour.messages", language).stream()
                        .filter(key -> key.matches("(verdict|graded)\\..*"))
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
