package rasterlab.app.shell.labs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineRoom;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabSettings;
import rasterlab.app.shell.settings.SettingsFile;
import rasterlab.app.spline.SplineMode;
import rasterlab.app.spline.SplineRoom;

@Timeout(300)
class StateKeeperTest {
    private static final LabSettings FIRST = LabSettings.first(Language.ENGLISH);

    @TempDir Path folder;
    private final List<String> problems = new CopyOnWriteArrayList<>();

    private Path labs() {
        return folder.resolve("labs.json");
    }

    /** A window's life between its first look and its last. */
    private void live(Consumer<LabModels> during) throws InterruptedException {
        live((models, keeper) -> during.accept(models));
    }

    private void live(BiConsumer<LabModels, StateKeeper> during) throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    try (LabModels models =
                            LabModels.first(failure -> problems.add(failure.toString()))) {
                        var file =
                                new SettingsFile(
                                        folder.resolve("window.properties"),
                                        problem -> problems.add(problem.toString()));
                        var labsFile =
                                new LabsFile(labs(), problem -> problems.add(problem.toString()));
                        labsFile.read().ifPresent(kept -> labsFile.restore(kept, models.kept()));
                        var keeper = new StateKeeper(file, labsFile, () -> FIRST, models);
                        during.accept(models, keeper);
                        keeper.close();
                    }
                });
    }

    @Test
    void windowThatChangedNothingLeavesWhatAnotherOneWroteMeanwhile() throws Exception {
        var file =
                new SettingsFile(
                        folder.resolve("window.properties"),
                        problem -> problems.add(problem.toString()));
        LabSettings others = LabSettings.first(Language.RUSSIAN);
        live(
                models -> {
                    file.save(others);
                    another("other", 7);
                });
        assertEquals(others, file.load(FIRST));
        assertTrue(Files.readString(labs()).contains("other"), Files.readString(labs()));
        assertEquals(List.of(), problems);
    }

    /** Writes one lab's choice, as another window does. */
    private void another(String lab, Object choice) {
        new LabsFile(labs(), problem -> {}).save(Map.of(lab, choice), Set.of(lab));
    }

    @Test
    void windowThatChangedOneLabLeavesTheOthersAsAnotherOneWroteThem() throws Exception {
        live(models -> models.of(new LineRoom()).chooseMethod("dda"));
        live(
                models -> {
                    another("coordinates", CoordinatesMode.ROTATION);
                    models.of(new LineRoom()).chooseMethod("naive");
                });
        String kept = Files.readString(labs());
        assertTrue(kept.contains("ROTATION"), kept);
        assertTrue(kept.contains("naive"), kept);
        assertEquals(List.of(), problems);
    }

    @Test
    void partThatCannotBeUsedAloneIsWrittenAnew() throws Exception {
        live(models -> models.of(new LineRoom()).chooseMethod("dda"));
        Files.writeString(
                labs(), Files.readString(labs()).replace("\"dda\"", "\"of another time\""));
        live(models -> another("later", 7));
        assertEquals(1, problems.size(), problems.toString());
        String kept = Files.readString(labs());
        assertTrue(kept.contains("\"later\""), kept);
        assertFalse(kept.contains("of another time"), kept);
    }

    @Test
    void whatWasChangedLastIsWritten() throws Exception {
        live(models -> models.of(new LineRoom()).chooseMethod("dda"));
        assertTrue(Files.readString(labs()).contains("dda"), Files.readString(labs()));
        assertEquals(List.of(), problems);
    }

    @Test
    void whatCouldNotBeWrittenIsWrittenAtTheEnd() throws Exception {
        live(
                (models, keeper) -> {
                    models.of(new LineRoom()).chooseMethod("dda");
                    inTheWay(keeper::look);
                });
        assertTrue(Files.readString(labs()).contains("dda"), Files.readString(labs()));
        assertEquals(1, problems.size(), problems.toString());
    }

    /** A folder stands in the file's place until that is told. */
    private void inTheWay(Runnable look) {
        try {
            Path inside = Files.createDirectories(labs().resolve("folder"));
            look.run();
            while (problems.isEmpty()) Thread.onSpinWait();
            Files.delete(inside);
            Files.delete(labs());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void labThatIsMadeLateIsWrittenWhereItWasChangedOnly() throws Exception {
        live(
                models -> {
                    models.of(new LineRoom()).chooseMethod("dda");
                    models.of(new SplineRoom()).show(SplineMode.FUNCTION);
                });
        OffscreenPainter.onEventThread(
                () -> {
                    var labsFile = new LabsFile(labs(), problem -> fail(problem.toString()));
                    LabsFile.Content kept = labsFile.read().orElseThrow();
                    var file = new SettingsFile(folder.resolve("window.properties"), problem -> {});
                    try (var models =
                            LabModels.unmade(
                                    Runnable::run,
                                    labs -> labsFile.restore(kept, labs),
                                    failure -> problems.add(failure.toString()))) {
                        var keeper = new StateKeeper(file, labsFile, () -> FIRST, models);
                        models.of(new LineRoom()).chooseMethod("naive");
                        models.of(new SplineRoom());
                        another("spline", "written meanwhile");
                        keeper.close();
                    }
                });
        String left = Files.readString(labs());
        assertTrue(left.contains("naive"), left);
        assertTrue(left.contains("written meanwhile"), left);
        assertEquals(List.of(), problems);
    }

    @Test
    void brokenFileIsToldOnce() throws Exception {
        Files.writeString(labs(), "[");
        live(models -> {});
        live(models -> {});
        assertEquals(1, problems.size(), problems.toString());
    }
}
