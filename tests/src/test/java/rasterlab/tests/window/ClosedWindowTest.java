package rasterlab.tests.window;

import static org.assertj.swing.timing.Pause.pause;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.GraphicsEnvironment;
import java.awt.event.WindowEvent;
import java.lang.ref.WeakReference;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.assertj.swing.edt.GuiActionRunner;
import org.assertj.swing.timing.Condition;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.shell.LabFrame;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabsFile;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabSettings;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.settings.SettingsFile;
import rasterlab.engine.study.Study;
import rasterlab.tests.display.OwnDisplay;

@Tag("slow")
@ExtendWith(OwnDisplay.class)
class ClosedWindowTest {
    @TempDir Path folder;
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final List<String> problems = new CopyOnWriteArrayList<>();

    @Test
    void closedWindowIsLetGoThoughAnotherOneChangesItsTheme() {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        WeakReference<LabFrame> closed =
                new WeakReference<>(GuiActionRunner.execute(() -> opened("closed")));
        GuiActionRunner.execute(() -> closed.get().dispose());
        GuiActionRunner.execute(() -> {}); // The closed window's own event has run to its end.
        LabFrame other = GuiActionRunner.execute(() -> opened("other"));
        GuiActionRunner.execute(() -> other.wear(other.look().with(LabTheme.DARK)));
        pause(
                new Condition("the closed window is let go") {
                    @Override
                    public boolean test() {
                        System.gc();
                        return closed.get() == null;
                    }
                });
        GuiActionRunner.execute(other::dispose);
        GuiActionRunner.execute(() -> {});
        assertEquals(List.of(), failures);
        assertEquals(List.of(), problems);
    }

    @Test
    void closedWindowGivesUpTheStudyThatRuns() {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        LabModels models = GuiActionRunner.execute(() -> LabModels.first(failures::add));
        LabFrame frame = GuiActionRunner.execute(() -> opened("measuring", models));
        await("the result that ships is shown", () -> shown(models).isPresent());
        Optional<Study> shipped = shown(models);
        GuiActionRunner.execute(() -> models.study().takeTime(true));
        GuiActionRunner.execute(() -> models.study().measure());
        await("the study has begun", () -> isIn("StudyRunner"));
        GuiActionRunner.execute(
                () -> frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING)));
        await("the window is closed", () -> !frame.isDisplayable());
        await("the study has ended", () -> !isIn("StudyRunner"));
        GuiActionRunner.execute(() -> {});
        assertEquals(shipped, shown(models), "measured to its end");
        assertEquals(List.of(), failures);
        assertEquals(List.of(), problems);
    }

    private static Optional<Study> shown(LabModels models) {
        return GuiActionRunner.execute(() -> models.study().state().study());
    }

    /** Whether any thread is at work in that class. */
    private static boolean isIn(String className) {
        return Thread.getAllStackTraces().values().stream()
                .flatMap(Stream::of)
                .anyMatch(frame -> frame.getClassName().endsWith("." + className));
    }

    private static void await(String what, BooleanSupplier reached) {
        pause(
                new Condition(what) {
                    @Override
                    public boolean test() {
                        return reached.getAsBoolean();
                    }
                });
    }

    private LabFrame opened(String name) {
        return opened(name, LabModels.first(failures::add));
    }

    private LabFrame opened(String name, LabModels models) {
        Path settings = folder.resolve(name).resolve("window.properties");
        LabTheme.LIGHT.install();
        var frame =
                new LabFrame(
                        models,
                        LabSettings.first(Language.ENGLISH).with(LabLook.first(Language.ENGLISH)),
                        Language.ENGLISH,
                        new SettingsFile(settings, each -> problems.add(each.toString())),
                        LabsFile.nextTo(settings, each -> problems.add(each.toString())),
                        failures::add);
        frame.setVisible(true);
        return frame;
    }
}
