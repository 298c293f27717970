package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.Function;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.visibility.scene.SavedScene;
import rasterlab.app.visibility.scene.TopicView;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;

/** Saving whose files are written when the test says so. */
class SceneSavingTest {
    @TempDir Path folder;

    private final ModelThread thread = new ModelThread();
    private final VisibilityLabModel model =
            new VisibilityLabModel(
                    new OwnMethods(),
                    (request, cancelled) -> new Raster(request.width(), request.height()),
                    thread,
                    failure -> {
                        throw new AssertionError(failure);
                    });
    private final Queue<Callable<Void>> waiting = new ArrayDeque<>();
    private final List<String> suggested = new ArrayList<>();
    private final SceneSaving saving =
            new SceneSaving(model, Texts.of("visibility", Language.ENGLISH), this::asked);

    @AfterEach
    void close() {
        model.close();
    }

    private void asked(
            String title,
            String stem,
            Function<Path, Callable<SavedScene>> write,
            Consumer<SavedScene> written) {
        Path file = folder.resolve(stem + suggested.size() + ".scene.json");
        suggested.add(stem);
        Callable<SavedScene> writing = write.apply(file);
        waiting.add(
                () -> {
                    written.accept(writing.call());
                    return null;
                });
    }

    private void writeAll() throws Exception {
        while (!waiting.isEmpty()) waiting.remove().call();
    }

    @Test
    @DisplayName("a scene that waits to be saved is given up for the next file")
    void allThatIsSavedIsWritten() throws Exception {
        saving.ask();
        model.choose(choice -> choice.withScene("globe"));
        saving.ask();
        model.open(folder.resolve("none.obj"));
        thread.settle(model::settle);
        writeAll();
        assertEquals(List.of("vase", "globe"), suggested);
        assertTrue(Files.readString(folder.resolve("vase0.scene.json")).contains("\"vase\""));
        assertTrue(Files.readString(folder.resolve("globe1.scene.json")).contains("\"globe\""));
        assertTrue(model.saved().orElseThrow().holds(model.state().choice().shown()));
    }

    @Test
    @DisplayName("the command draws what was chosen while its scene was being saved")
    void commandIsOfTheSavedScene() throws Exception {
        var body = new VisibleFacesTopic().hazards().get(0).input();
        model.choose(TopicView.of("visible-faces-cube", body, "back-face", "back-face")::shown);
        String later =
                VisibilityCommand.now(model)
                        .drawnFrom(folder.resolve("visible-faces-cube0.scene.json"))
                        .text();
        var told = new ArrayList<String>();
        saving.tellCommand(told::add);
        model.choose(choice -> choice.withScene("globe").withVisibility("warnock"));
        writeAll();
        assertEquals(List.of(later), told);
    }

    @Test
    @DisplayName("a file is suggested under a name that a file system may refuse")
    void suggestedNameHasNoSignsOfPaths() {
        var body = new VisibleFacesTopic().hazards().get(0).input();
        model.choose(TopicView.of("visible faces/cube", body, "back-face", "back-face")::shown);
        saving.ask();
        saving.tellCommand(command -> {});
        assertEquals(List.of("visible-faces-cube", "visible-faces-cube"), suggested);
    }
}
