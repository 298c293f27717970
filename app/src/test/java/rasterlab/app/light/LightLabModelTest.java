package rasterlab.app.light;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.Rectangle;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.light.panel.LampOrbit;
import rasterlab.app.light.panel.LightGrip;
import rasterlab.app.light.panel.LightGrips;
import rasterlab.app.light.panel.StagePlan;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.light.Substance;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.raster.Raster;

@Timeout(300)
class LightLabModelTest {
    private static final int WIDTH = 150;
    private static final int HEIGHT = 180;

    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final LightLabModel model = new LightLabModel(thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private LightFrame.DrawnFrame drawn() {
        model.resize(WIDTH, HEIGHT);
        thread.settle(model::settle);
        return model.state().drawn().orElseThrow();
    }

    private static int[] pixels(LightFrame.DrawnFrame drawn, int shading) {
        return drawn.pictures().get(shading).raster().argb();
    }

    @Test
    void rendererIsNotClosedWhileItDraws() throws InterruptedException {
        var drawing = new CountDownLatch(1);
        var mayGoOn = new CountDownLatch(1);
        var done = new CountDownLatch(1);
        var order = new CopyOnWriteArrayList<String>();
        var maker =
                new PictureMaker() {
                    @Override
                    public Raster picture(RenderRequest request, BooleanSupplier cancelled) {
                        drawing.countDown();
                        await(mayGoOn);
                        order.add("drawn");
                        throw new CancellationException();
                    }

                    @Override
                    public void close() {
                        order.add("closed");
                        done.countDown();
                    }
                };
        var lab = new LightLabModel(maker, new OwnMethods(), thread, failures::add);
        lab.resize(WIDTH, HEIGHT);
        drawing.await();
        lab.close();
        mayGoOn.countDown();
        done.await();
        assertEquals(List.of("drawn", "closed"), order);
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void threeShadingsOfOneBodyDiffer() {
        LightFrame.DrawnFrame drawn = drawn();
        assertFalse(Arrays.equals(pixels(drawn, 0), pixels(drawn, 1)));
        assertFalse(Arrays.equals(pixels(drawn, 1), pixels(drawn, 2)));
    }

    @Test
    void formulaGivesThePixelOfPhongsShading() {
        for (Reflection reflection : Reflection.values()) {
            model.choose(choice -> choice.with(reflection));
            LightFrame.DrawnFrame drawn = drawn();
            PointReading point = drawn.point().orElseThrow();
            LightChoice.LightMarks at = drawn.choice().line();
            var places = new MarkPlaces(WIDTH, HEIGHT);
            int argb =
                    drawn.pictures()
                            .get(2)
                            .raster()
                            .argb((int) places.x(at.atX()), (int) places.y(at.atY()));
            for (int c = 0; c < 3; c++)
                assertEquals(
                        argb >> 16 - 8 * c & 255,
                        255 * point.sum()[c],
                        2,
                        reflection + ", channel " + c);
        }
    }

    @Test
    void lampThatIsOffAddsNothing() {
        model.choose(choice -> choice.withLamp(0, choice.lamps().get(0).switched(false)));
        model.choose(choice -> choice.withLamp(1, choice.lamps().get(1).switched(false)));
        PointReading point = drawn().point().orElseThrow();
        assertTrue(point.lamps().isEmpty());
        double[] ambient = Substance.BRASS.surface().ambient();
        for (int c = 0; c < 3; c++) assertEquals(0.2 * ambient[c], point.sum()[c], 1e-12);
    }

    @Test
    void termLeftOutIsLeftOutOfPictureAndFormula() {
        model.choose(choice -> choice.withTerms(Set.of(LightTerm.EMISSION)));
        LightFrame.DrawnFrame drawn = drawn();
        assertArrayEquals(new double[3], drawn.point().orElseThrow().sum());
        assertTrue(Arrays.stream(pixels(drawn, 2)).anyMatch(argb -> argb == 0xFF000000));
    }

    @Test
    void farLampIsWeakerByItsAttenuation() {
        double near = drawn().point().orElseThrow().lamps().get(0).factor();
        assertEquals(1, near);
        model.choose(choice -> choice.withLamp(choice.lamp().attenuated(2, 0, 1)));
        double weaker = drawn().point().orElseThrow().lamps().get(0).factor();
        double[] at = drawn().point().orElseThrow().position();
        Lamp lamp = model.state().choice().lamp();
        double square =
                (lamp.x() - at[0]) * (lamp.x() - at[0])
                        + (lamp.y() - at[1]) * (lamp.y() - at[1])
                        + (lamp.z() - at[2]) * (lamp.z() - at[2]);
        assertEquals(1 / (2 + square / 10_000), weaker, 1e-12);
    }

    @Test
    void directionalLightHasNoAttenuationAndSpotHasACone() {
        Lamp lamp = Lamp.at(10, 20, 30).attenuated(0, 1, 0);
        assertTrue(lamp.withKind(Lamp.LampKind.SUN).light().directional());
        assertEquals(1, lamp.withKind(Lamp.LampKind.SUN).source().attenuation().factor(500));
        Lamp spot = lamp.withKind(Lamp.LampKind.SPOT).withCutoff(12);
        assertEquals(12, spot.source().cone().cutoff());
        assertArrayEquals(new double[] {-10, -20, -30}, spot.source().cone().direction());
        assertEquals(1, lamp.attenuated(0, 0, 0).constant(), "divided by 0");
    }

    @Test
    void draggedLampStaysUnderTheMouseAndKeepsItsDepth() {
        drawn();
        var grips = new LightGrips(model);
        var plan = new StagePlan(3 * WIDTH + 12, (int) (HEIGHT / 0.58), 0);
        Rectangle second = plan.picture(1);
        double depth = LightGrips.pixel(drawn(), model.state().choice().lamp())[2];
        grips.drag(
                new LightGrip(LightGrip.LightGripKind.LAMP, 0),
                new Point(second.x + 40, second.y + 60),
                plan);
        double[] pixel = LightGrips.pixel(drawn(), model.state().choice().lamp());
        assertEquals(40.0 * WIDTH / second.width, pixel[0], 1);
        assertEquals(60.0 * HEIGHT / second.height, pixel[1], 1);
        assertEquals(depth, pixel[2], 1);
    }

    @Test
    void dragOfALampIsOneChangeForUndo() {
        drawn();
        LightChoice before = model.state().choice();
        var grips = new LightGrips(model);
        model.beginDrag();
        for (int i = 0; i < 10; i++) grips.nudge(3, 1, 1);
        model.endDrag();
        assertNotEquals(before, model.state().choice());
        model.history().undo();
        assertEquals(before, model.state().choice());
        assertFalse(model.history().undoable());
    }

    @Test
    void lampsAreAddedAndTakenAwayWithinTheirNumber() {
        for (int i = 0; i < 10; i++) model.choose(LightChoice::grown);
        assertEquals(LightChoice.MOST_LAMPS, model.state().choice().lamps().size());
        assertEquals(LightChoice.MOST_LAMPS - 1, model.state().choice().selected());
        for (int i = 0; i < 10; i++) model.choose(LightChoice::shrunk);
        assertEquals(1, model.state().choice().lamps().size());
        assertEquals(0, model.state().choice().selected());
    }

    @Test
    void cubeOfAveragedNormalsIsRoundAndOfItsOwnIsNot() {
        model.choose(choice -> choice.with(new LitBody("cube", 12, LitBody.OWN)).withArrows(true));
        double[] own = drawn().cornerArrows();
        model.choose(choice -> choice.with(new LitBody("cube", 12, "angle")));
        double[] mean = drawn().cornerArrows();
        assertEquals(own.length, mean.length);
        assertFalse(Arrays.equals(own, mean));
    }

    @Test
    void profileOfFlatShadingHasStepsThatTheEyeExaggerates() {
        LightFrame.ShadedPicture flat = drawn().pictures().get(0);
        double highest = Arrays.stream(flat.brightness()).max().orElseThrow();
        assertTrue(Arrays.stream(flat.reported()).max().orElseThrow() > highest + 0.02);
    }

    @ParameterizedTest(name = "the hazard is drawn with a failure: {0}")
    @EnumSource
    void everyHazardIsAPicture(LightHazard hazard) {
        model.choose(choice -> hazard.shown());
        assertEquals(hazard.shown().body(), drawn().choice().body());
    }

    @Test
    void resetBringsBackTheFirstLightAndColorAndCanBeUndone() {
        model.choose(LightChoice::grown);
        model.color(color -> color.turned(1, 0));
        model.reset();
        assertEquals(LightChoice.first(), model.state().choice());
        assertEquals(ColorChoice.first(), model.state().color());
        model.history().undo();
        assertEquals(3, model.state().choice().lamps().size());
    }

    @Test
    void lampOrbitsInOneHundredAndTwentySteps() {
        var orbit = new LampOrbit(model);
        orbit.goTo(30);
        Lamp lamp = model.state().choice().lamp();
        assertEquals(30, orbit.step());
        assertEquals(0, lamp.x(), 1e-9);
        assertEquals(103, lamp.z());
    }
}
