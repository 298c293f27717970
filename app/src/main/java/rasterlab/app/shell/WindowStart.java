package rasterlab.app.shell;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
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
        EventQueue.invokeLater(() -> open(settings, file, place, problems));
        // Saved at once too: whoever cannot write it learns so now, not when the window is gone.
        file.save(settings);
        hold(place, problems);
        LabModels.prepare();
    }

    private static void open(
            LabSettings settings, SettingsFile file, Path place, Problems problems) {
        var shown = new LabFrame[1];
        var reports =
                new FailureReports(
                        failure -> new ErrorDialog(texts(shown[0])).show(shown[0], failure));
        Thread.setDefaultUncaughtExceptionHandler(reports);
        LabModels models = LabModels.first(reports);
        LabsFile labsFile = LabsFile.beside(place, problems);
        labsFile.load(models);
        shown[0] = new LabFrame(models, settings, file, labsFile, reports);
        shown[0].setVisible(true);
        problems.showIn(shown[0]);
    }

    private static void hold(Path place, Problems problems) {
        try {
            OneWindow.hold(place, problems);
        } catch (IOException e) {
            problems.accept(Problem.of("window.unknown", String.valueOf(e.getMessage())));
        }
    }

    private static Texts texts(LabFrame frame) {
        return Texts.of("shell", frame == null ? Language.ENGLISH : frame.language());
    }
}
