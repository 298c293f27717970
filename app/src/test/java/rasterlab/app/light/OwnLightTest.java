package rasterlab.app.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.light.panel.LampOrbit;
import rasterlab.app.light.step.NormalSteps;
import rasterlab.app.light.step.OwnSteps;
import rasterlab.app.light.step.OwnTimeline;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.raster.Raster;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** The user's own program lights the scenes of the lab of light. */
@Tag("slow")
@Timeout(300)
class OwnLightTest {
    private static final String HALF =
            """
            import rasterlab.contract.*;
            public class Mine implements PointShader {
                public double[] intensity(LitPoint point) {
                    return new double[] {0.5, 0.5, 0.5};
                }
            }
            """;

    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final OwnMethods own = new OwnMethods();
    private final LightLabModel model = new LightLabModel(own, thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        own.close();
        assertEquals(List.of(), failures);
    }

    private void show(String id, String source) {
        Exercise exercise = Catalogue.builtIn().named(id);
        own.bring(exercise, source.isEmpty() ? exercise.evidence().model().orElseThrow() : source);
        model.showOwn(exercise.topic(), Optional.empty(), "");
        settle();
    }

    private void settle() {
        model.resize(120, 140);
        thread.settle(model::settle);
    }

    private LightFrame.DrawnFrame drawn() {
        return model.state().drawn().orElseThrow();
    }

    private OwnRemarks remarks() {
        return drawn().own().orElseThrow();
    }

    private String remarkText(Language language) {
        return remarks().in(Texts.of("light", language));
    }

    private int[] pixels(int picture) {
        return drawn().pictures().get(picture).raster().argb();
    }

