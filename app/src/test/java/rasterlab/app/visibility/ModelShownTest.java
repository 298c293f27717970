package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.obj.UpAxis;

/** A model on its axis, and where nothing of it is seen. */
class ModelShownTest {
    private static final String POLE = "v 0 0 0\nv 1 0 0\nv 0 8 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n";

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ModelThread thread = new ModelThread();
    private final Renderer renderer = new Renderer();
    private final VisibilityLabModel model =
            new VisibilityLabModel(new OwnMethods(), renderer::render, thread, failures::add);

    @TempDir Path folder;

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private Path write(String obj) throws IOException {
        return Files.writeString(folder.resolve("a.obj"), obj);
    }

    private void open(Path file) {
        model.open(file);
        thread.settle(model::settle);
    }

    private Optional<UpAxis> up() {
        return model.state().choice().shown().up();
    }

    /** The extent of what is shown along z, which is up in a scene. */
    private static double height(VisibilityLabModel lab) {
        Mesh mesh = lab.state().choice().shown().scene().mesh();
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int v = 0; v < mesh.vertexCount(); v++) {
            low = Math.min(low, mesh.z(v));
            high = Math.max(high, mesh.z(v));
        }
        return high - low;
    }

    @Test
    @DisplayName(
            "another axis is not up, cannot be undone, moves the eye, or is not in the command")
    void standsOnTheChosenAxis() throws IOException {
        open(write(POLE));
        model.turn(0.25, 0.5);
        var eye = model.state().choice().camera();
        double high = height(model);
        SceneOpening.stand(model, UpAxis.Z);
        thread.settle(model::settle);
        assertEquals(Optional.of(UpAxis.Z), up());
        assertEquals(high / 8, height(model), 1e-9);
        assertEquals(eye, model.state().choice().camera());
        assertTrue(VisibilityCommand.now(model).text().contains(" --up z "));
        model.history().undo();
        assertEquals(Optional.of(UpAxis.Y), up());
        assertEquals(high, height(model), 1e-9);
        assertTrue(!VisibilityCommand.now(model).text().contains("--up"));
    }

    @Test
    @DisplayName("the next start stands the model on another axis than it was left on")
    void axisIsKept() throws IOException {
        open(write(POLE));
        SceneOpening.stand(model, UpAxis.Z);
        thread.settle(model::settle);
        try (var next =
                new VisibilityLabModel(new OwnMethods(), renderer::render, thread, failures::add)) {
            next.restore(model.kept());
            next.keptFiles().restore(model.keptFiles().kept());
            thread.settle(next::settle);
            assertEquals(Optional.of(UpAxis.Z), next.state().choice().shown().up());
            assertEquals(height(model), height(next), 1e-9);
        }
    }

    @Test
    @DisplayName("an axis is offered where no model is shown, or a lost file takes the model away")
    void onlyModelsThatAreThereAreTurned() throws IOException {
        SceneOpening.stand(model, UpAxis.Z);
        thread.settle(model::settle);
        assertEquals(Optional.empty(), up());
        Path file = write(POLE);
        open(file);
        Files.delete(file);
        SceneOpening.stand(model, UpAxis.Z);
        thread.settle(model::settle);
        assertEquals(Optional.of(UpAxis.Y), up());
        assertTrue(model.state().problem().startsWith(file.toString()), model.state().problem());
    }

    @Test
    @DisplayName("an empty picture of a model does not say why, or one that shows it does")
    void emptyPictureSaysWhy() throws Exception {
        assertEquals(List.of(false, true), List.of(saysEmpty(2), saysEmpty(0.5)));
    }

    /**
     * @param far the farthest that is drawn, as a share of the distance to the model's middle
     */
    private boolean saysEmpty(double far) throws Exception {
        Path file = write(POLE);
        try (var shown =
                new VisibilityLabModel(
                        new OwnMethods(),
                        renderer::render,
                        EventQueue::invokeLater,
                        failures::add)) {
            var stage = new VisibilityStage(shown, Texts.of("visibility", Language.ENGLISH));
            EventQueue.invokeAndWait(() -> shown.open(file));
            shown.settle();
            EventQueue.invokeAndWait(
                    () -> shown.choose(choice -> choice.with(choice.look().withFar(far))));
            OffscreenPainter.paint(stage, 640, 480);
            String words =
                    stage.svg().document().replaceAll("<[^>]*>", " ").replaceAll("\\s+", " ");
            return words.contains("Nothing of the model is seen");
        }
    }
}
