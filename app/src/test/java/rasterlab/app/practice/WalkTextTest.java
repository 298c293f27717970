package rasterlab.app.practice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;

class WalkTextTest {
    private static final Texts RUSSIAN = Texts.of("practice", Language.RUSSIAN);

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();

    @ParameterizedTest(name = "the data of {0} have names that are no Russian words")
    @MethodSource("topics")
    void dataHaveRussianNames(String topic) throws Exception {
        var model =
                new PracticeModel(new PracticeExercises(), () -> 3, Runnable::run, failures::add);
        model.enter(topic);
        model.settle();
        String text = WalkText.of(model.state(), RUSSIAN);
        model.close();
        assertEquals(List.of(), failures);
        List<String> foreign =
                Pattern.compile("(?m)(?:^|[:;] )\\s*([a-z-]{3,}) =")
                        .matcher(text)
                        .results()
                        .map(found -> found.group(1))
                        .toList();
        assertEquals(List.of(), foreign, text);
    }

    static Stream<String> topics() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == TaskKind.PREDICT)
                .map(Exercise::topic);
    }

    @Test
    void dataOfALineHaveTheirNamesAndCommas() throws Exception {
        var model =
                new PracticeModel(new PracticeExercises(), () -> 3, Runnable::run, failures::add);
        model.enter("shade-face");
        model.settle();
        String text = WalkText.of(model.state(), RUSSIAN);
        model.close();
        assertTrue(text.contains("Источник (lamp) = (2; 2; 10)"), text);
        assertTrue(text.contains("Материал (material): Фоновое (ambient) = 0,1; Диффузное"), text);
    }
}