    @ParameterizedTest
    @ValueSource(strings = {"shade", "shade-face", "gouraud"})
    void theModelSolutionGivesTheRightLightAtEachPoint(String id) {
        show(id, "");
        assertEquals("own.light.right", remarks().key(), remarkText(Language.ENGLISH));
        assertTrue(remarks().of() > 200, remarkText(Language.ENGLISH));
        assertTrue(Arrays.equals(pixels(0), pixels(1)));
        assertFalse(Arrays.equals(pixels(1), pixels(2)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"shade", "shade-face"})
    void itIsTheLightThatTheFormulaShowsAtThePoint(String id) {
        show(id, "");
        double[] mine = remarks().light().orElseThrow();
        double[] formula = drawn().point().orElseThrow().sum();
        for (int c = 0; c < 3; c++) assertEquals(formula[c], Math.min(1, mine[c]), 1e-6);
    }

    @Test
    void theLightOfASpotIsAskedForWithItsCone() {
        show("shade", "");
        model.choose(choice -> choice.withLamp(choice.lamp().withKind(Lamp.LampKind.SPOT)));
        settle();
        assertEquals("own.light.right", remarks().key(), remarkText(Language.ENGLISH));
    }

    @ParameterizedTest
    @ValueSource(strings = {"shade", "shade-face", "gouraud"})
    void itIsRightFromBehindUnderASunAndFromAFarEyeToo(String id) {
        show(id, "");
        model.choose(
                choice ->
                        choice.withLocalViewer(false)
                                .withLamps(
                                        List.of(
                                                Lamp.at(3, 1, 2).withKind(Lamp.LampKind.SUN),
                                                Lamp.at(90, 40, 60)))
                                .with(new LitBody("vase", 12, LitBody.OWN)));
        settle();
        assertEquals("own.light.right", remarks().key(), remarkText(Language.ENGLISH));
    }

    @Test
    void wrongLightIsCountedAndMarked() {
        show("shade", HALF);
        assertEquals("own.light.off", remarks().key());
        assertTrue(remarks().wrong() > 100 && remarks().worst() > 10, remarkText(Language.ENGLISH));
        assertFalse(Arrays.equals(pixels(0), pixels(1)));
    }

    @Test
    void lightIsGoneThroughPointByPointBesideTheRightOne() {
        show("shade", HALF);
        LightFrame.DrawnFrame all = drawn();
        OwnSteps steps = all.steps().orElseThrow();
        assertEquals(remarks().of(), steps.count());
        String first = steps.words(1, Texts.of("light", Language.ENGLISH));
        String said = " of " + steps.count() + ", face ";
        assertTrue(first.startsWith("Point 1" + said), first);
        assertTrue(first.contains("my program has (1, 1, 1), right is ("), first);
        LightFrame.DrawnFrame one = all.upTo(1);
        assertEquals(pixel(all, 0, steps.point(1)), pixel(one, 0, steps.point(1)));
        int open = pixel(all.upTo(0), 0, steps.point(1));
        assertNotEquals(open, pixel(one, 0, steps.point(1)));
        assertEquals(open, pixel(one, 0, steps.point(steps.count())));
        assertEquals(open, pixel(one, 2, steps.point(steps.count())));
        assertEquals(
                pixel(all, 1, steps.point(steps.count())),
                pixel(one, 1, steps.point(steps.count())));
    }

    private static int pixel(LightFrame.DrawnFrame drawn, int picture, double[] world) {
        double[] at = drawn.places().toPicture(world[0], world[1], world[2]);
        Raster raster = drawn.pictures().get(picture).raster();
        return raster.argb()[(int) Math.rint(at[1]) * raster.width() + (int) Math.rint(at[0])];
    }

    @Test
    void normalsAreGoneThroughVertexByVertexOnTheLabsTimeline() {
        show("vertex-normals", "");
        var timeline = new OwnTimeline(() -> drawn().steps(), model.walk, new LampOrbit(model));
        NormalSteps steps = (NormalSteps) drawn().steps().orElseThrow();
        assertEquals(steps.count(), timeline.last());
        assertEquals(steps.count(), timeline.step(), "all are shown at first");
        timeline.goTo(2);
        assertEquals(2, model.walk.step(steps.count()));
        String second = steps.words(2, Texts.of("light", Language.ENGLISH));
        assertTrue(second.startsWith("Normal 2 of " + steps.count() + ", vertex "), second);
        int few = drawn().upTo(steps.count() / 2).cornerArrows().length;
        assertTrue(0 < few && few < drawn().cornerArrows().length, few + " numbers of arrows");
        assertEquals(0, drawn().upTo(0).cornerArrows().length);
        timeline.goTo(timeline.last());
        model.choose(choice -> choice.with(choice.body().withNormals(LitBody.OWN)));
        settle();
        assertEquals(new LampOrbit(model).last(), timeline.last());
    }

    @Test
    void aDraggedLampIsAskedForAgain() {
        show("shade", HALF);
        int[] before = pixels(2);
        model.choose(choice -> choice.withLamp(Lamp.at(-200, 90, 10)));
        settle();
        assertFalse(Arrays.equals(before, pixels(2)));
    }

    @Test
    void anEndlessOneIsStoppedWithAMessageBesideTheRightPicture() {
        show("shade", HALF.replace("return new double[] {0.5, 0.5, 0.5};", "while (true);"));
        assertEquals(
                "Your program did not answer within 2 s and was stopped",
                remarkText(Language.ENGLISH));
        assertEquals(
                "Ваша программа не ответила за 2\u00a0с и была остановлена",
                remarkText(Language.RUSSIAN));
        assertFalse(Arrays.equals(pixels(0), pixels(1)));
    }

    @Test
    void aWrongNumberOfSharesIsTold() {
        show("shade", HALF.replace("{0.5, 0.5, 0.5}", "{0.5}"));
        assertEquals(
                "Your program's answer has 1 value where 3 were asked for",
                remarkText(Language.ENGLISH));
    }

    @Test
    void rightNormalsAreThoseThatTheExerciseAsksFor() {
        show("vertex-normals", "");
        assertEquals("own.normals.right", remarks().key(), remarkText(Language.ENGLISH));
        int[] mine = pixels(2);
        model.choose(choice -> choice.with(choice.body().withNormals("area")));
        settle();
        assertTrue(Arrays.equals(mine, pixels(2)));
    }

    @Test
    void wrongNormalsLightTheBodyAndTheFirstIsTold() {
        show(
                "vertex-normals",
                """
                import rasterlab.contract.*;
                public class Mine implements VertexNormals {
                    public double[] normals(double[] vertices, int[] triangles) {
                        double[] up = new double[vertices.length];
                        for (int i = 2; i < up.length; i += 3) up[i] = 7;
                        up[0] = Double.NaN;
                        return up;
                    }
                }
                """);
        assertEquals("own.normals.off", remarks().key());
        assertTrue(
                remarkText(Language.ENGLISH).contains("At vertex 0 it has ("),
                remarkText(Language.ENGLISH));
        assertTrue(
                remarkText(Language.RUSSIAN).contains("У вершины 0 получено ("),
                remarkText(Language.RUSSIAN));
        assertEquals(remarks().of(), remarks().wrong());
        assertEquals(drawn().cornerArrows().length, drawn().rightArrows().length);
        assertFalse(Arrays.equals(drawn().cornerArrows(), drawn().rightArrows()));
    }

    @Test
    void anotherProgramTakesTheOldOnesPlace() {
        show("shade", HALF);
        show("shade", "");
        assertEquals("own.light.right", remarks().key(), remarkText(Language.ENGLISH));
    }

    @Test
    void theLabsOwnShadingsComeBack() {
        show("shade", HALF);
        model.choose(choice -> choice.withShaded(""));
        settle();
        assertEquals(Optional.empty(), drawn().own());
        assertEquals("flat", drawn().pictures().get(0).name());
    }
}
