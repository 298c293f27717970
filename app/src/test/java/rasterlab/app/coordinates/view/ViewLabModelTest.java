package rasterlab.app.coordinates.view;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.coordinates.figure.Mark;
import rasterlab.app.coordinates.figure.MarkInk;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.chain.TransformTopic;

class ViewLabModelTest {
    private static final int WORLD = 1;
    private static final int EYE = 2;
    private static final int PICTURE = 3;
    private static final int SCREEN = 4;

    private final ViewLabModel model = new ViewLabModel();

    private double[] points(int stage) {
        return model.scene().image(stage).orElseThrow().numbers();
    }

    private static double[] flat(double[][] rows) {
        return Arrays.stream(rows).flatMapToDouble(Arrays::stream).toArray();
    }

    static Stream<Arguments> tables() {
        return Stream.of(
                Arguments.of("world", WORLD, HouseStages.world()),
                Arguments.of("eye", EYE, HouseStages.eye()),
                Arguments.of("picture", PICTURE, HouseStages.screen()));
    }

    @ParameterizedTest(name = "the course''s table of the house is another one: {0}")
    @MethodSource("tables")
    void showsTheCoursesThreeTables(String name, int stage, double[][] table) {
        assertArrayEquals(flat(table), points(stage), 1e-9);
    }

    @ParameterizedTest(name = "proportions are lost on the way to the window: {0}")
    @EnumSource(
            value = ViewKind.class,
            names = {"HOUSE", "SPHERICAL_LEFT", "ISOMETRIC", "THREE_POINT"})
    void fitsThePictureProportionally(ViewKind kind) {
        model.choose(kind);
        model.set(ViewNumber.WIDTH, 321);
        model.set(ViewNumber.HEIGHT, 600);
        PictureFit fit = ViewStages.fit(model.choice());
        double[] plane = points(PICTURE);
        double[] pixels = points(SCREEN);
        for (int i = 0; i < plane.length; i += 3) {
            assertEquals(fit.toPixelX(plane[i]), pixels[i], 1e-9);
            assertEquals(fit.toPixelY(plane[i + 1]), pixels[i + 1], 1e-9);
        }
    }

    @Test
    @DisplayName("the picture shrinks when the eye goes away though d = ρ")
    void keepsTheSizeOfWhatLiesInThePicturePlane() {
        model.choose(ViewKind.SPHERICAL_LEFT);
        double near = width();
        model.set(ViewNumber.RHO, 3000);
        double far = width();
        assertTrue(Math.abs(far / near - 1) < 0.2, near + " and " + far);
        model.change(model.choice().withStable(false));
        assertTrue(width() < far / 4, width() + " at d = 400");
    }

