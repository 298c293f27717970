package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.event.ActionEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.event.MouseWheelListener;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Base64;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;

@Tag("slow")
class VisibilityStageTest {
    private static final Pattern IMAGE = Pattern.compile("data:image/png;base64,([^\"]*)");

    private final Renderer renderer = new Renderer();
    private final VisibilityLabModel model =
            new VisibilityLabModel(
                    new OwnMethods(),
                    renderer::render,
                    java.awt.EventQueue::invokeLater,
                    this::fail);
    private final VisibilityStage stage =
            new VisibilityStage(model, Texts.of("visibility", Language.RUSSIAN));

    private void fail(Throwable cause) {
        throw new AssertionError(cause);
    }

    @AfterEach
    void close() {
        model.close();
    }

    @Test
    @DisplayName("the drawing has another picture than the stage, or none of the names over it")
    void drawingHasTheExactPictureAndWhatLiesOverIt() throws Exception {
        model.choose(choice -> choice.withComparison("z16"));
        OffscreenPainter.paint(stage, 240, 160);
        String svg = stage.svg().document();
        var images = IMAGE.matcher(svg);
        assertTrue(images.find(), svg);
        Raster picture = model.state().picture().orElseThrow().raster();
        BufferedImage drawn = decoded(images.group(1));
        assertEquals(picture.width(), drawn.getWidth());
        for (int y = 0; y < picture.height(); y++)
            for (int x = 0; x < picture.width(); x++)
                assertEquals(picture.argb(x, y), drawn.getRGB(x, y), "pixel " + x + ", " + y);
        assertTrue(images.find(), "the second picture");
        assertTrue(svg.contains(">z16</text"), "the second method's name");
    }

    @Test
    @DisplayName("depths are shown as a painter's, who has none")
    void depthsOfAnotherMethodAreNamedAsItsOwn() throws Exception {
        model.choose(
                choice ->
                        choice.withVisibility("painter")
                                .withComparison("z16")
                                .withView(StageView.DEPTHS));
        OffscreenPainter.paint(stage, 2400, 160);
        String svg = stage.svg().document();
        Texts texts = Texts.of("visibility", Language.RUSSIAN);
        assertTrue(svg.contains(">" + texts.text("depths.lent", "zfloat", "painter")), svg);
        assertFalse(svg.contains(texts.text("depths.lent", "zfloat", "z16")), "of z16's own");
    }

    @Test
    @DisplayName("a chart is copied as a picture made larger")
    void chartIsDrawnByLinesAndText() throws InterruptedException {
        model.choose(choice -> choice.withView(StageView.PRECISION));
        stage.refresh();
        OffscreenPainter.paint(stage, 240, 160);
        String svg = stage.svg().document();
        assertTrue(svg.contains(Texts.of("precision", Language.RUSSIAN).text("mark")), "a note");
        assertTrue(!svg.contains("<image"), "an image");
    }

    @ParameterizedTest(name = "nothing is counted after {0} until something is chosen")
    @ValueSource(strings = {"pressed LEFT", "typed +", "the wheel"})
    void wrongPixelsAreCountedAfterEachChangeOfTheView(String change) throws Exception {
        OffscreenPainter.paint(stage, 240, 160);
        Object before = model.state().choice();
        EventQueue.invokeAndWait(
                () -> {
                    if (change.equals("the wheel")) turnWheel();
                    else
                        stage.getActionMap()
                                .get(change)
                                .actionPerformed(new ActionEvent(stage, 0, change));
                });
        OffscreenPainter.paint(stage, 240, 160);
        assertNotEquals(before, model.state().choice());
        assertTrue(model.state().difference().isPresent());
    }

    private void turnWheel() {
        var turned =
                new MouseWheelEvent(stage, MouseEvent.MOUSE_WHEEL, 0, 0, 9, 9, 0, false, 0, 3, 1);
        for (MouseWheelListener each : stage.getMouseWheelListeners()) each.mouseWheelMoved(turned);
    }

    @Test
    @DisplayName("the wheel or a key in the middle of a drag ends it for undo")
    void dragIsOneChangeWhateverElseTurnsTheEye() throws Exception {
        OffscreenPainter.paint(stage, 240, 160);
        VisibilityChoice before = model.state().choice();
        EventQueue.invokeAndWait(
                () -> {
                    mouse(MouseEvent.MOUSE_PRESSED, 20);
                    mouse(MouseEvent.MOUSE_DRAGGED, 40);
                    turnWheel();
                    mouse(MouseEvent.MOUSE_DRAGGED, 60);
                    stage.getActionMap()
                            .get("pressed LEFT")
                            .actionPerformed(new ActionEvent(stage, 0, ""));
                    mouse(MouseEvent.MOUSE_DRAGGED, 80);
                    mouse(MouseEvent.MOUSE_RELEASED, 80);
                });
        assertNotEquals(before, model.state().choice());
        // On the thread of the pictures' news, which would write over the choice meanwhile.
        EventQueue.invokeAndWait(() -> model.history().undo());
        assertEquals(before, model.state().choice());
        assertFalse(model.history().undoable());
    }

    private void mouse(int id, int x) {
        int held = MouseEvent.BUTTON1_DOWN_MASK;
        stage.dispatchEvent(
                new MouseEvent(stage, id, 0, held, x, 50, 1, false, MouseEvent.BUTTON1));
    }

    @Test
    @DisplayName("a refusal is told in English")
    void refusalIsSaidInTheWindowsLanguage() throws Exception {
        try (var lab =
                new VisibilityLabModel(
                        new OwnMethods(),
                        (request, cancelled) -> {
                            throw new IllegalArgumentException(
                                    "window must be convex, but goes round 2 times");
                        },
                        EventQueue::invokeLater,
                        this::fail)) {
            var refusing = new VisibilityStage(lab, Texts.of("visibility", Language.RUSSIAN));
            OffscreenPainter.paint(refusing, 640, 160);
            OffscreenPainter.paint(refusing, 640, 160);
            String svg = refusing.svg().document();
            assertTrue(svg.contains("отказался"), svg);
            assertFalse(svg.contains("must"), svg);
        }
    }

    private static BufferedImage decoded(String base64) throws IOException {
        byte[] bytes = Base64.getMimeDecoder().decode(base64.replace("&#10;", ""));
        return ImageIO.read(new ByteArrayInputStream(bytes));
    }
}
