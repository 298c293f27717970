package rasterlab.app.polygon;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.polygon.figure.BrushKind;
import rasterlab.app.polygon.figure.FillFigure;
import rasterlab.app.polygon.figure.Grip;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.figure.PolygonScene;
import rasterlab.app.polygon.outcome.MethodOutcome;
import rasterlab.app.polygon.outcome.PixelAnswer;
import rasterlab.app.polygon.outcome.PolygonResults;
import rasterlab.app.polygon.outcome.PolygonTopics;
import rasterlab.engine.study.Hazard;

@Tag("slow")
@Timeout(300)
class PolygonPictureTest {
    private static final int WIDTH = 260;
    private static final int HEIGHT = 200;

    private final PolygonTopics topics = new PolygonTopics();
    private final PolygonPictures pictures =
            new PolygonPictures(topics, Texts.of("polygon", Language.ENGLISH));

    private PolygonScene scene(PolygonMode mode, String hazard, String method, String second) {
        PolygonScene first = PolygonScene.first(mode).withMethod(method).withComparison(second);
        return hazard.isEmpty() ? first : first.with(topics.showing(first, hazard));
    }

    private static Set<Integer> colors(PolygonScene scene, PlanePicture picture) {
        var image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(Color.WHITE);
        var view = new Rectangle(0, 0, WIDTH, HEIGHT);
        g.fill(view);
        g.setClip(view);
        PlaneAxes axes = scene.mode().raster() ? PlaneAxes.RASTER : PlaneAxes.GEOMETRY;
        PlaneMap map = PlaneMap.fitting(PolygonFraming.of(scene.figure()), view, axes);
        picture.paint(g, map, StageColors.LIGHT, () -> false);
        g.dispose();
        var colors = new HashSet<Integer>();
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) colors.add(image.getRGB(x, y));
        return colors;
    }

    private Set<Integer> result(PolygonScene scene) {
        PolygonResults results = PolygonResults.of(topics, scene);
        int step = results.outcome().steps() + 1;
        return colors(scene, pictures.of(scene, results.outcome(), step));
    }

    @ParameterizedTest(name = "{1} of {0}: {2} is marked as wrong: {3}")
    @CsvSource({
        "TRIANGLE, '', sign-double, true",
        "TRIANGLE, '', robust, false",
        "POLYGON, ray-through-a-corner, ray-naive, true",
        "POLYGON, covered-twice, robust, false",
        "TRIANGULATION, corner-in-the-ear, shortest-diagonal-textbook, true",
        "TRIANGULATION, corner-in-the-ear, ear-clipping, false",
        "FILL, valley-in-a-row, naive, true",
        "FILL, valley-in-a-row, scanline, false",
        "SEED, last-column-behind, recursive-textbook, true",
        "SEED, last-column-behind, span, false"
    })
    void marksWhatIsWrongAndNothingElse(
            PolygonMode mode, String hazard, String method, boolean wrong) {
        Set<Integer> colors = result(scene(mode, hazard, method, ""));
        assertEquals(wrong, colors.contains(MethodColors.VERMILLION.getRGB()));
    }

    @ParameterizedTest(name = "the name of a corner is written over a side: {0}")
    @EnumSource(names = {"TRIANGLE", "POLYGON", "FILL"})
    void labelsKeepOffTheSides(PolygonMode mode) {
        PolygonScene scene = PolygonScene.first(mode);
        MethodOutcome outcome = PolygonResults.of(topics, scene).outcome();
        var view = new Rectangle(0, 0, WIDTH, HEIGHT);
        PlaneAxes axes = mode.raster() ? PlaneAxes.RASTER : PlaneAxes.GEOMETRY;
        PlaneMap map = PlaneMap.fitting(PolygonFraming.of(scene.figure()), view, axes);
        List<Line2D> lines = pictures.of(scene, outcome, 1).lines(map, view);
        List<PolygonPoint> corners =
                scene.figure().grips().entrySet().stream()
                        .filter(each -> each.getKey().kind() == Grip.PolygonGripKind.CORNER)
                        .map(Map.Entry::getValue)
                        .toList();
        for (int i = 0; i < corners.size(); i++) {
            PolygonPoint from = corners.get(i);
            PolygonPoint to = corners.get((i + 1) % corners.size());
            double x = map.viewX((from.x() + to.x()) / 2);
            double y = map.viewY((from.y() + to.y()) / 2);
            assertTrue(lines.stream().anyMatch(line -> line.ptSegDist(x, y) < 1), "side " + i);
        }
    }

    @ParameterizedTest(name = "a hazard cannot be drawn: {0}")
    @EnumSource
    void drawsEachStepOfEachHazard(PolygonMode mode) {
        for (Hazard<?> hazard : topics.hazards(mode))
            for (String method : topics.methods(mode)) {
                PolygonScene scene = scene(mode, hazard.name(), method, "");
                PolygonResults results = PolygonResults.of(topics, scene);
                for (int step : new int[] {1, results.outcome().steps() + 1})
                    assertFalse(
                            colors(scene, pictures.of(scene, results.outcome(), step)).isEmpty(),
                            hazard.name());
            }
    }

    @Test
    void differenceOfTwoMethodsHasTheirColors() {
        PolygonScene scene = scene(PolygonMode.FILL, "corners-on-centres", "naive", "scanline");
        PolygonResults results = PolygonResults.of(topics, scene);
        PlanePicture difference = pictures.difference(results, results.outcome().steps() + 1);
        assertTrue(colors(scene, difference).contains(PolygonColors.OWN.of("naive").getRGB()));
        scene = scene(PolygonMode.POLYGON, "covered-twice", "winding", "ray");
        results = PolygonResults.of(topics, scene);
        difference = pictures.difference(results, 0);
        assertTrue(colors(scene, difference).contains(PolygonColors.OWN.of("winding").getRGB()));
        assertTrue(colors(scene, difference).contains(PolygonColors.OWN.of("ray").getRGB()));
    }

    @Test
    void hatchLeavesPixelsBetweenItsLines() {
        PolygonScene solid = scene(PolygonMode.FILL, "", "scanline", "");
        PolygonScene hatched =
                solid.with(((FillFigure) solid.figure()).withBrush(BrushKind.DIAGONAL_CROSS));
        int between =
                MethodColors.mix(Color.WHITE, PolygonColors.OWN.of("scanline"), 0.12).getRGB();
        assertFalse(result(solid).contains(between));
        assertTrue(result(hatched).contains(between));
    }

    @ParameterizedTest(name = "labels are not told of a pixel that {1} of {0} fills")
    @CsvSource({"FILL, naive", "FILL, scanline", "SEED, span"})
    void labelsAreToldOfEveryPixelThatIsLit(PolygonMode mode, String method) {
        PolygonScene scene = PolygonScene.first(mode).withMethod(method);
        PolygonResults results = PolygonResults.of(topics, scene);
        var view = new Rectangle(0, 0, WIDTH, HEIGHT);
        PlaneMap map = PlaneMap.fitting(PolygonFraming.of(scene.figure()), view, PlaneAxes.RASTER);
        int steps = results.outcome().steps();
        double area = 0;
        for (int step = 0; step <= steps + 1; step++) {
            double now =
                    pictures.of(scene, results.outcome(), step).pixels(map, view).stream()
                            .mapToDouble(pixel -> pixel.getWidth() * pixel.getHeight())
                            .sum();
            assertTrue(now >= area, "step " + step + " takes pixels away");
            area = now;
        }
        PixelAnswer answer = (PixelAnswer) results.outcome().answer();
        double filled = 0;
        for (int run = 0; run < steps; run++)
            filled += answer.runs().to(run) - answer.runs().from(run);
        assertTrue(area >= filled * map.scaleX() * map.scaleY() - 1e-6, area + " of " + filled);
    }
}
