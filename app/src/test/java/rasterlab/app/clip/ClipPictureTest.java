package rasterlab.app.clip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.clip.outcome.ClipResults;
import rasterlab.app.clip.outcome.ClipTopics;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.clip.scene.PlaneSegment;
import rasterlab.app.clip.scene.PolygonClipScene;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.ShownWindow;
import rasterlab.app.clip.scene.SpacePoint;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.app.clip.scene.VolumeSpace;
import rasterlab.app.clip.scene.VolumeViewpoint;
import rasterlab.engine.clip.segment.ClipWindow;

/** Describes the picture without painting it. */
class ClipPictureTest {
    /** Contrast of text that WCAG 2.2 asks for, 1.4.3. */
    private static final double READ = 4.5;

    private final ClipTopics topics = new ClipTopics();

    private List<ClipMark> drawn(ClipScene scene, int step) {
        ClipResults results = ClipResults.of(topics, scene);
        int shown = step < 0 ? results.clipping().steps().size() + 1 : step;
        return ClipPicture.of(scene, results.clipping(), shown, Locale.ENGLISH).drawn();
    }

    private static Stream<ClipMark.MarkedLine> lines(
            List<ClipMark> drawn, ClipMark.MarkMeaning ink) {
        return drawn.stream()
                .filter(ClipMark.MarkedLine.class::isInstance)
                .map(ClipMark.MarkedLine.class::cast)
                .filter(line -> line.ink() == ink);
    }

    private static Stream<ClipMark.MarkedSign> signs(
            List<ClipMark> drawn, ClipMark.SignShape shape) {
        return drawn.stream()
                .filter(ClipMark.MarkedSign.class::isInstance)
                .map(ClipMark.MarkedSign.class::cast)
                .filter(sign -> sign.shape() == shape);
    }

    @Test
    void writesTheCodesOfTheNineRegions() {
        List<String> codes =
                drawn(SegmentScene.first(), 0).stream()
                        .filter(ClipMark.Region.class::isInstance)
                        .map(region -> ((ClipMark.Region) region).words())
                        .toList();
        assertEquals(
                List.of("1010", "1000", "1001", "0010", "0000", "0001", "0110", "0100", "0101"),
                codes);
    }

    @Test
    void stepShowsItsSideItsPlaceAndItsNumber() {
        List<ClipMark> drawn = drawn(SegmentScene.first().withMethod("liang-barsky"), 1);
        ClipMark.MarkedLine tested =
                lines(drawn, ClipMark.MarkMeaning.TESTED).findFirst().orElseThrow();
        assertTrue(tested.points().stream().allMatch(p -> p.x() == 0), "the left side");
        ClipMark.MarkedSign enters =
                signs(drawn, ClipMark.SignShape.ENTERING).findFirst().orElseThrow();
        assertEquals(0, enters.at().x(), 1e-12);
        assertEquals("t = 0.2", enters.words());
        assertEquals(
                0, lines(drawn, ClipMark.MarkMeaning.LEFT).count(), "a result before its time");
    }

    @Test
    void codeStepsShowTheCode() {
        List<ClipMark> drawn = drawn(SegmentScene.first(), 1);
        ClipMark.MarkedSign enters =
                signs(drawn, ClipMark.SignShape.ENTERING).findFirst().orElseThrow();
        assertEquals("1010", enters.words());
    }

    @Test
    void resultMarksWhatIsWrongByKind() {
        List<ClipMark> right = drawn(SegmentScene.first(), -1);
        assertEquals(3, lines(right, ClipMark.MarkMeaning.LEFT).count());
        assertEquals(0, lines(right, ClipMark.MarkMeaning.MISSING).count());
        List<ClipMark> wrong =
                drawn(SegmentScene.first().withMethod("cohen-sutherland-textbook"), -1);
        assertTrue(lines(wrong, ClipMark.MarkMeaning.MISSING).count() > 0);
        assertTrue(lines(wrong, ClipMark.MarkMeaning.EXTRA).count() > 0);
    }

    @Test
    void weilerAthertonShowsWhereTheBoundaryEntersAndLeaves() {
        PolygonClipScene scene = PolygonClipScene.first().withMethod("weiler-atherton");
        List<ClipMark> drawn = drawn(scene, 1);
        ClipPoint enters = signs(drawn, ClipMark.SignShape.ENTERING).findFirst().orElseThrow().at();
        ClipPoint leaves = signs(drawn, ClipMark.SignShape.LEAVING).findFirst().orElseThrow().at();
        for (ClipPoint place : List.of(enters, leaves))
            assertTrue(place.x() == 0 || place.x() == 10 || place.y() == 6, place.toString());
    }

