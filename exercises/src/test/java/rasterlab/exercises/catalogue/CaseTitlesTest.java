package rasterlab.exercises.catalogue;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.TaskKind;

/** A title stands beside a verdict: "the last pixel is dropped: right" says the opposite. */
class CaseTitlesTest {
    private static final Pattern MISTAKE =
            Pattern.compile(
                    "dropped|leaves|nothing|goes down|mixes|skipped|divides|stops|loses|round to 0"
                            + "|backwards|differ\\b|^overflow beyond|never ends|drifts"
                            + "|потерян|разрывы|не рисуется|идёт вниз|перепутаны$|деление на нуль"
                            + "|обрывается|округлены к нулю|в обратном|другие пиксели|уходит вбок"
                            + "|без конца");

    @Test
    @DisplayName("a title names a mistake")
    void titlesSayWhatIsAsked() {
        assertTrue(MISTAKE.matcher("single point is skipped").find());
        for (Exercise exercise : Catalogue.builtIn().all())
            for (Case one : exercise.form() == TaskKind.WRITE ? exercise.cases() : List.<Case>of())
                for (String language : List.of("en", "ru")) {
                    String title = one.title(language);
                    String asked = title.replace("не перепутаны", "").replace("не уходит вбок", "");
                    assertFalse(MISTAKE.matcher(asked).find(), title);
                }
    }

    @Test
    @DisplayName("a title is a thing, such as “random points”, and asks for nothing")
    void titlesHaveAVerb() {
        Pattern verb =
                Pattern.compile(
                        ".* (is|are|go|goes|has|have|lie|lies|come|keep|ends|stays) .*|no overflow.*");
        for (Case one : Catalogue.builtIn().named("line-bresenham").cases())
            assertTrue(verb.matcher(one.title("en") + " ").matches(), one.title("en"));
    }

    @Test
    @DisplayName("a case's group asks for something else than the exercise's groups")
    void everyCaseBelongsToAGroup() {
        Exercise exercise = Catalogue.builtIn().named("line-bresenham");
        for (Case one : exercise.cases()) assertTrue(exercise.group(one).isPresent(), one.name());
    }
}
