package rasterlab.app.shell;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** Opens the window as it was left. */
public final class WindowStart {
    private WindowStart() {}

    /**
     * Settings are read, and scenes made, beside the event thread, which makes the look meanwhile.
     */
    public static void open() {
        var problems = new Problems();
        Path place = SettingsFile.usual(System.getenv(), System.getProperties());
        var file = new SettingsFile(place, problems);
        LabSettings settings = file.load(LabSettings.first(Language.of(Locale.getDefault())));
        EventQueue.invokeLater(
                () -> settings.look().theme().install(settings.look().textPercent()));
        LabsFile labs = LabsFile.beside(place, problems);
        Optional<LabsFile.Content> before = labs.read();
        EventQueue.invokeLater(() -> open(settings, file, labs, before, problems));
        keep(settings, file, place, problems);
        LabModels.prepare();
    }

    private static void open(
            LabSettings settings,
            SettingsFile file,
            LabsFile labs,
            Optional<LabsFile.Content> before,
            Problems problems) {
        var shown = new LabFrame[1];
        var reports =
                new FailureReports(
                        failure -> new ErrorDialog(texts(shown[0])).show(shown[0], failure));
        Thread.setDefaultUncaughtExceptionHandler(reports);
        LabModels models = LabModels.first(reports);
        before.ifPresent(content -> labs.bringBack(content, models));
        shown[0] = new LabFrame(models, settings, file, labs, reports);
        shown[0].setVisible(true);
        problems.showIn(shown[0]);
    }

    /**
     * Saves the settings at once too, so that whoever cannot write them learns so now, not when the
     * window is gone; but not over what another window may have changed since they were read.
     */
    static void keep(
            LabSettings settings, SettingsFile file, Path place, Consumer<Problem> problem) {
        boolean first = true;
        try {
            first = OneWindow.hold(place, problem);
        } catch (IOException e) {
            problem.accept(Problem.of("window.unknown", String.valueOf(e.getMessage())));
        }
        if (first) file.save(settings);
    }

    private static Texts texts(LabFrame frame) {
        return Texts.of("shell", frame == null ? Language.ENGLISH : frame.language());
    }
}