    @Test
    void sutherlandHodgmanShowsTheLineOfTheSide() {
        ClipMark.MarkedLine tested =
                lines(drawn(PolygonClipScene.first(), 2), ClipMark.MarkMeaning.TESTED)
                        .findFirst()
                        .orElseThrow();
        assertTrue(tested.points().stream().allMatch(p -> p.x() == 10), "the right side");
    }

    @Test
    void volumeHasTwelveEdgesAndHidesThoseBehind() {
        List<ClipMark> drawn = drawn(VolumeScene.first(), 0);
        long seen = lines(drawn, ClipMark.MarkMeaning.WINDOW).count();
        long hidden = lines(drawn, ClipMark.MarkMeaning.HIDDEN).count();
        assertEquals(12, seen + hidden);
        assertTrue(hidden > 0 && hidden < seen, hidden + " of 12 hidden");
    }

    /** z points away from whom sees x to the right and y upwards. */
    @Test
    void nearFaceIsTurnedToTheEye() {
        var ahead = new VolumeViewpoint(0, 0);
        assertTrue(ahead.faces(new SpacePoint(0, 0, -1)));
        assertFalse(ahead.faces(new SpacePoint(0, 0, 1)));
        assertTrue(VolumeViewpoint.FIRST.faces(new SpacePoint(1, 0, 0)), "seen from the right");
        assertTrue(VolumeViewpoint.FIRST.faces(new SpacePoint(0, 1, 0)), "seen from above");
    }

    @Test
    void boxAfterTheDivisionIsSquare() {
        VolumeScene scene =
                VolumeScene.first()
                        .withSpace(VolumeSpace.CANONICAL)
                        .withView(new VolumeViewpoint(0, 0));
        for (ClipMark.MarkedLine edge :
                lines(drawn(scene, 0), ClipMark.MarkMeaning.WINDOW).toList())
            for (ClipPoint corner : edge.points()) {
                assertEquals(1, Math.abs(corner.x()), 1e-12);
                assertEquals(1, Math.abs(corner.y()), 1e-12);
            }
    }

    @ParameterizedTest(name = "a region''s code is too pale to be read: {0}")
    @MethodSource("themes")
    void codesStandOutFromTheirGround(StageColors colors) {
        for (Color ground : List.of(colors.ground(), colors.margin())) {
            double contrast = MethodColors.contrast(ClipPainter.code(colors), ground);
            assertTrue(contrast >= READ, ground + ": " + contrast);
        }
    }

    static Stream<StageColors> themes() {
        return Stream.of(StageColors.LIGHT, StageColors.DARK, StageColors.PROJECTOR);
    }

    @Test
    @DisplayName("labels of ends cover segments, or the window")
    void labelsAreToldOfSegmentsAndOfTheWindow() {
        SegmentScene scene = SegmentScene.first();
        ClipPicture picture =
                ClipPicture.of(scene, ClipResults.of(topics, scene).clipping(), 0, Locale.ENGLISH);
        var view = new Rectangle(2000, 2000);
        List<Line2D> lines = picture.lines(new PlaneMap(1000, 1000, 20, -20), view);
        assertEquals(scene.segments().size() + 4, lines.size());
    }

    /** The middle of the window lies on the segment. */
    @Test
    @DisplayName("a region's code is written over a segment")
    void codesGiveWayToSegments() {
        PlaneSegment across = PlaneSegment.of(new double[] {-5, 0, 15, 6});
        SegmentScene scene =
                new SegmentScene(
                        ShownWindow.of(new ClipWindow(0, 0, 10, 6)),
                        List.of(across),
                        "cohen-sutherland",
                        "");
        var map = new PlaneMap(100, 280, 25, -25);
        ClipResults results = ClipResults.of(topics, scene);
        ClipPicture picture = ClipPicture.of(scene, results.clipping(), 0, Locale.ENGLISH);
        StageColors colors = StageColors.LIGHT;
        int code = ClipPainter.code(colors).getRGB();
        var image = new BufferedImage(450, 400, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setClip(0, 0, 450, 400);
        picture.paint(g, map, colors, () -> false);
        g.dispose();
        var line = new Line2D.Double(map.viewX(-5), map.viewY(0), map.viewX(15), map.viewY(6));
        int written = 0;
        for (int y = 0; y < 400; y++)
            for (int x = 0; x < 450; x++)
                if (image.getRGB(x, y) == code) {
                    written++;
                    double away = line.ptSegDist(x, y);
                    assertTrue(away > 4, "(" + x + ", " + y + ") is " + away + " away");
                }
        assertTrue(written > 200, written + " pixels of codes");
    }
}