    private double width() {
        double[] points = points(PICTURE);
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < points.length; i += 3) {
            least = Math.min(least, points[i]);
            most = Math.max(most, points[i]);
        }
        return most - least;
    }

    @Test
    @DisplayName("a left-handed frame is taken for a right-handed one")
    void tellsTheFramesApart() {
        model.choose(ViewKind.SPHERICAL_LEFT);
        assertTrue(model.scene().rightHanded(WORLD));
        assertFalse(model.scene().rightHanded(EYE));
        model.choose(ViewKind.SPHERICAL_RIGHT);
        assertTrue(model.scene().rightHanded(EYE));
        model.choose(ViewKind.CENTRAL);
        assertFalse(model.scene().rightHanded(EYE));
    }

    @Test
    @DisplayName("edges through the eye's plane are drawn like others")
    void marksWhatTheDivisionMirrors() {
        model.show(ViewSituation.AT_THE_EYE);
        assertTrue(model.scene().image(PICTURE).orElseThrow().h().contains(0.0));
        model.show(ViewSituation.BEHIND_THE_EYE);
        assertTrue(model.scene().image(PICTURE).orElseThrow().behind() > 0);
        assertTrue(wrongLines() > 0, "no edge is marked");
        model.show(ViewSituation.WORKED);
        assertEquals(0, wrongLines());
        assertEquals(0, model.scene().image(PICTURE).orElseThrow().behind());
    }

    private long wrongLines() {
        return ViewFigure.of(model.scene(), model.step()).marks().stream()
                .filter(mark -> mark.ink().equals(MarkInk.WRONG))
                .count();
    }

    @ParameterizedTest(name = "a vanishing point is missing: {0}")
    @MethodSource("perspectives")
    void drawsOneVanishingPointForEachAxis(ViewKind kind, int points) {
        model.choose(kind);
        model.change(model.choice().withVanishing(true));
        long crosses =
                ViewFigure.of(model.scene(), PICTURE).marks().stream()
                        .filter(mark -> mark instanceof Mark.CrossMark)
                        .count();
        assertEquals(points, crosses);
    }

    static Stream<Arguments> perspectives() {
        return Stream.of(
                Arguments.of(ViewKind.ONE_POINT, 1),
                Arguments.of(ViewKind.TWO_POINT, 2),
                Arguments.of(ViewKind.THREE_POINT, 3),
                Arguments.of(ViewKind.HOUSE, 3),
                Arguments.of(ViewKind.ISOMETRIC, 0));
    }

    @Test
    @DisplayName("both eyes see the same")
    void showsTwoPicturesOnlyWhereTheyMeetInThePlane() {
        model.choose(ViewKind.SPHERICAL_LEFT);
        model.change(model.choice().with(Stereoscopy.ANAGLYPH));
        ViewScene scene = model.scene();
        assertEquals(4, scene.eyes().size());
        double middle = scene.image(PICTURE).orElseThrow().coordinate(0, 0);
        double left = scene.eyes().get(0).coordinate(0, 0);
        double right = scene.eyes().get(2).coordinate(0, 0);
        assertTrue(Math.abs(left - right) > 1, left + " and " + right);
        assertEquals(middle, (left + right) / 2, 1e-9);
        model.change(model.choice().withStable(false));
        assertTrue(model.scene().eyes().isEmpty());
    }

    @Test
    @DisplayName("γ does not run away")
    void tellsTheAmountOfPerspective() {
        model.choose(ViewKind.SPHERICAL_LEFT);
        var usual = model.scene().depth().orElseThrow();
        assertTrue(usual.nearest() > 3 * usual.half());
        model.show(ViewSituation.RUNAWAY);
        var near = model.scene().depth().orElseThrow();
        assertTrue(near.nearest() < 2 * near.half(), near.toString());
        assertTrue(near.gamma() > 2, near.gamma() + "");
    }

    @Test
    @DisplayName("the two ways to the eye are counted otherwise than on the command line")
    void tellsWhatAViewCosts() {
        model.choose(ViewKind.SPHERICAL_LEFT);
        var readings = new ViewReadings(model, Texts.of("coordinates.view", Language.ENGLISH));
        assertEquals("matrix 12×, 6+; apart 8×, 5+", readings.operations());
    }

    @ParameterizedTest(name = "opens with a picture that is not finite: {0}")
    @EnumSource(ViewKind.class)
    void everyKindOpensWithAllPointsBeforeTheEye(ViewKind kind) {
        model.choose(kind);
        assertEquals("", model.scene().refusal());
        for (int stage = 0; stage <= SCREEN; stage++)
            assertTrue(Arrays.stream(points(stage)).allMatch(Double::isFinite), kind + " " + stage);
        assertEquals(0, model.scene().image(PICTURE).orElseThrow().behind());
    }

    @Test
    @DisplayName("a drag is undone move by move")
    void undoTakesBackAWholeDrag() {
        ViewChoice before = model.choice();
        model.beginDrag();
        model.turn(0.1, 0);
        model.turn(0.1, 0.1);
        model.endDrag();
        assertEquals(-4, model.choice().number(ViewNumber.ANGLE_Y), 1e-9);
        model.history().undo();
        assertEquals(before, model.choice());
        assertFalse(model.history().undoable());
    }

    @Test
    @DisplayName("in a space with depth a drag turns the object")
    void dragTurnsTheViewpointWhereThereIsDepth() {
        model.goTo(EYE);
        double angle = model.choice().number(ViewNumber.ANGLE_Y);
        model.turn(0.1, 0);
        assertEquals(angle, model.choice().number(ViewNumber.ANGLE_Y));
        assertEquals(-14, model.choice().viewpoint().alphaDegrees(), 1e-9);
    }

    @Test
    @DisplayName("NaN gets into a matrix")
    void refusesNumbersThatAreNotFinite() {
        assertThrows(IllegalArgumentException.class, () -> model.set(ViewNumber.R, Double.NaN));
        assertEquals(-1.0 / 700, model.choice().number(ViewNumber.R));
    }

    @Test
    @DisplayName("the player leaves the stages")
    void stagesHaveTwoEnds() {
        model.goTo(99);
        assertEquals(SCREEN, model.step());
        model.goTo(-1);
        assertEquals(0, model.step());
    }

    @ParameterizedTest(name = "the verdict beside the situation {0} is another than its picture's")
    @EnumSource(ViewSituation.class)
    void verdictsAreThoseOfThePictures(ViewSituation situation) {
        var topic = new TransformTopic();
        var verdicts = model.verdicts(situation);
        assertEquals(
                topic.methods().stream().map(Method::name).toList(),
                List.copyOf(verdicts.keySet()));
        model.show(situation);
        for (var each : verdicts.entrySet()) {
            model.chooseMethod(each.getKey());
            boolean exact = model.scene().deviation().filter(topic::correct).isPresent();
            assertEquals(exact, each.getValue() == Verdict.Kind.EXACT, each.toString());
        }
        assertTrue(
                verdicts.values().stream().anyMatch(kind -> kind != Verdict.Kind.EXACT),
                verdicts.toString());
    }
}
