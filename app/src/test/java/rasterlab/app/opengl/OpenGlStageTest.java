package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabTheme;

class OpenGlStageTest {
    private final OpenGlLabModel model = new OpenGlLabModel(EventQueue::invokeLater, this::fail);
    private final OpenGlStage stage =
            new OpenGlStage(model, Texts.of("opengl", Language.ENGLISH), file -> {});

    private void fail(Throwable cause) {
        throw new AssertionError(cause);
    }

    @BeforeAll
    static void lookLikeTheLab() {
        LabTheme.LIGHT.install();
    }

    @AfterEach
    void close() {
        model.close();
    }

    @Test
    @DisplayName("the drawing lacks a picture, the titles or the calls, or is one picture of all")
    void drawingHasEachPictureAndTheCallsAsText() throws InterruptedException {
        model.listen(state -> stage.refresh());
        OffscreenPainter.paint(stage, 640, 480);
        String svg = stage.svg().document();
        int pictures = model.state().pictures().openGl().isPresent() ? 3 : 1;
        assertEquals(pictures, svg.split("<image ", -1).length - 1, "pictures");
        for (String text : new String[] {"glBegin(", "Software"})
            assertTrue(svg.contains(text), text + " in " + svg.replaceAll("base64,[^\"]*", ""));
    }
}
