package rasterlab.app.light;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.light.panel.LightStage;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.engine.scene.obj.UpAxis;

/** A lit model on its axis, and where nothing of it is seen. */
class LitModelTest {
    private static final String POLE = "v 0 0 0\nv 1 0 0\nv 0 8 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n";

    /** A triangle too thin for any pixel's middle. */
    private static final String NEEDLE = "v -1 0 0\nv 1 0 0\nv 0.3 1e-7 0\nf 1 2 3\n";

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ModelThread thread = new ModelThread();
    private final LightLabModel model = new LightLabModel(thread, failures::add);

    @TempDir Path folder;

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private Path write(String obj) throws IOException {
        return Files.writeString(folder.resolve("a.obj"), obj);
    }

    @Test
    @DisplayName("another axis is not up, cannot be undone, is not kept, or takes normals away")
    void standsOnTheChosenAxis() throws IOException {
        model.open(write(POLE));
        thread.settle(model::settle);
        assertEquals(Optional.of(UpAxis.Y), model.state().choice().body().up());
        model.choose(choice -> choice.with(choice.body().withNormals("angle")));
        model.stand(UpAxis.Z);
        thread.settle(model::settle);
        assertEquals(Optional.of(UpAxis.Z), model.state().choice().body().up());
        assertEquals("angle", model.state().choice().body().normals());
        try (var next = new LightLabModel(thread, failures::add)) {
            next.restore(model.kept());
            next.keptFile().restore(model.keptFile().kept());
            thread.settle(next::settle);
            assertEquals(Optional.of(UpAxis.Z), next.state().choice().body().up());
        }
        model.history().undo();
        assertEquals(Optional.of(UpAxis.Y), model.state().choice().body().up());
    }

    @Test
    @DisplayName("an empty picture of a model does not say why, or one that shows it does")
    void emptyPictureSaysWhy() throws Exception {
        assertEquals(List.of(false, true), List.of(saysEmpty(POLE), saysEmpty(NEEDLE)));
    }

    private boolean saysEmpty(String obj) throws Exception {
        Path file = write(obj);
        try (var shown = new LightLabModel(EventQueue::invokeLater, failures::add)) {
            var stage = new LightStage(shown, Texts.of("light", Language.ENGLISH));
            EventQueue.invokeAndWait(() -> shown.open(file));
            shown.settle();
            OffscreenPainter.paint(stage, 900, 600);
            String words =
                    stage.svg().document().replaceAll("<[^>]*>", " ").replaceAll("\\s+", " ");
            return words.contains("Nothing of the model is seen");
        }
    }
}
