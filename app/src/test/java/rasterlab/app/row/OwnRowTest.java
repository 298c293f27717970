package rasterlab.app.row;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.language.Language;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** A program of the user's own that answers to rows. */
@Tag("slow")
class OwnRowTest {
    private static final String MAPPING =
            """
            import rasterlab.contract.*;
            public class Mine implements TextureMapper {
                public double[] coordinates(TexturedSpan span) {
                    %s
                }
            }
            """;

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ConcurrentLinkedQueue<Runnable> answers = new ConcurrentLinkedQueue<>();
    private final OwnMethods own = new OwnMethods();
    private final RowLabModel depths = RowLabModel.ofDepths(own, answers::add, failures::add);
    private final RowLabModel textures = RowLabModel.ofTextures(own, answers::add, failures::add);

    @AfterEach
    void close() {
        depths.end();
        textures.end();
        own.close();
        assertEquals(List.of(), failures);
    }

    private RowScene scene(String id, String source) throws InterruptedException {
        Exercise exercise = Catalogue.builtIn().named(id);
        RowLabModel model = depths.topics().contains(exercise.topic()) ? depths : textures;
        own.bring(exercise, source);
        model.openAgain(exercise.topic());
        model.chooseMethod(OwnMethods.NAME);
        model.shown();
        model.settle();
        for (Runnable next = answers.poll(); next != null; next = answers.poll()) next.run();
        return model.shown().orElseThrow();
    }

    private static String model(String id) {
        return Catalogue.builtIn().named(id).evidence().model().orElseThrow();
    }

    @ParameterizedTest
    @ValueSource(strings = {"texture-mapping", "depth-triangle"})
    void theModelSolutionIsRight(String id) throws InterruptedException {
        RowScene scene = scene(id, model(id));
        assertEquals(Verdict.Kind.EXACT, scene.verdict().kind(), scene.verdict().detail());
        assertEquals(2, scene.bands().size());
        assertEquals(0, scene.wrongPixels());
    }

    @ParameterizedTest
    @ValueSource(strings = {"bilinear", "mipmap"})
    void aFilterThatTakesFewTexelsIsBesideTheExactOne(String id) throws InterruptedException {
        RowScene scene = scene(id, model(id));
        assertEquals("", scene.verdict().kind() == Verdict.Kind.REFUSED ? "refused" : "");
        assertEquals(2, scene.bands().size());
        assertEquals(scene.pixels(), scene.errors().length);
    }

    @Test
    void aWrongPixelIsMarked() throws InterruptedException {
        RowScene scene =
                scene(
                        "texture-mapping",
                        MAPPING.formatted("return new double[2 * span.pixels()];"));
        assertEquals(Verdict.Kind.WRONG, scene.verdict().kind());
        assertTrue(scene.wrongPixels() > 0);
    }

    @Test
    void anAnswerOfAWrongLengthIsToldInBothLanguages() throws InterruptedException {
        RowScene scene = scene("texture-mapping", MAPPING.formatted("return new double[3];"));
        assertEquals(Verdict.Kind.WRONG, scene.verdict().kind());
        String said = scene.verdict().detail();
        assertEquals(
                Optional.of(
                        "Your program's answer has 3 values where %d were asked for"
                                .formatted(2 * scene.pixels())
                                .replace('\'', '’')),
                OwnWords.refusal(OwnMethods.NAME, said, Language.ENGLISH)
                        .map(words -> words.replace('\'', '’')));
        assertEquals(
                Optional.of(
                        "В ответе вашей программы значений: 3, а нужно: %d"
                                .formatted(2 * scene.pixels())),
                OwnWords.refusal(OwnMethods.NAME, said, Language.RUSSIAN));
    }

    @Test
    void anEndlessOneIsStopped() throws InterruptedException {
        RowScene scene =
                scene(
                        "texture-mapping",
                        MAPPING.formatted("while (span.pixels() > 0) ; return null;"));
        assertEquals(0, scene.errors().length);
        assertEquals(
                "your program did not answer within 2.0 s and was stopped",
                scene.verdict().detail());
    }

    @ParameterizedTest(name = "{0} shows no numbers of a pixel beside a program without an answer")
    @ValueSource(strings = {"texture-mapping", "depth-triangle", "mipmap"})
    void whatIsRightIsShownBesideAProgramWithoutAnAnswer(String id) throws InterruptedException {
        RowScene scene = scene(id, "public class Mine {");
        RowScene.PixelNumbers numbers = scene.numbers().apply(0);
        assertEquals("right", numbers.headings().get(numbers.headings().size() - 1));
        for (RowScene.NumberRow line : numbers.lines()) assertEquals(1, line.values().length);
    }

    @Test
    void anotherTextIsAskedAgain() throws InterruptedException {
        String wrong = MAPPING.formatted("return new double[2 * span.pixels()];");
        assertTrue(scene("texture-mapping", wrong).wrongPixels() > 0);
        assertEquals(0, scene("texture-mapping", model("texture-mapping")).wrongPixels());
    }
}
