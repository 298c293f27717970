package rasterlab.app.row;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class RowPainterTest {
    /** View units that may be empty below what is painted. */
    private static final int FOOT = RowPlan.MARGIN + 20;

    @ParameterizedTest(name = "{0} leave the lower part of a stage of {4}×{5} empty")
    @MethodSource("rows")
    void rowsFillTheStage(
            String topic,
            String hazard,
            String method,
            RowKind<?, ?, ?> kind,
            int width,
            int height) {
        BufferedImage stage = painted(topic, hazard, method, kind, width, height);
        int lowest = lowestPainted(stage);
        assertTrue(lowest >= height - FOOT, "painted down to " + lowest + " of " + height);
        assertTrue(lowest < height - RowPlan.MARGIN / 2, "painted over the margin: " + lowest);
    }

    static Stream<Arguments> rows() {
        int[][] stages = {{520, 428}, {900, 655}, {1540, 960}};
        return Stream.of(stages)
                .flatMap(
                        s ->
                                Stream.of(
                                        Arguments.of(
                                                "texture-mapping",
                                                "floor",
                                                "affine",
                                                new MappingKind(),
                                                s[0],
                                                s[1]),
                                        Arguments.of(
                                                "texture-filter",
                                                "aliasing",
                                                "nearest",
                                                new FilterKind(),
                                                s[0],
                                                s[1]),
                                        Arguments.of(
                                                "depth-buffer",
                                                "crossing",
                                                "z16",
                                                new DepthKind(),
                                                s[0],
                                                s[1])));
    }

    @Test
    void footprintIsEnlargedBesideTheBands() {
        BufferedImage stage =
                painted("texture-filter", "aliasing", "nearest", new FilterKind(), 900, 655);
        var plan = new RowPlan(900, 655, true);
        int ground = stage.getRGB(1, 1);
        for (int y : new int[] {655 / 4, 655 * 3 / 4}) {
            int painted = 0;
            for (int x = plan.columnLeft(); x < plan.columnLeft() + plan.column(); x++)
                if (stage.getRGB(x, y) != ground) painted++;
            assertTrue(painted > plan.column() / 3, painted + " painted in row " + y);
        }
    }

    private static BufferedImage painted(
            String topic,
            String hazard,
            String method,
            RowKind<?, ?, ?> kind,
            int width,
            int height) {
        var choice = new RowChoice(topic, hazard, method, 0);
        RowScene scene = kind.scene(choice);
        var stage = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        var g = stage.createGraphics();
        g.setColor(StageColors.now().ground());
        g.fillRect(0, 0, width, height);
        var plan = new RowPlan(width, height, scene.image().isPresent());
        new RowPainter(g, Texts.of("row", Language.RUSSIAN), choice, scene, plan).paint();
        g.dispose();
        return stage;
    }

    private static int lowestPainted(BufferedImage stage) {
        int ground = stage.getRGB(1, 1);
        for (int y = stage.getHeight() - 1; y > 0; y--)
            for (int x = 0; x < stage.getWidth(); x++) if (stage.getRGB(x, y) != ground) return y;
        return 0;
    }
}
