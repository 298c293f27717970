package rasterlab.app.tour;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
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

    @ParameterizedTest(name = "a graded verdict is called otherwise than in the lab: {0}")
    @EnumSource(GradingVerdict.class)
    void verdictsAreCalledAsInTheLabOfExercises(GradingVerdict verdict) {
        if (verdict == GradingVerdict.INTERNAL) return;
        Texts tour = Texts.of("tour", Language.RUSSIAN);
        Texts lab = Texts.of("exercise", Language.RUSSIAN);
        assertEquals(lab.text("verdict." + verdict.code()), tour.text("graded." + verdict.code()));
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
